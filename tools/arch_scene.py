#!/usr/bin/env python3
"""Writes the scene of a semicircular masonry arch of equal voussoirs with radial joints.

usage: tools/arch_scene.py NAME VOUSSOIRS THICKNESS FRICTION > scenes/NAME.yaml

The mean radius is 1 m. Mass, centre and inertia are those of the exact annular sector; what collides is the hull of its eight
corners, which has the same joints.
"""
import math
import sys

DEPTH, DENSITY = 0.5, 2000.0


def sector(inner, outer, half):
    """Mass, distance of the centre of mass from the axis, moments about it (radial, along the axis, tangential)."""
    volume = DEPTH * half * (outer**2 - inner**2)
    mass = DENSITY * volume
    centre = 2 / 3 * (outer**3 - inner**3) / (outer**2 - inner**2) * math.sin(half) / half
    polar = mass * (outer**2 + inner**2) / 2
    # Integrals of r² cos² and r² sin² about the sector's middle line.
    wave = math.sin(2 * half) / (2 * half)
    radial = polar * (1 + wave) / 2 - mass * centre**2
    tangential = polar * (1 - wave) / 2
    depth = mass * DEPTH**2 / 12
    return mass, centre, (tangential + depth, radial + tangential, radial + depth)


def main():
    name, count, thickness, friction = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]), sys.argv[4]
    inner, outer, half = 1 - thickness / 2, 1 + thickness / 2, math.pi / (2 * count)
    mass, centre, (radial, axial, tangential) = sector(inner, outer, half)
    print(f"""# A semicircular arch of {count} equal voussoirs, mean radius 1 m, thickness {thickness:g} m, friction {friction}.
#
# Observe: no mortar: the line of thrust stays inside the stones, or the arch falls.
# Expect:  with 8 stones it stands if the thickness is above 0.10086145416 m (and does not slide: friction 0.30416 is enough at
#          a thickness of 0.2 m). Written by tools/arch_scene.py.
rigor: 1
name: {name}
world: {{gravity: [0, 0, -9.81]}}
run: {{duration: 10, step: 0.01, output_interval: 0.1}}
materials:
  - {{name: stone, density: {DENSITY:g}, friction: {friction}, restitution: 0}}
bodies:
  - name: ground
    motion: static
    shapes: [{{type: plane, material: stone}}]""")
    for i in range(count):
        middle = (2 * i + 1) * half
        c, s = math.cos(middle), math.sin(middle)
        corners = [[r * math.cos(a), y, r * math.sin(a)] for a in (2 * i * half, 2 * (i + 1) * half)
                   for r in (inner, outer) for y in (-DEPTH / 2, DEPTH / 2)]
        for corner in corners:
            if abs(corner[2]) < 1e-12:
                corner[2] = 0.0
        # The body's frame is the world's: x = radial cos - tangential sin, z = radial sin + tangential cos.
        xx, zz = radial * c * c + tangential * s * s, radial * s * s + tangential * c * c
        xz = (radial - tangential) * s * c
        print(f"""  - name: stone{i + 1}
    inertia: {{mass: {mass!r}, center: [{centre * c!r}, 0, {centre * s!r}], moments: [{xx!r}, {axial!r}, {zz!r}], products: [0, {xz!r}, 0]}}
    shapes:
      - type: convex
        material: stone
        vertices: {corners!r}""")


main()
