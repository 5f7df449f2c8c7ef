#!/usr/bin/env python3
"""Scenes that have to end soon, against the times that are aimed at: part of `make bench`.

Each scene is run by the program as a user would, and what counts is the processor time of the process, its start and the audit
included; where threads are compared, the time on the clock. A run that does not end, or whose audit fails, has no figure.

usage: benchmarks/scene_bars.py [--program RIGOR] [--limit S]
"""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile
import time

import resource

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True

from heap_scene import field_scene, heap_scene  # noqa: E402  (it lies in tools/)
from random_mechanism_scene import mechanism  # noqa: E402
from random_pile_scene import pile  # noqa: E402

FAILED = math.inf


class Program:
    def __init__(self, path, limit, folder):
        self.path, self.limit, self.scene = path, limit, folder / "scene.yaml"

    def run(self, scene, *arguments):
        """Processor time and time on the clock [s] of a run of this text or shipped scene; infinite if it did not end well."""
        path = scene if isinstance(scene, pathlib.Path) else self.scene
        if path == self.scene:
            path.write_text(scene)
        before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        command = [self.path, "run", path, "--separate", "--cpu-limit", str(self.limit), *arguments]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        clock, after = time.monotonic() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            return FAILED, FAILED
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, clock


def settings(**values):
    return [word for key, value in values.items() for word in ("--set", f"{key.replace('__', '.')}={value}")]


def show(what, figures, unit, bar, is_least=False):
    """A line; the worst of the figures is what is compared."""
    worst = min(figures) if is_least else max(figures)
    is_met = worst >= bar if is_least else worst <= bar
    values = ", ".join("-" if math.isinf(x) else f"{x:.3g}" for x in figures)
    print(f"{what:58} {values:>34} {unit:8} {'>=' if is_least else '<='} {bar:<5g} {'' if is_met else 'missed'}", flush=True)


def struck(program):
    for kind, count in [("books", 12), ("books", 30), ("wall", 30), ("wall", 100)]:
        show(f"{kind} {count}, hit by a ball, 2 s", [program.run(heap_scene(kind, count, seed))[0] for seed in range(3)], "CPU s", 5)


def by_events(program):
    one = settings(method__scheme="event-driven", run__duration=1)
    for kind in ("boxes", "mixed"):
        for count, bar, seeds in [(12, 1, 4), (24, 4, 2)]:
            times = [program.run(heap_scene(kind, count, seed), *one)[0] for seed in range(seeds)]
            show(f"{kind} {count} by events, 1 s", times, "CPU s", bar)


def by_default(program):
    for kind in ("boxes", "mixed", "books", "wall", "chain"):
        for count in (24, 48, 100):
            show(f"{kind} {count} by default settings, 2 s", [program.run(heap_scene(kind, count))[0]], "CPU s", 40)


def at_rest(program):
    """Time of a step: what thirty steps take more than ten. Whole rows are 101 and 1,001 bricks."""
    def step(count):
        times = [program.run(heap_scene("rest", count), *settings(method__scheme="time-stepping", run__duration=0.01 * steps))[0]
                 for steps in (10, 30)]
        return (times[1] - times[0]) / 20 if math.isfinite(times[1]) and times[1] > times[0] else FAILED
    few, many = step(100), step(1000)
    show("1,001 bricks at rest, a step", [many], "CPU s", 0.3)
    growth = math.log(many / few) / math.log(1001 / 101) if math.isfinite(few) and math.isfinite(many) else FAILED
    show("growth from 101 to 1,001 bricks, exponent", [growth], "", 1.3)


def many_contacts(program):
    """Some 50,000 contacts of one island: 6,300 bricks, two steps, the second of which begins with the forces of the first."""
    times = [program.run(heap_scene("rest", 6300), *settings(method__scheme="time-stepping", run__duration=0.02))[0]]
    show("50,000 contacts at rest, two steps", times, "CPU s", 120)


def piles(program):
    for scheme, bar in [("time-stepping", 20), ("event-driven", 30)]:
        times = [program.run(pile(seed), *settings(method__scheme=scheme))[0] for seed in range(40)]
        whole = [t for t in times if math.isfinite(t)]
        show(f"of 40 random piles, 5 s by {scheme}: whole", [len(whole)], "runs", 40, is_least=True)
        show(f"these piles by {scheme}, in all", [sum(whole)], "CPU s", bar)


def on_threads(program):
    for kind in ("boxes", "mixed"):
        ratios = []
        for seed in range(2):
            scene = field_scene(20, 12, kind, seed)
            one, two = (program.run(scene, *settings(method__scheme="time-stepping", run__duration=1.5), "--threads", str(threads))[1]
                        for threads in (1, 2))
            ratios.append(one / two if math.isfinite(one) and math.isfinite(two) else -FAILED)
        show(f"20 heaps of 12 {kind}: one thread / two", ratios, "clock", 1.6, is_least=True)


def mechanisms(program):
    scenes = ROOT / "scenes"
    show("double pendulum, 10 s at 1e-10", [min(program.run(scenes / "double_pendulum.yaml", *settings(method__tolerance=1e-10))[0]
                                                for _ in range(5))], "CPU s", 0.05)
    show("Andrews' mechanism, 0.03 s", [min(program.run(scenes / "andrews.yaml", *settings(run__duration=0.03))[0] for _ in range(5))],
         "CPU s", 0.1)
    ten = Program(program.path, 10, program.scene.parent)
    ended = sum(math.isfinite(ten.run(mechanism(seed), *settings(run__duration=3))[0]) for seed in range(60))
    show("of 60 random mechanisms, 3 s: whole in 10 CPU s", [ended], "runs", 50, is_least=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default=str(ROOT / "build/bench/rigor"), help="rigor, wherever it lies")
    parser.add_argument("--limit", type=int, default=60, help="processor time of a run [s]")
    options = parser.parse_args()
    print(f"{'scenes, seeds from 0 on':58} {'measured':>34} {'':8} aim")
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.program, options.limit, pathlib.Path(folder))
        for part in (struck, by_events, by_default, at_rest, many_contacts, piles, on_threads, mechanisms):
            part(program)


main()
