#!/usr/bin/env python3
"""Ends runs anywhere, resumes them, and compares what follows with the run that was not put aside: every number, and the audit.

Scenes of several kinds (impacts, heaps, joints with limits and motors, springs, drag, meshes, kinematic bodies) are drawn with each scheme.
A run ends at a random time, at an output or a rounding beside one, once or twice, and goes on from its checkpoint.

usage: tools/check_resume.py [--program RIGOR] [--jobs N] [--places N] [--seed K] [--schemes a,b] [--cpu-limit S] [--keep FOLDER]
exit code: 0 if every resumed run was the whole run to the bit, else 1
"""
import csv
import json
import math
import pathlib
import random
import shutil
import sys
import tempfile

from failing_scenes import FLOOR, body, chain, power, scene, solid, spin
from measured_runs import METHODS, ROOT, Runs, study_parser

PLACES_OF_A_SCENE = 5
NOT_OF_THE_MOTION = {"wall_time", "real_time_factor"}


def thrown(draw, folder):
    """Bodies of all shapes that fall on each other."""
    bodies = FLOOR + "".join(body(f"b{k}", solid(draw, 0.3), [draw.uniform(-0.2, 0.2), draw.uniform(-0.2, 0.2), 0.3 + 0.4 * k], [0, 0, -draw.uniform(0, 3)], spin(draw, 6))
                             for k in range(draw.randint(1, 5)))
    return bodies, "", ""


