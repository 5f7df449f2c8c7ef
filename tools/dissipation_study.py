#!/usr/bin/env python3
"""Runs random scenes that can only lose energy, and tells by what part of the energy that there is it rises.

Heaps, stacks of boxes, columns of cylinders (half of them hit by a ball), crowds that are thrown at each other, and crowds in joints: 2 to
30 bodies of 1 cm to 1 m, all convex shapes, gravity 0 to 50 m/s², steps of 2 ms to 1/60 s, mass ratios to 1e6, friction 0 to 1.2,
restitution 0 to 0.8. Nothing drives them. What there is is the energy at the beginning, heights counted from the floor; the bars are
1e-9 (event-driven, hybrid, impulse-based), 1e-6 (time stepping) and 1e-4 (substep, penalty) of it. A run that its limit of processor time ends is judged
until there. Each number of a study with its seed is the same case for all schemes, on any machine.

usage: tools/dissipation_study.py [--program RIGOR] [--jobs N] [--scenes N] [--seed K] [--schemes a,b] [--families a,b] [--cpu-limit S]
                                  [--duration S] [--keep FOLDER]
exit code: 0 if no energy rose above the bar of its scheme and every run had an audit, else 1
"""
import json
import math
import pathlib
import random
import sys
import tempfile

from measured_runs import METHODS, Runs, numbers, study_parser

BARS = {"event-driven": 1e-9, "hybrid": 1e-9, "impulse-based": 1e-9, "time-stepping": 1e-6, "substep": 1e-4, "penalty": 1e-4}
FAMILIES = ["heap", "stack", "column", "thrown", "joints"]
SHAPES = ["sphere", "box", "cylinder", "cone", "capsule", "ellipsoid", "convex"]
ENDS = ["held", "rises", "audit failed", "ended early", "no audit"]


def arguments():
    parser = study_parser(__doc__, "event-driven,time-stepping,substep")
    parser.add_argument("--scenes", type=int, default=200, help="for each scheme")
    parser.add_argument("--families", default=",".join(FAMILIES[:4]), type=lambda names: names.split(","), help="names with commas")
    parser.add_argument("--duration", type=float, default=2, help="simulated time of a scene [s]")
    parser.add_argument("--audits", action="store_true", help="fail where an audit fails, too")
    return parser.parse_args()


def direction(draw):
    vector = [draw.gauss(0, 1) for _ in range(3)]
    length = math.sqrt(sum(x * x for x in vector))
    return [x / length for x in vector]


def shape_of(draw, size):
    """The YAML of a shape that a ball of radius `size` [m] holds."""
    kind = draw.choice(SHAPES)
    share = lambda low: draw.uniform(low, 1) * size / math.sqrt(3)
    if kind == "sphere":
        return f"type: sphere, radius: {size:.9g}"
    if kind == "box":
        return f"type: box, size: {numbers([2 * share(0.3) for _ in range(3)])}"
    if kind in ("cylinder", "cone"):
        return f"type: {kind}, radius: {share(0.3):.9g}, length: {2 * share(0.3):.9g}"
    if kind == "capsule":
        radius = share(0.3)
        return f"type: capsule, radius: {radius:.9g}, length: {2 * (size - radius) * draw.uniform(0.1, 1):.9g}"
    if kind == "ellipsoid":
        return f"type: ellipsoid, radii: {numbers([share(0.4) for _ in range(3)])}"
    points = [[x * size * draw.uniform(0.5, 1) for x in direction(draw)] for _ in range(draw.randint(4, 20))]
    points += [[0.3 * size * x for x in corner] for corner in ((1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1))]
    return f"type: convex, vertices: [{', '.join(map(numbers, points))}]"


def body(name, density, position, shape, more=""):
    return f"  - {{name: {name}, density: {density():.6g}, position: {numbers(position)}{more}, shapes: [{{{shape}}}]}}"


def stack(draw, density, scale):
    lines, top, width = [], 0, scale * draw.uniform(0.3, 1)
    for k in range(draw.randint(2, 20)):
        height = scale * draw.uniform(0.2, 1)
        place = [draw.uniform(-0.1, 0.1) * width, draw.uniform(-0.1, 0.1) * width, top + height / 2]
        lines.append(body(f"b{k}", density, place, f"type: box, size: {numbers([width, width * draw.uniform(0.6, 1), height])}"))
        top += height
    return lines


def column(draw, density, scale):
    lines, top, radius = [], 0, scale * draw.uniform(0.3, 1)
    for k in range(draw.randint(2, 12)):
        height = scale * draw.uniform(0.3, 1)
        place = [draw.uniform(-0.05, 0.05) * radius, draw.uniform(-0.05, 0.05) * radius, top + height / 2]
        lines.append(body(f"b{k}", density, place, f"type: cylinder, radius: {radius:.6g}, length: {height:.9g}"))
        top += height
    if draw.random() < 0.5:
        size = scale * draw.uniform(0.3, 1)
        lines.append(body("ball", density, [-4 * scale, 0, size + top * draw.random()], f"type: sphere, radius: {size:.6g}",
                          f", velocity: {numbers([10 * draw.random(), 0, 0])}"))
    return lines


