#!/usr/bin/env python3
"""Writes the meshes of the scenes in which meshes touch meshes: scenes/meshes/{torus,peg,pinion,wheel,rabbit_a,rabbit_b}.obj.

usage: tools/make_scene_meshes.py [FOLDER]     (default: scenes/meshes)
"""
import math
import pathlib
import sys


def write_obj(path, what, vertices, faces):
    lines = [f"# {what}. Written by tools/make_scene_meshes.py."]
    lines += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def torus(ring, tube, rows, columns):
    vertices, faces = [], []
    for i in range(rows):
        u = 2 * math.pi * i / rows
        for j in range(columns):
            v = 2 * math.pi * j / columns
            r = ring + tube * math.cos(v)
            vertices.append((r * math.cos(u), r * math.sin(u), tube * math.sin(v)))
    for i in range(rows):
        for j in range(columns):
            a, b = i * columns + j, (i + 1) % rows * columns + j
            c, d = (i + 1) % rows * columns + (j + 1) % columns, i * columns + (j + 1) % columns
            faces += [(a, b, c), (a, c, d)]
    return vertices, faces


def prism(loop, bottom, top):
    """Prism over a loop, counter-clockwise seen from above."""
    n = len(loop)
    vertices = [(x, y, bottom) for x, y in loop] + [(x, y, top) for x, y in loop]
    faces = [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))]
    faces += [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return vertices, faces


def circle(radius, count):
    return [(radius * math.cos(2 * math.pi * i / count), radius * math.sin(2 * math.pi * i / count))
            for i in range(count)]


def gear_loop(teeth, root, tip):
    """Trapezoids: at half height a tooth and a gap are equally wide but for 4 % of play."""
    pitch = 2 * math.pi / teeth
    loop = []
    for k in range(teeth):
        for radius, place in ((root, -0.34), (tip, -0.12), (tip, 0.12), (root, 0.34)):
            angle = pitch * (k + place)
            loop.append((radius * math.cos(angle), radius * math.sin(angle)))
    return loop


def icosphere(levels):
    g = (1 + math.sqrt(5)) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    unit = lambda p: tuple(x / math.sqrt(sum(y * y for y in p)) for x in p)
    vertices = [unit(p) for p in vertices]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(vertices)
                vertices.append(unit(tuple(x + y for x, y in zip(vertices[a], vertices[b]))))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return vertices, faces


def rabbit(radius, ears, lean):
    """A lumpy ball with two ears: the ball's points are pulled out along two directions."""
    vertices, faces = icosphere(2)
    directions = [(math.sin(lean) * side, 0.35, math.cos(lean)) for side in (-1, 1)]
    directions = [tuple(x / math.sqrt(sum(y * y for y in d)) for x in d) for d in directions]
    pulled = []
    for p in vertices:
        r = 1 + 0.08 * math.sin(3 * p[0] + 1) * math.cos(4 * p[1])
        for d in directions:
            cosine = sum(x * y for x, y in zip(p, d))
            r += ears * math.exp((cosine - 1) / 0.06)
        pulled.append((radius * r * p[0], radius * r * 0.85 * p[1], radius * r * p[2]))
    return pulled, faces


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "scenes/meshes")
    write_obj(folder / "torus.obj", "Torus about z: ring 0.12 m, tube 0.035 m", *torus(0.12, 0.035, 18, 10))
    write_obj(folder / "peg.obj", "Peg along z: radius 0.05 m, from 0 to 0.3 m", *prism(circle(0.05, 14), 0, 0.3))
    write_obj(folder / "pinion.obj", "Gear about z: 12 teeth from 0.09 m to 0.11 m, 0.03 m thick",
              *prism(gear_loop(12, 0.09, 0.11), -0.015, 0.015))
    write_obj(folder / "wheel.obj", "Gear about z: 18 teeth from 0.14 m to 0.16 m, 0.027 m thick",
              *prism(gear_loop(18, 0.14, 0.16), -0.0135, 0.0135))
    write_obj(folder / "rabbit_a.obj", "Lumpy rock with two ears, about 0.1 m", *rabbit(0.1, 0.8, 0.5))
    write_obj(folder / "rabbit_b.obj", "Lumpy rock with two ears, about 0.08 m", *rabbit(0.08, 1.0, 0.8))


if __name__ == "__main__":
    main()
