#!/usr/bin/env python3
"""Starts the program's commands on hard scenes, ends them by SIGTERM at random times, and measures how long that takes:
at most 0.5 s (1 s where other work shares the machine). The exit code is one of those that are right, and what was written
is whole.

    tools/check_interrupts.py PROGRAM [--rounds N] [--seed S] [--most S]
"""
import argparse
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from fuzz_program import rows_trouble

STIFF = {
    "drag": "  - {name: a, position: [0, 0, 1], velocity: [1, 0, 0], linear_drag: 1e15, angular_drag: 1e15, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}\n",
    "force": ("  - {name: a, position: [0, 0, 1], shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}\n"
              "forces:\n  - {type: constant, body: a, force: [1e15, 0, 0], point: [0, 0, 0.1]}\n  - {type: torque, body: a, torque: [0, 1e15, 0]}\n"),
    "motor": ("  - {name: a, position: [0, 0, 2], shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}\n"
              "joints:\n  - {name: j, type: hinge, bodies: [world, a], anchor: [1, 0, 2], axis: [0, 1, 0], motor: {velocity: 1e8}}\n"),
    "chain": ("  - {name: a, position: [0, 0, 3], mass: 1e-6, shapes: [{type: sphere, radius: 0.1}]}\n"
              "  - {name: b, position: [0.3, 0, 3], mass: 1, shapes: [{type: sphere, radius: 0.1}]}\n"
              "joints:\n  - {name: s, type: distance, bodies: [a, b], anchors: [[0, 0, 3], [0.3, 0, 3]], limits: [0.2, 0.5], stiffness: 1e12, damping: 1e9}\n"),
    "spring": ("  - {name: a, position: [0, 0, 2], mass: 1e-3, shapes: [{type: sphere, radius: 0.1}]}\n"
               "forces:\n  - {type: spring, between: [world, a], points: [[0, 0, 3], [0, 0, 0]], stiffness: 1e15, length: 0.5}\n"),
}
# Its page and picture take seconds to write.
FIELD = ("rigor: 1\nrun: {duration: 2, step: 0.01, output_interval: 0.01}\nmethod: {scheme: time-stepping, solver: substep}\nbodies:\n"
         "  - {name: b, position: [0, 0, 1], velocity: [1, 2, 3], angular_velocity: [5, 6, 7], repeat: {count: [40, 40, 4], spacing: [3, 3, 3]}, "
         "shapes: [{type: cylinder, radius: 0.3, length: 1}]}\n")
SCHEMES = ["auto", "event-driven", "time-stepping", "impulse-based", "penalty", "hybrid"]


def write_scenes(folder):
    for name, bodies in STIFF.items():
        (folder / f"{name}.yaml").write_text(
            "rigor: 1\nrun: {duration: 0.5, step: 0.005, output_interval: 0.02}\nbodies:\n"
            "  - {name: floor, motion: static, shapes: [{type: plane}]}\n" + bodies)
    (folder / "field.yaml").write_text(FIELD)
    (folder / "crowd.yaml").write_text(
        "rigor: 1\nbodies:\n  - {name: b, position: [0, 0, 1], repeat: {count: [5000, 1, 1], spacing: [0, 0, 0]}, "
        "shapes: [{type: box, size: [1, 1, 1]}]}\n")
    (folder / "heap.yaml").write_text(
        "rigor: 1\nrun: {duration: 100}\nmethod: {scheme: time-stepping}\nbodies:\n  - {name: floor, motion: static, shapes: [{type: plane}]}\n"
        "  - {name: b, position: [0, 0, 0.5], repeat: {count: [8, 8, 8], spacing: [1.01, 1.01, 1.01]}, shapes: [{type: box, size: [1, 1, 1]}]}\n")


