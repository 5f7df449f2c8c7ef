#!/usr/bin/env python3
"""Writes the scene of dominoes that stand along a spiral.

usage: tools/domino_spiral_scene.py COUNT > scenes/domino_spiral.yaml

The spiral is that of Archimedes: its turns are 6 cm apart, the dominoes 3 cm, from the middle outwards.
"""
import math
import sys

PITCH, SPACING, START = 0.06, 0.03, 0.3


def main():
    count = int(sys.argv[1])
    print(f"""# {count} dominoes (50 x 25 x 10 mm) on a spiral whose turns are 60 mm apart; the innermost begins to fall outwards.
#
# Observe: the wave runs round and round; a domino that falls never reaches the next turn.
# Expect:  no domino passes through another; all lie or lean when the wave has gone by.
#          Written by tools/domino_spiral_scene.py.
rigor: 1
name: domino-spiral
world: {{gravity: [0, 0, -9.81]}}
run: {{duration: 10, step: 0.008333333333333333, output_interval: 0.05}}
method: {{scheme: time-stepping, solver: substep}}
materials:
  - {{name: plastic, density: 1200, friction: 0.6, restitution: 0}}
bodies:
  - name: floor
    motion: static
    shapes: [{{type: plane, material: plastic}}]""")
    radius_rate = PITCH / (2 * math.pi)
    angle = START / radius_rate
    for i in range(count):
        radius = radius_rate * angle
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        # The way runs along the tangent (dr/da, r) in polar coordinates.
        yaw = math.fmod(angle + math.atan2(radius, radius_rate), 2 * math.pi)
        place = f"position: [{x:.6f}, {y:.6f}, 0.025], rpy: [0, 0, {yaw:.6f}]"
        if i == 0:
            push = f"velocity: [{0.15 * math.cos(yaw):.6f}, {0.15 * math.sin(yaw):.6f}, 0.03]"
            turn = f"angular_velocity: [{-6 * math.sin(yaw):.6f}, {6 * math.cos(yaw):.6f}, 0]"
            shape = "shapes: &domino [{type: box, size: [0.01, 0.025, 0.05], material: plastic}]"
            print(f"  - {{name: d0, {place}, {push}, {turn}, {shape}}}")
        else:
            print(f"  - {{name: d{i}, {place}, shapes: *domino}}")
        angle += SPACING / math.hypot(radius, radius_rate)


main()