def crowd(draw, folder):
    """Balls that fall on each other between walls: many events, so that `auto` hands over."""
    bodies = FLOOR + "".join(body(f"wall{k}", f"type: plane, normal: {normal}, offset: -0.2", [0, 0, 0], more="motion: static")
                             for k, normal in enumerate(["[1, 0, 0]", "[-1, 0, 0]", "[0, 1, 0]", "[0, -1, 0]"]))
    return bodies + "".join(body(f"b{k}", "type: sphere, radius: 0.05", [0.11 * (k % 3 - 1), 0.11 * (k // 3 % 3 - 1), 0.1 + 0.11 * (k // 9)], [0, 0, draw.uniform(-3, 0)])
                            for k in range(draw.choice([9, 18, 27]))), "", ""


def springs(draw, folder):
    """A ball on a spring over the floor, and one under drag."""
    bodies = FLOOR + body("ball", "type: sphere, radius: 0.1", [0.3, 0, 0.5]) + body("dragged", solid(draw, 0.2), [2, 0, 0.6], [1, 0, 2], spin(draw, 5),
                                                                                    f"linear_drag: {power(draw, -1, 2):.4g}, angular_drag: {power(draw, -3, 0):.4g}")
    return bodies, "", f"  - {{type: spring, between: [world, ball], points: [[0, 0, 1], [0, 0.05, 0]], stiffness: {power(draw, 1, 4):.4g}, damping: {draw.choice([0, 2])}, length: 0.4}}\n"


def hanging(draw, folder):
    """A chain that swings against the floor."""
    count = draw.randint(1, 4)
    bodies, joints = chain(count, 0.25, 0.03, top=(0, 0, 0.25 * count * draw.uniform(0.5, 1.2)))
    return FLOOR + bodies, joints, ""


def driven(draw, folder):
    """An arm with a motor that strikes a body, and a table that carries one."""
    bodies = FLOOR + body("arm", "type: box, size: [0.5, 0.06, 0.06]", [0.25, 0, 0.5]) + body("struck", solid(draw, 0.2), [0.3, 0, 0.2])
    bodies += body("table", "type: box, size: [0.5, 0.5, 0.1]", [2, 0, 0.5], [0.1, 0, 0], [0, 0, 1], "motion: kinematic") + body("cup", solid(draw, 0.2), [2, 0.05, 0.8])
    limits = draw.choice(["", ", limits: [-0.4, 0.4]"])
    return bodies, (f"  - {{name: drive, type: hinge, bodies: [world, arm], anchor: [0, 0, 0.5], axis: [0, 1, 0]{limits}, "
                    f"motor: {{velocity: {draw.uniform(-5, 5):.4g}, max_force: {power(draw, 0, 2):.4g}}}}}\n"), ""


def meshes(draw, folder):
    """Stones that fall on a sheet."""
    for name in ("rock_a.obj", "torus.obj"):
        shutil.copy(ROOT / "scenes/meshes" / name, folder / name)
    bodies = FLOOR + "".join(body(f"b{k}", f"type: mesh, file: {draw.choice(['rock_a.obj', 'torus.obj'])}, scale: 0.3", [0.1 * k, 0, 0.4 + 0.5 * k], spin=spin(draw, 4)) for k in range(draw.randint(1, 2)))
    return bodies, "", ""


def laws(draw, folder):
    """A motor and a force that follow laws of time, over a floor."""
    bodies = FLOOR + body("arm", "type: box, size: [0.5, 0.06, 0.06]", [0.25, 0, 0.6]) + body("pushed", solid(draw, 0.2), [1, 0, 0.21]) + body("struck", solid(draw, 0.2), [0.3, 0, 0.21])
    motor = draw.choice([f"{{table: [[0, 0], [0.2, {draw.uniform(-6, 6):.4g}]]}}", f"{{amplitude: {draw.uniform(1, 6):.4g}, frequency: {draw.uniform(1, 8):.4g}}}"])
    return bodies, (f"  - {{name: drive, type: hinge, bodies: [world, arm], anchor: [0, 0, 0.6], axis: [0, 1, 0], motor: {{velocity: {motor}, max_force: {power(draw, 0, 2):.4g}}}}}\n"), (
        f"  - {{type: constant, body: pushed, force: [{power(draw, 0, 2):.4g}, 0, 0], factor: {{amplitude: 1, frequency: {draw.uniform(1, 8):.4g}}}}}\n")


def carried(draw, folder):
    """Bodies at rest, on a floor and on each other, that a table on a path carries or sweeps away."""
    bodies = FLOOR + body("base", "type: box, size: [0.4, 0.4, 0.1]", [0, 0, 0.05]) + body("top", solid(draw, 0.15), [0, 0, 0.25])
    begin, speed = draw.uniform(0, 0.2), draw.uniform(-4, 4)
    path = f"path: [{{time: 0, position: [2, 0, 0.2]}}, {{time: {begin:.4g}, position: [2, 0, 0.2]}}, {{time: {begin + 0.1:.4g}, position: [{2 - 0.1 * speed:.6g}, 0, 0.2]}}]"
    bodies += f"  - {{name: table, motion: kinematic, {path}, shapes: [{{type: box, size: [0.4, 0.4, 0.1]}}]}}\n" + body("cup", solid(draw, 0.15), [2, 0.05, 0.4])
    bodies += body("late", "type: sphere, radius: 0.08", [draw.uniform(-0.2, 0.2), 0, draw.uniform(0.5, 1)], [0, 0, -4])
    return bodies, "", ""


KINDS = [thrown, crowd, springs, hanging, driven, meshes, laws, carried]


def draw_scene(scheme, number, folder):
    """The text of a scene, and its duration and interval of output."""
    draw = random.Random(f"resume {scheme} {number}")
    kind = KINDS[number % len(KINDS)]
    bodies, joints, forces = kind(draw, folder)
    interval, duration = draw.choice([0.01, 0.02, 0.0333333]), 0.4
    text = scene(bodies, joints, forces, step=draw.choice([1 / 60, 0.01, 0.004]), duration=duration, restitution=draw.choice([0, 0.5]),
                 method=METHODS[scheme].strip("{}"), interval=interval)
    return text, kind.__name__, duration, interval


def place(draw, duration, interval):
    """A time at which a run ends: anywhere, or at an output or a rounding beside it."""
    if draw.random() < 0.5:
        return draw.uniform(0.01, 0.99) * duration
    return draw.randint(1, int(duration / interval) - 1) * interval * (1 + draw.choice([0, 0, 1e-15, -1e-15, 1e-9]))


def differences(a, b, name=""):
    """Where two values of JSON differ."""
    if isinstance(a, dict) and isinstance(b, dict):
        return [each for key in sorted(set(a) | set(b)) if key not in NOT_OF_THE_MOTION for each in differences(a.get(key), b.get(key), f"{name}.{key}")]
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        return [each for k, (x, y) in enumerate(zip(a, b)) for each in differences(x, y, f"{name}[{k}]")]
    return [] if a == b else [f"{name[1:]}: {b} instead of {a}"]


def rows(path):
    """The rows of a trajectory by their times, and the names of their columns."""
    with path.open(newline="") as file:
        table = list(csv.reader(file))
    return table[0], {row[0]: row for row in table[1:]}


def compare(whole, resumed):
    """What differs between two runs, each a table and an audit."""
    names, first = rows(whole.with_suffix(".csv"))
    _, second = rows(resumed.with_suffix(".csv"))
    found = []
    for k, (time, row) in enumerate(second.items()):
        if time not in first:
            found.append(f"a row at t = {time}")
        # The first is that of the checkpoint: what happened before it is not known.
        elif k > 0 and row != first[time]:
            found.append(next(f"t = {time}: {name} {b} instead of {a}" for name, a, b in zip(names, first[time], row) if a != b))
    return found[:1] + differences(*(json.loads(path.with_suffix(".json").read_text()) for path in (whole, resumed)))[:4]


def run(options, runs, path, name, arguments):
    """Exit code of a run that writes NAME.csv, NAME.json and NAME.cp."""
    out = path.with_name(name)
    done = runs.call([options.program, "run", path, "--quiet", "-o", out.with_suffix(".csv"), "--json", out.with_suffix(".json"),
                      "--checkpoint", out.with_suffix(".cp"), *arguments], options.cpu_limit)
    return done.returncode, done.stderr


def try_scene(options, runs, folder, work):
    """How many places were tried, and what was wrong."""
    scheme, number = work
    folder = folder / f"{scheme}-{number}"
    folder.mkdir()
    path = folder / "scene.yaml"
    text, kind, duration, interval = draw_scene(scheme, number, folder)
    path.write_text(text)
    code, errors = run(options, runs, path, "whole", [])
    if code not in (0, 1):
        return 0, [f"{kind}: the whole run ends with {code}: {errors[:200]}"] if code not in (-24, 152, 4) else []
    draw, wrong = random.Random(f"places {scheme} {number}"), []
    for k in range(PLACES_OF_A_SCENE):
        ends = sorted({place(draw, duration, interval) for _ in range(draw.choice([1, 1, 2]))})
        before = []
        for i, end in enumerate(ends + [duration]):
            name = f"part{k}{i}"
            code, errors = run(options, runs, path, name, ["--duration", repr(end), *before])
            if code not in (0, 1):
                wrong.append(f"{kind}: put aside at {ends}, part {i} ends with {code}: {errors[:200]}")
                break
            before = ["--resume", folder / f"{name}.cp"]
        else:
            if found := compare(folder / "whole", folder / name):
                wrong.append(f"{kind}: put aside at {ends}: " + "; ".join(found))
    if wrong and options.keep:
        shutil.copytree(folder, options.keep / folder.name, dirs_exist_ok=True)
    shutil.rmtree(folder)
    return PLACES_OF_A_SCENE, wrong


def main():
    parser = study_parser(__doc__, ",".join(METHODS))
    parser.add_argument("--places", type=int, default=100, help="for each scheme")
    options = parser.parse_args()
    runs = Runs(options.jobs)
    tried, wrong = dict.fromkeys(options.schemes, 0), dict.fromkeys(options.schemes, 0)
    with tempfile.TemporaryDirectory(prefix="rigor_resume_") as name:
        work = [(scheme, options.seed + k) for k in range(math.ceil(options.places / PLACES_OF_A_SCENE)) for scheme in options.schemes]
        for (scheme, number), (places, found) in runs.results(lambda item: try_scene(options, runs, pathlib.Path(name), item), work):
            tried[scheme] += places
            wrong[scheme] += len(found)
            for each in found:
                print(f"{scheme} {number}: {each}", flush=True)
    for scheme in options.schemes:
        print(f"{scheme}: {tried[scheme]} places, {wrong[scheme]} differ")
    return 1 if any(wrong.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