def calls():
    """Arguments of the program in the folder of the scenes, and what they write."""
    for scene in [*STIFF, "heap"]:
        for scheme in SCHEMES:
            outputs = ["out.csv", "out.h5", "out.json"]
            yield (["run", f"{scene}.yaml", "--quiet", "--json", "audit.json", "--set", f"method.scheme={scheme}",
                    *(word for output in outputs for word in ("-o", output))], outputs)
    yield ["run", "motor.yaml", "--quiet", "-o", "out.html", "-o", "out.png"], []
    for _ in range(8):
        yield ["run", "field.yaml", "--quiet", "-o", "out.html", "-o", "out.png"], ["out.html"]
    yield ["run", "crowd.yaml", "--quiet", "--separate"], []
    yield ["check", "crowd.yaml"], []
    yield ["view", "drag.yaml"], []
    yield ["view", "crowd.yaml"], []
    for scene in ("drag", "chain", "heap"):
        yield ["compare", f"{scene}.yaml", "--vary", "method.scheme=event-driven,time-stepping,impulse-based", "--quiet", "--json", "compare.json"], []


def files_trouble(program, folder, outputs, code):
    # A signal before the run begins ends the program at once: there is nothing to be whole then.
    if code < 0 or not outputs:
        return ""
    if outputs == ["out.html"]:
        page = folder / "out.html"
        return "half a page" if page.exists() and not page.read_text().endswith("</html>\n") else ""
    if "out.csv" in outputs and (trouble := rows_trouble(folder / "out.csv")):
        return trouble
    for name in ("out.json", "audit.json"):
        try:
            json.loads((folder / name).read_text(), parse_constant=lambda word: 1 / 0)
        except (ValueError, ZeroDivisionError, OSError) as error:
            return f"{name}: {error!r}"
    read = subprocess.run([program, "plot", "out.h5", "energy.total", "-o", "energy.svg"], cwd=folder, capture_output=True, text=True)
    return "" if read.returncode == 0 else f"out.h5 cannot be read: {read.stderr}"


def measure(program, folder, arguments, outputs, pause):
    """Seconds from the signal to the end (0 if it ended by itself), exit code, trouble."""
    for name in [*outputs, "audit.json"]:
        (folder / name).unlink(missing_ok=True)
    process = subprocess.Popen([program, *arguments], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    begin = None
    try:
        process.wait(pause)
    except subprocess.TimeoutExpired:
        begin = time.monotonic()
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
    seconds = 0.0 if begin is None else time.monotonic() - begin
    code = process.returncode
    right = {0, 1, 3, 4} if begin is None else {0, 1, 3, 4, 130, -signal.SIGTERM}
    trouble = "" if code in right else f"exit code {code}"
    return seconds, code, trouble or files_trouble(program, folder, outputs, code)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=float, default=1.0, help="seconds from the signal to the end")
    options = parser.parse_args()
    draw = random.Random(options.seed)
    times, troubles = [], 0
    with tempfile.TemporaryDirectory(prefix="rigor_interrupts_") as name:
        folder = pathlib.Path(name)
        write_scenes(folder)
        for _ in range(options.rounds):
            for arguments, outputs in calls():
                # The page of a field is written after some seconds.
                pause = draw.uniform(0.05, 1.5) * (6 if "field.yaml" in arguments else 1)
                seconds, code, trouble = measure(options.program, folder, arguments, outputs, pause)
                if seconds > 0:
                    times.append(seconds)
                if seconds > options.most:
                    trouble = trouble or f"{seconds:.2f} s from SIGTERM to the end"
                if trouble:
                    troubles += 1
                    print(f"rigor {' '.join(arguments)}, SIGTERM after {pause:.2f} s: {trouble} (exit code {code})", file=sys.stderr, flush=True)
    times.sort()
    if times:
        print(f"{len(times)} commands ended by SIGTERM: {times[len(times) // 2]:.3f} s in the middle, {times[-1]:.3f} s at most")
    return 1 if troubles else 0


if __name__ == "__main__":
    sys.exit(main())
