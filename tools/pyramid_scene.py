#!/usr/bin/env python3
"""Writes the scene of a wall of boxes that narrows by half a box a side each row.

usage: tools/pyramid_scene.py ROWS > scenes/pyramid.yaml
"""
import sys


def main():
    rows = int(sys.argv[1])
    print(f"""# A pyramid of {rows * (rows + 1) // 2} boxes of 1 m in {rows} rows, boxes of a row 5 cm apart.
#
# Observe: the load grows downwards and outwards; nothing but friction and the boxes themselves holds it.
# Expect:  it stands: after 10 s no box has come down by more than a hundredth of the pyramid's height.
#          Written by tools/pyramid_scene.py.
rigor: 1
name: pyramid
world: {{gravity: [0, 0, -9.81]}}
run: {{duration: 10, step: 0.016666666666666666, output_interval: 0.1}}
method: {{scheme: time-stepping, solver: substep, substeps: 8}}
materials:
  - {{name: concrete, density: 1000, friction: 0.5, restitution: 0}}
bodies:
  - name: ground
    motion: static
    shapes: [{{type: plane, material: concrete}}]""")
    for row in range(rows):
        shapes = "&box [{type: box, size: [1, 1, 1], material: concrete}]" if row == 0 else "*box"
        print(f"  - {{name: row{row + 1}, position: [{-0.525 * (rows - row - 1):g}, 0, {row + 0.5}], shapes: {shapes}, "
              f"repeat: {{count: [{rows - row}, 1, 1], spacing: [1.05, 0, 0]}}}}")


main()
