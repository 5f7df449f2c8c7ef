#!/usr/bin/env python3
"""Writes the scene of a bridge of hinged planks that sags between two banks, and crates that fall on it.

usage: tools/plank_bridge_scene.py PLANKS > scenes/plank_bridge.yaml
"""
import math
import sys

SPAN, SAG = 18.0, 1.5


def main():
    count = int(sys.argv[1])
    # The hinges are on an arc through both banks, SAG below them in the middle.
    radius = (SPAN * SPAN / 4 + SAG * SAG) / (2 * SAG)
    half = math.asin(SPAN / 2 / radius)
    angles = [half * (2 * i / count - 1) for i in range(count + 1)]
    hinges = [(radius * math.sin(a), radius * (math.cos(half) - math.cos(a))) for a in angles]
    length = 2 * radius * math.sin(half / count)
    print(f"""# A bridge of {count} planks, hinged to each other and to both banks, {SPAN:g} m apart; 60 crates fall on it.
#
# Observe: waves run along the bridge and die out under the crates; some crates slide off into the gorge.
# Expect:  the hinges hold to a millimetre, and no crate falls through the planks.
#          Written by tools/plank_bridge_scene.py.
rigor: 1
name: plank-bridge
world: {{gravity: [0, 0, -9.81]}}
run: {{duration: 10, step: 0.016666666666666666, output_interval: 0.05}}
method: {{scheme: time-stepping, solver: substep}}
materials:
  - {{name: wood, density: 600, friction: 0.6, restitution: 0}}
bodies:
  - {{name: gorge, motion: static, shapes: [{{type: plane, normal: [0, 0, 1], offset: -8, material: wood}}]}}
  - {{name: west, motion: static, position: [{-SPAN / 2 - 2.1:g}, 0, -4], shapes: [{{type: box, size: [4, 4, 8], material: wood}}]}}
  - {{name: east, motion: static, position: [{SPAN / 2 + 2.1:g}, 0, -4], shapes: [{{type: box, size: [4, 4, 8], material: wood}}]}}
  - name: crate
    position: [-4.5, -0.45, 1.5]
    rpy: [0.2, 0.3, 0.1]
    shapes: [{{type: box, size: [0.5, 0.5, 0.5], material: wood}}]
    repeat: {{count: [10, 2, 3], spacing: [1, 0.9, 0.9], jitter: 0.05}}""")
    for i in range(count):
        (x0, z0), (x1, z1) = hinges[i], hinges[i + 1]
        pitch = -math.atan2(z1 - z0, x1 - x0)
        shapes = (f"&plank [{{type: box, size: [{length - 0.02:.6f}, 2, 0.06], material: wood}}]" if i == 0 else "*plank")
        print(f"  - {{name: plank{i + 1}, position: [{(x0 + x1) / 2:.9f}, 0, {(z0 + z1) / 2:.9f}], rpy: [0, {pitch:.9f}, 0], "
              f"shapes: {shapes}}}")
    print("joints:")
    for i, (x, z) in enumerate(hinges):
        a = "world" if i == 0 else f"plank{i}"
        b = "world" if i == count else f"plank{i + 1}"
        print(f"  - {{name: hinge{i}, type: hinge, bodies: [{a}, {b}], anchor: [{x:.9f}, 0, {z:.9f}], axis: [0, 1, 0]}}")


main()
