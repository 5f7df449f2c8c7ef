#!/usr/bin/env python3
"""Runs random scenes of stiff springs, dampers and drag, huge forces and motors without a bound, and counts how they end.

Every number goes over many orders of magnitude: stiffness, damping and drag to 1e15, forces and torques to 1e15, motors to 1e8, masses
1e-6 to 1e6 kg, sizes 1 cm to 1 m. A run has to end by itself within the limit of processor time: with an audit that passed, or with a
line that says what stopped it. Each number of a study with its seed is the same case for all schemes, on any machine.

usage: tools/stiff_study.py [--program RIGOR] [--jobs N] [--scenes N] [--seed K] [--schemes a,b] [--families a,b] [--cpu-limit S]
                            [--keep FOLDER]
exit code: 0 if every run ended in time, finite and by its own promises, else 1
"""
import csv
import math
import pathlib
import random
import sys
import tempfile

from measured_runs import METHODS, Runs, numbers, study_parser

ENDS = ["ok", "stopped", "refused", "audit failed", "slow", "wrong"]


def arguments():
    parser = study_parser(__doc__, "auto,event-driven,hybrid,time-stepping,substep")
    parser.add_argument("--scenes", type=int, default=30, help="for each scheme and family")
    parser.add_argument("--families", default=",".join(FAMILIES), type=lambda names: names.split(","), help="names with commas")
    return parser.parse_args()


def power(draw, low, high):
    return f"{10 ** draw.uniform(low, high):.6g}"


def body(draw, name, x, size, extra=""):
    """A body that a ball of radius `size` [m] holds, at (x, 0, 3)."""
    shape = draw.choice([f"type: sphere, radius: {size:.6g}", f"type: box, size: {numbers([size * draw.uniform(0.3, 1.1) for _ in range(3)])}",
                         f"type: capsule, radius: {0.4 * size:.6g}, length: {1.2 * size:.6g}"])
    velocity = numbers([draw.choice([0, 0, 1, -3]) * draw.random() for _ in range(3)])
    return f"  - {{name: {name}, position: [{x:.9g}, 0, 3], mass: {power(draw, -6, 6)}, velocity: {velocity}{extra}, shapes: [{{{shape}}}]}}"


def law(draw):
    """A spring with or without a damper, or a damper alone."""
    stiff, damped = f"stiffness: {power(draw, 0, 15)}", f"damping: {power(draw, -2, 15)}"
    return draw.choice([stiff, f"{stiff}, {damped}", f"{stiff}, {damped}", damped])


def springs(draw, size):
    """Point springs to the world or between bodies."""
    count = draw.randint(1, 3)
    bodies = [body(draw, f"b{i}", 3 * size * i, size) for i in range(count)]
    lines = []
    for i in range(count):
        other, point = ("world", [3 * size * i, 0, 3 + 2 * size]) if i == 0 or draw.random() < 0.3 else (f"b{i - 1}", [0, 0, 0])
        arm = [draw.choice([0, 0.5]) * size for _ in range(3)]
        stretch = draw.choice([0.5, 0.99, 1, 1.5])
        here = [3 * size * i + arm[0], arm[1], 3 + arm[2]]
        there = point if other == "world" else [3 * size * (i - 1), 0, 3]
        length = math.dist(here, there) * stretch
        lines.append(f"  - {{type: spring, between: [{other}, b{i}], points: [{numbers(point)}, {numbers(arm)}], {law(draw)}, length: {length:.9g}}}")
    return bodies, ["forces:"] + lines


def joints(draw, size):
    """A chain of distance joints, sliders and hinges with springs and dampers, some with limits."""
    count = draw.randint(1, 3)
    bodies, lines = [], ["joints:"]
    for i in range(count):
        bodies.append(body(draw, f"b{i}", 3 * size * i, size))
        before = "world" if i == 0 else f"b{i - 1}"
        kind = draw.choice(["distance", "slider", "hinge"])
        if kind == "distance":
            place = f"anchors: [[{3 * size * (i - 1):.9g}, 0, 3], [{3 * size * i:.9g}, 0, 3]], limits: [{2 * size:.9g}, {5 * size:.9g}]"
        else:
            limits = ", limits: [-0.5, 0.5]" if draw.random() < 0.5 else ""
            place = f"anchor: [{3 * size * (i - draw.choice([0, 0.5, 1])):.9g}, 0, 3], axis: {draw.choice(['[1, 0, 0]', '[0, 1, 0]', '[0, 0, 1]'])}{limits}"
        lines.append(f"  - {{name: j{i}, type: {kind}, bodies: [{before}, b{i}], {place}, {law(draw)}}}")
    return bodies, lines


def drag(draw, size):
    """Bodies in something thick."""
    drags = [f"linear_drag: {power(draw, -2, 15)}", f"angular_drag: {power(draw, -2, 15)}", f"linear_damping: {power(draw, -2, 12)}",
             f"angular_damping: {power(draw, -2, 12)}"]
    count = draw.randint(1, 3)
    return [body(draw, f"b{i}", 3 * size * i, size, ", " + ", ".join(draw.sample(drags, draw.randint(1, 3))) +
                 f", angular_velocity: {numbers([draw.uniform(-9, 9) for _ in range(3)])}") for i in range(count)], []


