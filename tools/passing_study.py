#!/usr/bin/env python3
"""Throws random bodies at thin plates and swings thin blades at resting bodies, and counts what got through.

Each body is a scene of its own: a plate of 1 to 3 mm (a box, a mesh of 12 triangles or a height field, level or tilted) and a body of
any shape above it, 1 mm to 10 cm large, with 30 to 3,000 m/s and up to 1,000 rad/s an axis; or a blade that turns or flies at a
body at rest, without gravity. Steps are 1/60 s to 1e-3 s, restitution is 0 to 1. The truth is not asked of the engine: the plate is far
wider than the body can fly, so an inner point of the body below it came through it; and a body that a blade swept over without moving it
was passed. Each number of a study with its seed is the same case for all schemes, on any machine.

usage: tools/passing_study.py [--program RIGOR] [--jobs N] [--bodies N] [--seed K] [--schemes a,b] [--cpu-limit S] [--keep FOLDER]
exit code: 0 if nothing passed and every audit that said "passed" was right, else 1
"""
import csv
import math
import pathlib
import random
import sys
import tempfile

from measured_runs import METHODS, Runs, numbers, study_parser

SHAPES = ["sphere", "box", "cylinder", "cone", "capsule", "ellipsoid", "convex", "revolution", "mesh", "slab"]
ENDS = ["ok", "audit failed", "stopped", "slow", "through", "through, audit passed"]


def arguments():
    parser = study_parser(__doc__, "event-driven,hybrid,time-stepping,substep")
    parser.add_argument("--bodies", type=int, default=200, help="for each scheme")
    return parser.parse_args()


def direction(draw):
    vector = [draw.gauss(0, 1) for _ in range(3)]
    length = math.sqrt(sum(x * x for x in vector))
    return [x / length for x in vector]


def write_prism(path, outline):
    """A closed mesh: a plane outline, counter-clockwise, between z = -1 and z = 1, cut into a fan from its first point."""
    n = len(outline)
    lines = [f"v {x:.9g} {y:.9g} {z}" for z in (-1, 1) for x, y in outline]
    for k in range(1, n - 1):
        lines += [f"f 1 {k + 2} {k + 1}", f"f {n + 1} {n + k + 1} {n + k + 2}"]
    for k in range(n):
        a, b = k + 1, (k + 1) % n + 1
        lines += [f"f {a} {b} {n + b}", f"f {a} {n + b} {n + a}"]
    path.write_text("\n".join(lines) + "\n")


# An L whose fan from the inner corner covers it, and a box.
OUTLINES = {"ell.obj": [(0, 0), (0, 1), (-1, 1), (-1, -1), (1, -1), (1, 0)], "slab.obj": [(-1, -1), (1, -1), (1, 1), (-1, 1)]}


def shape_of(draw, kind, size):
    """The YAML of a shape that a ball of radius `size` [m] holds."""
    share = lambda low: draw.uniform(low, 1) * size / math.sqrt(3)
    if kind == "sphere":
        return f"type: sphere, radius: {size:.9g}"
    if kind == "box":
        return f"type: box, size: {numbers([2 * share(0.1) for _ in range(3)])}"
    if kind == "slab":
        return f"type: box, size: {numbers([2 * share(0.5), 2 * share(0.1), max(0.002, 0.02 * size)])}"
    if kind in ("cylinder", "cone"):
        return f"type: {kind}, radius: {share(0.2):.9g}, length: {2 * share(0.1):.9g}"
    if kind == "capsule":
        radius = share(0.1)
        return f"type: capsule, radius: {radius:.9g}, length: {2 * (size - radius) * draw.uniform(0.1, 1):.9g}"
    if kind == "ellipsoid":
        return f"type: ellipsoid, radii: {numbers([share(0.1) for _ in range(3)])}"
    if kind == "convex":
        points = [[x * size * draw.uniform(0.5, 1) for x in direction(draw)] for _ in range(draw.randint(1, 30))]
        # Whatever the points are, the frame's origin, which the output places, is inside.
        points += [[0.3 * size * x for x in corner] for corner in ((1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1))]
        return f"type: convex, vertices: [{', '.join(map(numbers, points))}]"
    if kind == "revolution":
        angles = sorted([0.2, math.pi - 0.2] + [draw.uniform(0.3, math.pi - 0.3) for _ in range(draw.randint(1, 5))])
        return f"type: revolution, profile: [{', '.join(numbers([size * math.sin(a), size * math.cos(a)]) for a in angles)}]"
    return f"type: mesh, file: {draw.choice(list(OUTLINES))}, scale: {numbers([share(0.2) for _ in range(3)])}"