def crowd(draw, density, scale, family):
    """Bodies on a grid above the floor, some in joints."""
    count, side_of = draw.randint(2, 30), lambda n: max(1, round(n ** (1 / 3)))
    side = side_of(count)
    places = [[(k % side) * 1.1 * scale, (k // side % side) * 1.1 * scale, (0.6 + (k // side**2) * 1.1) * scale] for k in range(count)]
    speed, spin = (draw.choice([0, 1, 5]), draw.choice([0, 5, 20])) if family != "thrown" else (draw.choice([2, 10]), draw.choice([5, 50]))
    lines = []
    for k, place in enumerate(places):
        moves = (f", rpy: {numbers([draw.uniform(-3, 3) for _ in range(3)])}, velocity: {numbers([speed * draw.uniform(-1, 1) for _ in range(3)])}"
                 f", angular_velocity: {numbers([spin * draw.uniform(-1, 1) for _ in range(3)])}")
        lines.append(body(f"b{k}", density, place, shape_of(draw, scale * draw.uniform(0.3, 1) / 2), moves))
    if family != "joints":
        return lines
    lines.append("joints:")
    for k in range(count - 1):
        kind = draw.choice(["hinge", "ball", "fixed", "slider"]) if k == 0 or draw.random() < 0.5 else None
        keys = {"hinge": f", anchor: {numbers(places[k])}, axis: {numbers(direction(draw))}", "ball": f", anchor: {numbers(places[k])}",
                "fixed": "", "slider": f", axis: {numbers(direction(draw))}"}
        if kind:
            lines.append(f"  - {{name: j{k}, type: {kind}, bodies: [b{k}, b{k + 1}]{keys[kind]}}}")
    return lines


def case(number, families, duration):
    """Name and lines of a scene."""
    draw = random.Random(f"dissipation {number}")
    family = draw.choice(families)
    gravity = draw.choice([9.81, 9.81, 1.6, 50] if family in ("stack", "column") else [9.81, 9.81, 9.81, 0, 1.6, 50])
    step, decades = draw.choice([1 / 60, 0.01, 0.004, 0.002]), draw.choice([0, 0, 1, 3, 6])
    friction, restitution = draw.choice([0, 0.3, 0.5, 0.8, 1.2]), draw.choice([0, 0, 0, 0.3, 0.8])
    density = lambda: 10 ** draw.uniform(3 - decades / 2, 3 + decades / 2)
    scale = 10 ** draw.uniform(-2, 0)
    floor = draw.choice(["shapes: [{type: plane}]", "position: [0, 0, -0.5], shapes: [{type: box, size: [40, 40, 1]}]"])
    lines = ["rigor: 1", f"world: {{gravity: [0, 0, {-gravity}]}}",
             f"run: {{duration: {duration:.9g}, step: {step:.9g}, output_interval: {step:.9g}}}",
             f"materials: [{{name: default, friction: {friction}, restitution: {restitution}}}]", "bodies:",
             f"  - {{name: floor, motion: static, {floor}}}"]
    lines += {"stack": stack, "column": column}[family](draw, density, scale) if family in ("stack", "column") else crowd(draw, density, scale, family)
    return f"{family}, {scale:.2g} m, {gravity} m/s², step {step:.3g} s, ratio 1e{decades}, friction {friction}, e {restitution}", lines


def run_case(options, runs, folder, work):
    scheme, number = work
    name, lines = case(number, options.families, options.duration)
    path = folder / f"{scheme}-{number}.yaml"
    path.write_text("\n".join([f"method: {METHODS[scheme]}"] + lines) + "\n")
    done = runs.call([options.program, "run", path, "--quiet", "--separate", "--json", "-", "--cpu-limit", options.cpu_limit], 3 * options.cpu_limit)
    try:
        audit = json.loads(done.stdout)
        energy = audit["energy"]
        share = energy["max_increase"] / max(energy["initial"], sys.float_info.min)
        end = "held" if share <= BARS[scheme] else "rises"
        if end == "held" and done.returncode == 1:
            end = "audit failed"
        elif end == "held" and not audit["complete"]:
            end = "ended early"
    except (ValueError, KeyError, TypeError):
        audit, share, end = {}, math.nan, "no audit"
    broken = [text.removeprefix("violated: ") for text in audit.get("warnings", []) if text.startswith("violated: ")]
    if options.keep and end != "held":
        (options.keep / path.name).write_text(path.read_text())
    path.unlink()
    return end, share, f"{name}: {'; '.join(broken) or done.stderr.strip()[:200]}"


def main():
    options = arguments()
    runs = Runs(options.jobs)
    counts = {scheme: dict.fromkeys(ENDS, 0) for scheme in options.schemes}
    largest = dict.fromkeys(options.schemes, 0)
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        work = [(scheme, options.seed + k) for scheme in options.schemes for k in range(options.scenes)]
        for (scheme, number), (end, share, why) in runs.results(lambda item: run_case(options, runs, pathlib.Path(temporary), item), work):
            counts[scheme][end] += 1
            largest[scheme] = max(largest[scheme], share) if share == share else largest[scheme]
            if end != "held":
                print(f"{scheme} {number}: {end}: {share:.2g}: {why}", flush=True)
    print(f"{'scheme':14} {'bar':>6} {'largest':>8} " + " ".join(f"{end:>12}" for end in ENDS))
    for scheme, of_scheme in counts.items():
        print(f"{scheme:14} {BARS[scheme]:6.0e} {largest[scheme]:8.1e} " + " ".join(f"{of_scheme[end]:12}" for end in ENDS))
    wrong = ["rises", "no audit"] + (["audit failed"] if options.audits else [])
    return 1 if any(of_scheme[end] for of_scheme in counts.values() for end in wrong) else 0


if __name__ == "__main__":
    sys.exit(main())
