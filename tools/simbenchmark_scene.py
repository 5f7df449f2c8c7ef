#!/usr/bin/env python3
"""Writes scenes of SimBenchmark (ETH RSL) for `rigor run`: rolling, bouncing or elastic-666.

    tools/simbenchmark_scene.py elastic-666 > elastic_666.yaml
"""
import random
import sys

GRAVITY = 9.81


def header(name, duration, materials, pairs=""):
    return (f"rigor: 1\nname: {name}\nworld: {{gravity: [0, 0, -{GRAVITY}]}}\n"
            f"run: {{duration: {duration}, step: 1e-3, output_interval: 1e-3}}\n"
            f"method: {{scheme: time-stepping}}\nmaterials: [{materials}]\n{pairs}bodies:\n"
            "  - {name: floor, motion: static, "
            "shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: floor}]}\n")


def ball(name, mass, radius, position):
    x, y, z = position
    return (f"  - {{name: {name}, mass: {mass}, position: [{x:.17g}, {y:.17g}, {z:.17g}], "
            f"shapes: [{{type: sphere, radius: {radius}, material: ball}}]}}\n")


def elastic(name, duration, places):
    smooth = "friction: 0, restitution: 1}"
    text = header(name, duration, f"{{name: floor, {smooth}, {{name: ball, {smooth}")
    return text + "".join(ball(f"ball{i}", 10, 0.1, place) for i, place in enumerate(places))


def bouncing():
    """49 balls whose centres begin 5 m above the floor."""
    return elastic("bouncing", 20, [(i, j, 5) for i in range(7) for j in range(7)])


def elastic_666():
    """216 balls, 0.21 m apart, each coordinate up to 1 mm more; the lowest fall by 1 m."""
    draw = random.Random(1)
    places = [tuple(0.21 * k + draw.uniform(0, 1e-3) for k in (i, j, l))
              for i in range(6) for j in range(6) for l in range(6)]
    return elastic("elastic-666", 10, [(x, y, z + 1.101) for x, y, z in places])


def rolling():
    """25 balls on a box that a force pushes along (1/2, √3/2)."""
    text = header("rolling", 4, "{name: floor}, {name: box}, {name: ball}",
                  "pairs:\n  - {between: [box, floor], friction: 0.4, restitution: 0}\n"
                  "  - {between: [box, ball], friction: 0.8, restitution: 0}\n"
                  "  - {between: [floor, ball], friction: 0.5, restitution: 0}\n")
    text += ("  - {name: box, mass: 10, position: [0, 0, 0.5], "
             "shapes: [{type: box, size: [20, 20, 1], material: box}]}\n")
    text += "".join(ball(f"ball{i}{j}", 1, 0.5, (2 * i - 4, 2 * j - 4, 1.5)) for i in range(5) for j in range(5))
    return text + f"forces:\n  - {{type: constant, body: box, force: [75, {75 * 3 ** 0.5:.17g}, 0]}}\n"


if __name__ == "__main__":
    SCENES = {"rolling": rolling, "bouncing": bouncing, "elastic-666": elastic_666}
    if len(sys.argv) != 2 or sys.argv[1] not in SCENES:
        sys.exit("usage: simbenchmark_scene.py " + "|".join(SCENES))
    sys.stdout.write(SCENES[sys.argv[1]]())