def plate_of(draw, half_width, thickness):
    kind = draw.choice(["box", "mesh", "heightfield"])
    if kind == "box":
        return f"type: box, size: {numbers([2 * half_width, 2 * half_width, thickness])}"
    if kind == "mesh":
        return f"type: mesh, file: slab.obj, scale: {numbers([half_width, half_width, thickness / 2])}"
    cells = draw.randint(1, 8)
    rows = ", ".join("[" + ", ".join(f"{thickness / 2:.9g}" for _ in range(cells + 1)) + "]" for _ in range(cells + 1))
    return f"type: heightfield, heights: [{rows}], base: {thickness:.9g}, size: {numbers([2 * half_width, 2 * half_width])}"


def head(draw, step, duration, gravity):
    return [f"rigor: 1\nworld: {{gravity: [0, 0, {gravity}]}}",
            f"run: {{duration: {duration:.9g}, step: {step:.9g}, output_interval: {step:.9g}}}",
            f"materials: [{{name: default, density: {10 ** draw.uniform(2.5, 4):.6g}, friction: {draw.choice([0, 0.3, 0.8])},"
            f" restitution: {draw.choice([0, 0, 0.5, 1])}}}]", "bodies:"]


def shot(draw, step):
    """A body flies at a plate. Whatever is below the plate came through it."""
    size = 10 ** draw.uniform(-3, -1) / 2 if draw.random() < 0.3 else draw.uniform(0.01, 0.05)
    speed = 10 ** draw.uniform(math.log10(30), math.log10(3000))
    thickness = draw.choice([0.001, 0.002, 0.002, 0.003])
    down = draw.uniform(0.3, 1)
    angle = draw.uniform(0, 2 * math.pi)
    along = math.sqrt(1 - down * down)
    velocity = [speed * along * math.cos(angle), speed * along * math.sin(angle), -speed * down]
    spin = 10 ** draw.uniform(0, 3) if draw.random() < 0.8 else 0
    height = size * (1 + draw.random()) + speed * step * draw.uniform(0, 1.5)
    until = height / (speed * down)
    duration = until + step * draw.uniform(1, 4)
    width = 2 * speed * duration + 1
    kind = draw.choice(SHAPES)
    lines = head(draw, step, duration, -9.81) + [
        f"  - {{name: plate, motion: static, shapes: [{{{plate_of(draw, width, thickness)}}}]}}",
        f"  - {{name: body, position: {numbers([draw.uniform(-1, 1), draw.uniform(-1, 1), height])}, "
        f"rpy: {numbers([draw.uniform(-3, 3) for _ in range(3)])}, velocity: {numbers(velocity)}, "
        f"angular_velocity: {numbers([spin * draw.uniform(-1, 1) for _ in range(3)])}, shapes: [{{{shape_of(draw, kind, size)}}}]}}"]
    passed = lambda rows: any(float(row["body.position.z [m]"]) < -thickness for row in rows)
    return f"{kind} {speed:.0f} m/s", lines, passed


