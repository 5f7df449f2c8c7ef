#!/usr/bin/env python3
"""Scenes that fail, and whether what the program says about them helps.

usage: check_advice.py RIGOR [--least N]

Makes scenes that stop (exit code 4) or break their audit (1) in a known way, runs each, takes the lines `try --set KEY=VALUE: ...` of its
message, and runs the scene again with each of them in turn until one succeeds. Prints a line a scene; exit code 1 if fewer than N of them
(default: five sixths) were helped, or if a scene did not fail.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

BALL = "{type: sphere, radius: 0.1}"
FLOOR = "  - {name: floor, motion: static, shapes: [{type: plane}]}\n"


def scene(bodies, joints="", forces="", gravity=9.81, duration=1, step=0.01, restitution=0, method=""):
    """A scene file of these bodies."""
    text = f"rigor: 1\nworld: {{gravity: [0, 0, -{gravity}]}}\nrun: {{duration: {duration}, step: {step}, output_interval: {max(step, 0.01)}}}\n"
    text += f"materials: [{{name: default, friction: 0.5, restitution: {restitution}}}]\n"
    text += f"method: {{{method}}}\nbodies:\n{bodies}"
    return text + (f"joints:\n{joints}" if joints else "") + (f"forces:\n{forces}" if forces else "")


def pendulum(method, step=0.05):
    """An arm on a hinge, released level."""
    body = "  - {name: arm, position: [0.5, 0, 0], shapes: [{type: box, size: [1, 0.1, 0.1]}]}\n"
    joint = "  - {name: shoulder, type: hinge, bodies: [world, arm], anchor: [0, 0, 0], axis: [0, 1, 0]}\n"
    return scene(body, joint, duration=2, step=step, method=method)


def swing(method, stiffness, step=0.02):
    """A ball on a spring."""
    body = f"  - {{name: ball, position: [1, 0, 0], mass: 1, shapes: [{BALL}]}}\n"
    force = f"  - {{type: spring, between: [world, ball], points: [[0, 0, 0], [0, 0, 0]], stiffness: {stiffness}, length: 0.5}}\n"
    return scene(body, forces=force, gravity=0, step=step, method=method)


def tumbling(method, step=0.05):
    """A free box that spins about its intermediate axis."""
    body = "  - {name: box, angular_velocity: [0.1, 20, 0.1], shapes: [{type: box, size: [0.4, 0.2, 0.1]}]}\n"
    return scene(body, gravity=0, duration=2, step=step, method=method)


def tower(method, masses, step=0.01, size=0.2, gap=0.0, speed=0.0, duration=0.5):
    """Boxes on each other, from the floor up; the last one may fall on the others."""
    bodies = FLOOR
    for k, mass in enumerate(masses):
        last = k + 1 == len(masses)
        z = (k + 0.5) * size + (gap if last else 0)
        bodies += (f"  - {{name: box{k}, position: [0, 0, {z:.9g}], velocity: [0, 0, {-speed if last else 0}], mass: {mass:g}, "
                   f"shapes: [{{type: box, size: [{size}, {size}, {size}]}}]}}\n")
    return scene(bodies, duration=duration, step=step, method=method)


def failing_scenes():
    """(name, text) of each."""
    scenes = []
    for integrator, step in (("euler", 0.05), ("midpoint", 0.05), ("rk4", 0.2), ("semi-implicit-euler", 0.05), ("lie-rk4", 0.2)):
        scenes.append((f"pendulum by {integrator}", pendulum(f"integrator: {integrator}", step)))
    for integrator in ("euler", "midpoint", "rk4"):
        scenes.append((f"tumbling box by {integrator}", tumbling(f"integrator: {integrator}")))
    for integrator, stiffness in (("euler", 100), ("midpoint", 2000), ("rk4", 1e5), ("euler", 1e8), ("rk4", 1e9), ("midpoint", 1e12)):
        scenes.append((f"spring of {stiffness:g} N/m by {integrator}", swing(f"integrator: {integrator}", stiffness)))
    for ratio in (1e7, 1e8, 1e9, 1e10):
        scenes.append((f"impulse-based tower of ratio {ratio:g}", tower("scheme: impulse-based", [1, ratio])))
    for stiffness in (10, 30, 100):
        scenes.append((f"penalty on springs of {stiffness} N/m",
                       tower(f"scheme: penalty, stiffness: {stiffness}, damping: 10", [1, 1], gap=0.3, speed=2)))
    for stiffness in (50, 200, 1000):
        scenes.append((f"global penalty beside a spring of {stiffness} N/m",
                       swing("scheme: penalty, penalty: global", stiffness)))
    for mass in (1e3, 1e4, 1e5, 1e6):
        scenes.append((f"pgs under {mass:g} kg", tower("scheme: time-stepping, solver: pgs, iterations: 5", [1, 1, 1, mass])))
    for count in (6, 9):
        scenes.append((f"pgs under {count} boxes", tower("scheme: time-stepping, solver: pgs, iterations: 3", count * [1] + [300])))
    return scenes


def run(rigor, path, setting=None):
    """Exit code and all that was printed."""
    command = [rigor, "run", str(path)] + (["--set", setting] if setting else [])
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    except subprocess.TimeoutExpired:
        return 124, ""
    return done.returncode, done.stdout + done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("--least", type=int)
    options = parser.parse_args()
    scenes = failing_scenes()
    least = options.least or (5 * len(scenes) + 5) // 6
    helped = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.yaml"
        for name, text in scenes:
            path.write_text(text)
            code, output = run(options.rigor, path)
            advice = re.findall(r"^  try --set (\S+):", output, re.MULTILINE)
            if code not in (1, 4):
                print(f"{name}: exit {code}, it was to fail")
                continue
            failed += 1
            cure = next((setting for setting in advice if run(options.rigor, path, setting)[0] == 0), None)
            helped += cure is not None
            print(f"{name}: exit {code}, " + (f"{cure} helps" if cure else f"nothing of {advice} helps"), flush=True)
    print(f"{helped} of {failed} helped, {len(scenes) - failed} of {len(scenes)} did not fail")
    return 0 if helped >= least and failed == len(scenes) else 1


if __name__ == "__main__":
    sys.exit(main())
