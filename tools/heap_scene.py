#!/usr/bin/env python3
"""Writes a scene of bodies that fall or are struck: what exact schemes have to end soon.

    tools/heap_scene.py KIND COUNT [SEED] > heap.yaml

boxes, mixed  COUNT bodies fall askew on each other; boxes, or boxes, balls, capsules and cylinders in turn
books         a stack of COUNT books is hit by a ball
wall          a running bond of COUNT bricks is hit by a ball
chain         COUNT links of ball joints fall on a floor
rest          a running bond of at least COUNT bricks in whole rows, with half bricks at its ends, which nothing hits
"""
import random
import sys

SIZE = {"boxes": [0.15, 0.12, 0.1], "book": [0.16, 0.24, 0.03], "brick": [0.2, 0.1, 0.1]}
BOX = f"type: box, size: {SIZE['boxes']}"
MIXED = [BOX, "type: sphere, radius: 0.07", "type: capsule, radius: 0.05, length: 0.1", "type: cylinder, radius: 0.06, length: 0.1"]
PITCH = 0.25       # Of the bodies that fall [m].
BRICK_STEP = 0.205  # From brick to brick of a wall that is struck; of one that rests they touch.


def numbers(values):
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"


def body(name, position, shape, velocity=(0, 0, 0), rpy=(0, 0, 0)):
    return (f"  - {{name: {name}, position: {numbers(position)}, rpy: {numbers(rpy)}, velocity: {numbers(velocity)}, "
            f"shapes: [{{{shape}, material: m}}]}}")


def falling(count, draw, shapes, prefix="b", corner=(0, 0)):
    side = max(2, round((count / 4) ** (1 / 3)))
    for k in range(count):
        x, y, level = k % side, k // side % side, k // side ** 2
        place = [corner[0] + PITCH * x + draw.uniform(-0.02, 0.02), corner[1] + PITCH * y + draw.uniform(-0.02, 0.02), 0.3 + PITCH * level]
        yield body(f"{prefix}{k}", place, shapes[k % len(shapes)], rpy=[draw.uniform(-1, 1) for _ in range(3)])


def books(count, draw):
    for k in range(count):
        yield body(f"b{k}", [0, 0, 0.03 * (k + 0.5)], f"type: box, size: {SIZE['book']}")
    yield body("ball", [-1, draw.uniform(-0.05, 0.05), 0.018 * count], "type: sphere, radius: 0.06", velocity=[6, 0, 1.2])


def wall(count, draw):
    row = max(3, round((2 * count) ** 0.5))
    for k in range(count):
        level, i = divmod(k, row)
        yield body(f"b{k}", [BRICK_STEP * (i + 0.5 * (level % 2)), 0, 0.1 * (level + 0.5)], f"type: box, size: {SIZE['brick']}")
    yield body("ball", [0.1 * row, -1.5, 0.3], "type: sphere, radius: 0.15", velocity=[draw.uniform(-0.5, 0.5), 12, 0])


def rest(count, _):
    row = max(3, round((2 * count) ** 0.5))
    length, _, height = SIZE["brick"]
    made = level = 0
    while made < count:
        # Every other row begins and ends with half a brick.
        halves = [0.5] + [1] * (row - 1) + [0.5] if level % 2 else [1] * row
        x = 0
        for part in halves:
            yield body(f"b{made}", [x + 0.5 * part * length, 0, height * (level + 0.5)], f"type: box, size: [{part * length:g}, 0.1, 0.1]")
            x += part * length
            made += 1
        level += 1


def chain(count, _):
    for k in range(count):
        yield body(f"b{k}", [0.2 * k, 0, 1.5], "type: capsule, radius: 0.03, length: 0.12")
    yield "joints:"
    for k in range(count - 1):
        yield f"  - {{name: j{k}, type: ball, bodies: [b{k}, b{k + 1}], anchor: [{0.2 * k + 0.1:.6g}, 0, 1.5]}}"


KINDS = {"boxes": lambda count, draw: falling(count, draw, [BOX]), "mixed": lambda count, draw: falling(count, draw, MIXED),
         "books": books, "wall": wall, "chain": chain, "rest": rest}


def head(name, restitution=0):
    return (f"rigor: 1\nname: {name}\nrun: {{duration: 2, step: 0.01, output_interval: 0.02}}\n"
            f"materials: [{{name: m, density: 1000, friction: 0.5, restitution: {restitution}}}]\n"
            "bodies:\n  - {name: floor, motion: static, shapes: [{type: plane, material: m}]}")


def heap_scene(kind, count, seed=0):
    """A scene as text."""
    draw = random.Random(1000 * seed + count)
    is_struck = kind in ("books", "wall")
    return "\n".join([head(f"{kind}-{count}-{seed}", 0.1 if is_struck else 0), *KINDS[kind](count, draw)]) + "\n"


def field_scene(heaps, count, kind, seed=0):
    """So many heaps of so many falling bodies, 3 m apart."""
    draw = random.Random(seed)
    shapes = [BOX] if kind == "boxes" else MIXED
    lines = [head(f"{heaps}-heaps-{kind}-{seed}")]
    for heap in range(heaps):
        lines += falling(count, draw, shapes, f"h{heap}b", (3 * (heap % 5), 3 * (heap // 5)))
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[1] not in KINDS:
        sys.exit(__doc__)
    sys.stdout.write(heap_scene(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 0))