def sweep(draw, step):
    """A blade turns or flies through the place of a body at rest. A body that stays at rest was passed."""
    size = draw.uniform(0.01, 0.05)
    thickness = draw.choice([0.001, 0.002, 0.003])
    length = draw.uniform(0.3, 1)
    kind = draw.choice(SHAPES)
    blade = f"type: box, size: {numbers([2 * length, thickness, 4 * size])}"
    if draw.random() < 0.3:
        blade = f"type: mesh, file: slab.obj, scale: {numbers([length, thickness / 2, 2 * size])}"
    if draw.random() < 0.6:
        spin = 10 ** draw.uniform(math.log10(30), 3) * draw.choice([-1, 1])
        place, angle = draw.uniform(0.3, 0.7) * length, draw.uniform(0.4, 2.7)
        position = [place * math.cos(angle), place * math.sin(angle), draw.uniform(-size, size)]
        duration = max(3 * step, math.pi / abs(spin) * 2.2)
        moving = f"angular_velocity: [0, 0, {spin:.9g}]"
        name = f"{kind} under {abs(spin):.0f} rad/s"
    else:
        speed = 10 ** draw.uniform(math.log10(30), math.log10(3000))
        away = size * 1.5 + thickness + draw.random() * speed * step
        position = [draw.uniform(-0.8, 0.8) * length, away, draw.uniform(-size, size)]
        duration = away / speed + 3 * step
        moving = f"velocity: [0, {speed:.9g}, 0]"
        name = f"{kind} under {speed:.0f} m/s"
    lines = head(draw, step, duration, 0) + [
        f"  - {{name: blade, motion: kinematic, {moving}, shapes: [{{{blade}}}]}}",
        f"  - {{name: body, position: {numbers(position)}, rpy: {numbers([draw.uniform(-3, 3) for _ in range(3)])}, "
        f"shapes: [{{{shape_of(draw, kind, size)}}}]}}"]
    moves = [f"body.velocity.{axis} [m/s]" for axis in "xyz"] + [f"body.angular_velocity.{axis} [rad/s]" for axis in "xyz"]
    passed = lambda rows: all(abs(float(rows[-1][key])) < 1e-9 for key in moves)
    return name, lines, passed


def case(number):
    draw = random.Random(number)
    step = draw.choice([1 / 60, 0.01, 0.004, 0.001])
    return (sweep if draw.random() < 0.25 else shot)(draw, step)


def run_case(options, runs, folder, work):
    scheme, number = work
    name, lines, passed = case(number)
    stem = folder / f"{scheme}-{number}"
    scene, table = stem.with_suffix(".yaml"), stem.with_suffix(".csv")
    scene.write_text("\n".join([f"method: {METHODS[scheme]}"] + lines) + "\n")
    command = [options.program, "run", scene, "-o", table]
    done = runs.call(command, options.cpu_limit)
    rows = []
    if table.exists():
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
    is_through = len(rows) > 1 and done.returncode in (0, 1) and passed(rows)
    if is_through:
        end = "through, audit passed" if done.returncode == 0 else "through"
    else:
        end = {0: "ok", 1: "audit failed", 130: "slow", -24: "slow", 152: "slow"}.get(done.returncode, "stopped")
    why = done.stderr.strip().split("\n")[0][:200]
    keeps = options.keep and end != "ok"
    if keeps:
        (options.keep / f"{scheme}-{number}.yaml").write_text(scene.read_text())
    for path in (scene, table):
        path.unlink(missing_ok=True)
    return end, name, why


def main():
    options = arguments()
    runs = Runs(options.jobs)
    counts = {scheme: dict.fromkeys(ENDS, 0) for scheme in options.schemes}
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
        for file, outline in OUTLINES.items():
            write_prism(options.keep / file, outline)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for file, outline in OUTLINES.items():
            write_prism(folder / file, outline)
        work = [(scheme, options.seed + k) for scheme in options.schemes for k in range(options.bodies)]
        for item, (end, name, why) in runs.results(lambda item: run_case(options, runs, folder, item), work):
            counts[item[0]][end] += 1
            if end != "ok":
                print(f"{item[0]} {item[1]}: {end}: {name}: {why}", flush=True)
    print(f"{'scheme':14} {'bodies':>6} " + " ".join(f"{end:>12}" for end in ENDS))
    for scheme, of_scheme in counts.items():
        print(f"{scheme:14} {options.bodies:6} " + " ".join(f"{of_scheme[end]:12}" for end in ENDS))
    return 1 if any(of_scheme[end] for of_scheme in counts.values() for end in ("through", "through, audit passed")) else 0


if __name__ == "__main__":
    sys.exit(main())