def forces(draw, size):
    """Forces with a lever, and torques."""
    lines = ["forces:"]
    if draw.random() < 0.7:
        frame = draw.choice(["", ", frame: body"])
        lines.append(f"  - {{type: constant, body: b0, force: [{power(draw, 0, 15)}, 0, 0], point: [0, 0, {0.5 * size:.6g}]{frame}}}")
    if len(lines) == 1 or draw.random() < 0.5:
        lines.append(f"  - {{type: torque, body: b0, torque: [0, {power(draw, 0, 15)}, 0]}}")
    return [body(draw, "b0", 0, size)], lines


def motors(draw, size):
    """Motors, most without a bound, alone, against a limit, or in a loop that does not let them turn."""
    kind = draw.choice(["hinge", "hinge", "slider"])
    limits = f", limits: [-{power(draw, -3, 0)}, {power(draw, -3, 0)}]" if draw.random() < 0.5 else ""
    bound = f", max_force: {power(draw, -2, 15)}" if draw.random() < 0.3 else ""
    lines = ["joints:", f"  - {{name: drive, type: {kind}, bodies: [world, b0], anchor: [{-2 * size:.6g}, 0, 3], axis: [0, 1, 0]{limits}, "
             f"motor: {{velocity: {draw.choice(['', '-'])}{power(draw, -2, 8)}{bound}}}}}"]
    bodies = [body(draw, "b0", 0, size)]
    if draw.random() < 0.4:
        # A second joint closes a loop: a rod that holds it, or an arm with a crank.
        bodies.append(body(draw, "b1", 3 * size, size))
        lines.append(f"  - {{name: rod, type: hinge, bodies: [b0, b1], anchor: [{1.5 * size:.6g}, 0, 3], axis: [0, 1, 0]}}")
        lines.append(f"  - {{name: hold, type: hinge, bodies: [world, b1], anchor: [{draw.choice([4.5, 3, 6]) * size:.6g}, 0, 3], axis: [0, 1, 0]}}")
    return bodies, lines


FAMILIES = {"springs": springs, "joints": joints, "drag": drag, "forces": forces, "motors": motors}


def scene(family, number):
    draw = random.Random(f"{family} {number}")
    size = 10 ** draw.uniform(-2, 0)
    step, duration = draw.choice([1 / 60, 0.005, 0.001]), draw.choice([0.1, 0.5])
    bodies, lines = FAMILIES[family](draw, size)
    floor = ["  - {name: floor, motion: static, shapes: [{type: plane}]}"] if draw.random() < 0.5 else []
    return "\n".join(["rigor: 1", f"run: {{duration: {duration}, step: {step:.9g}, output_interval: 0.02}}",
                      "materials: [{name: default, friction: 0.5, restitution: 0}]", "bodies:"] + floor + bodies + lines) + "\n"


def rows_are_finite(table):
    if not table.exists():
        return True
    with table.open(newline="") as file:
        rows = csv.reader(file)
        names = next(rows, [])
        return all(len(row) == len(names) and all(math.isfinite(float(value)) for name, value in zip(names, row) if name.endswith("]"))
                   for row in rows)


def run_case(options, runs, folder, work):
    scheme, family, number = work
    path = folder / f"{scheme}-{family}-{number}.yaml"
    table = path.with_suffix(".csv")
    path.write_text(f"method: {METHODS[scheme]}\n" + scene(family, number))
    done = runs.call([options.program, "run", path, "-o", table], options.cpu_limit)
    end = {0: "ok", 1: "audit failed", 3: "refused", 4: "stopped", 130: "slow", -24: "slow", 152: "slow"}.get(done.returncode, "wrong")
    if end in ("ok", "stopped", "audit failed") and not rows_are_finite(table):
        end = "wrong"
    if "broken promise" in done.stderr:
        end = "wrong"
    why = done.stderr.strip().split("\n")[0][:250]
    if options.keep and end != "ok":
        (options.keep / path.name).write_text(path.read_text())
    for each in (path, table):
        each.unlink(missing_ok=True)
    return end, why


def main():
    options = arguments()
    runs = Runs(options.jobs)
    counts = {(scheme, family): dict.fromkeys(ENDS, 0) for scheme in options.schemes for family in options.families}
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        work = [(scheme, family, options.seed + k) for scheme in options.schemes for family in options.families for k in range(options.scenes)]
        for item, (end, why) in runs.results(lambda item: run_case(options, runs, pathlib.Path(temporary), item), work):
            counts[item[:2]][end] += 1
            if end != "ok":
                print(f"{item[0]} {item[1]} {item[2]}: {end}: {why}", flush=True)
    print(f"{'scheme':14} {'family':8} " + " ".join(f"{end:>12}" for end in ENDS))
    for (scheme, family), of_cell in counts.items():
        print(f"{scheme:14} {family:8} " + " ".join(f"{of_cell[end]:12}" for end in ENDS))
    return 1 if any(of_cell[end] for of_cell in counts.values() for end in ("audit failed", "slow", "wrong")) else 0


if __name__ == "__main__":
    sys.exit(main())
