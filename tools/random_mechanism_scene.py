#!/usr/bin/env python3
"""Writes a random mechanism as a scene for `rigor run`: 3 to 8 bodies in a tree of joints, some of its loops closed, over a floor.

Hinges, balls, sliders, universal, cylindrical, fixed, screw and distance joints, with limits, springs, dampers, dry friction and
motors; a third of the mechanisms hang from the world, the others fall. All touch the floor or each other within 3 s.

    tools/random_mechanism_scene.py SEED > mechanism.yaml
"""
import math
import random
import sys

CELL = 0.6  # Distance of neighbours [m]; bodies are smaller.
SIDES = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
IN_TREES = ["hinge"] * 4 + ["ball"] * 3 + ["slider", "universal", "cylindrical", "fixed", "screw", "distance"]
IN_LOOPS = ["ball", "distance", "point_on_line", "hinge"]


def vector(values, digits=6):
    return "[" + ", ".join(f"{value:.{digits}f}" for value in values) + "]"


def unit(draw):
    v = [draw.gauss(0, 1) for _ in range(3)]
    length = math.sqrt(sum(a * a for a in v))
    return [a / length for a in v]


def across(draw, axis):
    """A unit vector perpendicular to this one."""
    a = unit(draw)
    x, y, z = axis
    v = [y * a[2] - z * a[1], z * a[0] - x * a[2], x * a[1] - y * a[0]]
    length = math.sqrt(sum(b * b for b in v))
    return [b / length for b in v]


def laws(draw, is_angle):
    """Limits, spring, damper, friction and motor of a coordinate, as parts of its mapping."""
    parts = []
    if draw.random() < 0.35:
        far = (lambda: draw.uniform(0.2, 2)) if is_angle else (lambda: draw.uniform(0.02, 0.2))
        parts.append(f"limits: [{-far():.4f}, {far():.4f}]")
        parts.append(f"restitution: {draw.choice([0, 0, 0.4])}")
    if draw.random() < 0.2:
        parts.append(f"stiffness: {10 ** draw.uniform(0, 3):.4g}")
    if draw.random() < 0.3:
        parts.append(f"damping: {10 ** draw.uniform(-2, 1):.4g}")
    if draw.random() < 0.2:
        parts.append(f"friction: {10 ** draw.uniform(-1, 1):.4g}")
    if draw.random() < 0.25:
        speed = draw.uniform(-6, 6) if is_angle else draw.uniform(-0.5, 0.5)
        parts.append(f"motor: {{velocity: {speed:.4f}, max_force: {10 ** draw.uniform(0, 2):.4g}}}")
    return parts


def joint(draw, name, kind, first, second, p, q):
    """Between bodies (or the world) of these names, at these places."""
    words = [f"name: {name}", f"type: {kind}", f"bodies: [{first}, {second}]"]
    middle = [(a + b) / 2 for a, b in zip(p, q)]
    axis = unit(draw)
    if kind == "distance":
        words.append(f"anchors: [{vector(p)}, {vector(q)}]")
    else:
        words.append(f"anchor: {vector(middle)}")
    if kind not in ("distance", "ball", "fixed"):
        words.append(f"axis: {vector(axis, 9)}")
    if kind == "universal":
        words.append(f"second_axis: {vector(across(draw, axis), 9)}")
        words.append("coordinates: [" + ", ".join("{" + ", ".join(laws(draw, True)) + "}" for _ in range(2)) + "]")
    elif kind == "cylindrical":
        words.append("coordinates: [{" + ", ".join(laws(draw, False)) + "}, {" + ", ".join(laws(draw, True)) + "}]")
    elif kind in ("hinge", "slider"):
        words += laws(draw, kind == "hinge")
    elif kind == "screw":
        words.append(f"pitch: {draw.uniform(0.05, 0.5):.4f}")
    elif kind == "ball" and draw.random() < 0.3:
        words.append(f"limits: [0, {draw.uniform(0.3, 1.5):.4f}]")
    return "  - {" + ", ".join(words) + "}"


def body(draw, name, place):
    kind = draw.choice(["box", "box", "sphere", "capsule"])
    if kind == "box":
        shape = f"type: box, size: {vector([2 * draw.uniform(.04, .13) for _ in range(3)], 4)}"
    elif kind == "sphere":
        shape = f"type: sphere, radius: {draw.uniform(.06, .2):.4f}"
    else:
        shape = f"type: capsule, radius: {draw.uniform(.03, .08):.4f}, length: {draw.uniform(.1, .3):.4f}"
    return (f"  - {{name: {name}, density: {10 ** draw.uniform(2.3, 3.7):.1f}, position: {vector(place)}, "
            f"axis_angle: {{axis: {vector(unit(draw), 9)}, angle: {draw.uniform(0, 3):.6f}}}, shapes: [{{{shape}, material: rough}}]}}")


def mechanism(seed):
    draw = random.Random(7000 + seed)

    # A walk over cells: each body beside one before it.
    cells, pairs = [(0, 0, 0)], []
    for k in range(1, draw.randint(3, 8)):
        free = [(i, tuple(a + b for a, b in zip(cell, side))) for i, cell in enumerate(cells) for side in SIDES]
        before, cell = draw.choice([(i, cell) for i, cell in free if cell not in cells])
        pairs.append((before, k))
        cells.append(cell)
    lowest = min(cell[2] for cell in cells)
    places = [(CELL * x, CELL * y, CELL * (z - lowest) + 0.45) for x, y, z in cells]

    # The tree, what closes loops, and what holds it to the world.
    joints = [joint(draw, f"t{b}", draw.choice(IN_TREES), f"b{a}", f"b{b}", places[a], places[b]) for a, b in pairs]
    others = [(a, b) for b in range(len(cells)) for a in range(b)
              if (a, b) not in pairs and sum(abs(x - y) for x, y in zip(cells[a], cells[b])) == 1]
    loops = draw.sample(others, min(len(others), draw.choice([0, 1, 2])))
    joints += [joint(draw, f"l{k}", draw.choice(IN_LOOPS), f"b{a}", f"b{b}", places[a], places[b]) for k, (a, b) in enumerate(loops)]
    if draw.random() < 1 / 3:
        above = [places[0][0], places[0][1], places[0][2] + CELL]
        joints.append(joint(draw, "hook", draw.choice(["hinge", "ball", "slider"]), "world", "b0", above, places[0]))

    lines = ["rigor: 1", f"name: mechanism-{seed}", "world: {gravity: [0, 0, -9.81]}",
             "run: {duration: 3, step: 0.01, output_interval: 0.05}",
             "materials:", f"  - {{name: rough, friction: {draw.choice([0, 0.3, 0.6])}, restitution: {draw.choice([0, 0, 0.3])}}}", "bodies:",
             "  - {name: floor, motion: static, shapes: [{type: plane, material: rough}]}"]
    return "\n".join(lines + [body(draw, f"b{k}", place) for k, place in enumerate(places)] + ["joints:"] + joints) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.stdout.write(mechanism(int(sys.argv[1])))
