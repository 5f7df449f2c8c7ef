#!/usr/bin/env python3
"""Writes a random dissipative pile as a scene for `rigor run`: bodies thrown into a walled box, with friction 0.5.

Boxes, balls and capsules of 200 to 8000 kg/m³, 4 to 20 of them, 5 s. With restitution 0, the default, nothing drives
and nothing bounces: the mechanical energy never rises.

    tools/random_pile_scene.py SEED [RESTITUTION] > pile.yaml
"""
import math
import random
import sys

HALF_WIDTH = 1.5  # Of the floor between the walls [m].


def vector(values, digits=6):
    return "[" + ", ".join(f"{value:.{digits}f}" for value in values) + "]"


def walls():
    """Four boxes, 1 m thick and 6 m high, around the floor."""
    far, long = HALF_WIDTH + 0.5, HALF_WIDTH + 1
    for i, (x, y, sx, sy) in enumerate([(far, 0, 0.5, long), (-far, 0, 0.5, long), (0, far, long, 0.5), (0, -far, long, 0.5)]):
        yield (f"  - {{name: wall{i}, motion: static, position: [{x}, {y}, 3], "
               f"shapes: [{{type: box, size: [{2 * sx}, {2 * sy}, 6], material: rough}}]}}")


def body(draw, name, cell):
    """A body in its cell; nothing overlaps at the start."""
    kind = draw.choice(["box", "box", "sphere", "capsule"])
    q = [draw.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(a * a for a in q))
    if kind == "box":
        shape = f"type: box, size: {vector([2 * draw.uniform(.05, .22) for _ in range(3)], 4)}"
    elif kind == "sphere":
        shape = f"type: sphere, radius: {draw.uniform(.06, .3):.4f}"
    else:
        radius, half = draw.uniform(.05, .12), draw.uniform(.05, .2)
        shape = f"type: capsule, radius: {radius:.4f}, length: {2 * half:.4f}"
    density = 10 ** draw.uniform(2.3, 3.9)
    x, y, z = cell
    position = (x * .95 + draw.uniform(-.05, .05), y * .95 + draw.uniform(-.05, .05), .6 + z * .9)
    velocity = [draw.uniform(-3, 3) for _ in range(3)]
    spin = [draw.uniform(-8, 8) for _ in range(3)]
    return (f"  - {{name: {name}, density: {density:.1f}, position: {vector(position)}, "
            f"orientation: {vector([a / length for a in q])}, velocity: {vector(velocity)}, "
            f"angular_velocity: {vector(spin)}, shapes: [{{{shape}, material: rough}}]}}")


def pile(seed, restitution=0):
    draw = random.Random(1000 + seed)
    count = draw.randint(4, 20)
    cells = [(x, y, z) for z in range(6) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    places = draw.sample(range(min(len(cells), count + 14)), count)
    lines = ["rigor: 1", f"name: pile-{seed}", "world: {gravity: [0, 0, -9.81]}",
             "run: {duration: 5, step: 0.002, output_interval: 0.01}",
             "materials:", f"  - {{name: rough, friction: 0.5, restitution: {restitution:g}}}", "bodies:",
             "  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rough}]}"]
    return "\n".join(lines + list(walls()) + [body(draw, f"b{k}", cells[c]) for k, c in enumerate(places)]) + "\n"


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: random_pile_scene.py SEED [RESTITUTION]")
    sys.stdout.write(pile(int(sys.argv[1]), *map(float, sys.argv[2:])))
