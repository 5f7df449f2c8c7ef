#!/usr/bin/env python3
"""Writes a random jointed scene for `rigor run` whose numbers are valid and mean: limits, dampers and springs up to 1e12,
masses that differ by up to 1e12, motors, dry friction, drag, starts at a limit.

    tools/hostile_joints.py SEED > scene.yaml
"""
import random
import sys

TYPES = ["distance", "slider", "hinge", "ball", "universal", "cylindrical", "screw", "fixed"]
COORDINATES = {"distance": 1, "slider": 1, "hinge": 1, "ball": 1, "universal": 2, "cylindrical": 2, "screw": 1, "fixed": 0}
SCHEMES = ["event-driven", "time-stepping", "impulse-based", "hybrid", "penalty"]


def power(draw, low, high):
    return f"{10 ** draw.uniform(low, high):.3g}"


def laws(draw, kind, k):
    """The limits, spring, damper, friction and motor of a coordinate, as parts of its mapping."""
    is_length = kind in ("slider", "distance") or (kind == "cylindrical" and k == 0)
    start = 0.3 if kind == "distance" else 0
    parts = []
    if kind == "distance" or kind != "ball" and draw.random() < 0.6:
        low = start - draw.choice([0, 1e-9, 1e-3, 0.1])
        high = start + draw.choice([0, 1e-9, 1e-3, 0.2]) + (1e-9 if low == start else 0)
        parts.append(f"limits: [{low!r}, {high!r}]" if is_length else f"limits: [{low:.12g}, {high:.12g}]")
        if draw.random() < 0.3:
            parts.append(f"restitution: {draw.choice([0.5, 1])}")
    if draw.random() < 0.6:
        parts.append(f"stiffness: {power(draw, -2, 12)}")
    if draw.random() < 0.6:
        parts.append(f"damping: {power(draw, -2, 12)}")
    if kind != "ball" and draw.random() < 0.2:
        parts.append(f"friction: {power(draw, -3, 9)}")
    if kind != "ball" and draw.random() < 0.2:
        bound = f", max_force: {power(draw, -3, 12)}" if draw.random() < 0.7 else ""
        parts.append(f"motor: {{velocity: {draw.choice(['-', ''])}{power(draw, -3, 6)}{bound}}}")
    return parts


def joint(draw, i):
    kind = draw.choice(TYPES)
    before = "world" if i == 0 or draw.random() < 0.2 else f"b{i - 1}"
    words = [f"name: j{i}", f"type: {kind}", f"bodies: [{before}, b{i}]"]
    if kind == "distance":
        # 0.3 m apart, wherever the body before it stands.
        words.append(f"anchors: [[{0.3 * (i - 1):.3g}, 0, 3], [{0.3 * i:.3g}, 0, 3]]")
    else:
        words.append(f"anchor: [{0.3 * i - draw.choice([0, 0.15, 1]):.3g}, 0, 3]")
    if kind in ("slider", "hinge", "cylindrical", "screw", "universal"):
        words.append(f"axis: {draw.choice(['[1, 0, 0]', '[0, 1, 0]', '[0, 0, 1]'])}")
    if kind == "universal":
        words.append("second_axis: " + ("[0, 0, 1]" if "[0, 1, 0]" in words[-1] else "[0, 1, 0]"))
    if kind == "screw":
        words.append(f"pitch: {power(draw, -4, 0)}")
    if COORDINATES[kind] == 1:
        words += laws(draw, kind, 0)
    elif COORDINATES[kind] > 1:
        words.append("coordinates: [" + ", ".join("{" + ", ".join(laws(draw, kind, k)) + "}" for k in range(COORDINATES[kind])) + "]")
    return "  - {" + ", ".join(words) + "}"


def scene(seed):
    draw = random.Random(seed)
    count = draw.randint(1, 4)
    bodies = []
    for i in range(count):
        shape = draw.choice(["type: sphere, radius: 0.1", "type: box, size: [0.2, 0.1, 0.15]", "type: capsule, radius: 0.05, length: 0.1"])
        drag = f", linear_drag: {power(draw, -2, 15)}, angular_drag: {power(draw, -2, 15)}" if draw.random() < 0.15 else ""
        bodies.append(f"  - {{name: b{i}, position: [{0.3 * i:.3g}, 0, 3], mass: {power(draw, -6, 6)}, "
                      f"velocity: [0, 0, {draw.choice([0, 0, 1, -100])}]{drag}, shapes: [{{{shape}}}]}}")
    lines = ["rigor: 1", f"method: {{scheme: {draw.choice(SCHEMES)}}}",
             f"run: {{duration: {draw.choice([0.05, 0.1])}, step: {draw.choice([0.01, 0.001])}, output_interval: 0.01}}", "bodies:"]
    if draw.random() < 0.5:
        lines.append("  - {name: floor, motion: static, shapes: [{type: plane}]}")
    return "\n".join(lines + bodies + ["joints:"] + [joint(draw, i) for i in range(count)]) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.stdout.write(scene(int(sys.argv[1])))
