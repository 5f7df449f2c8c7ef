#!/usr/bin/env python3
"""Writes scenes/chain_reaction.yaml: a swing, thirteen growing dominoes, a ball on a slide, a tower of cubes.

usage: tools/chain_reaction_scene.py > scenes/chain_reaction.yaml
"""
import math

COLORS = ["#c2410c", "#ea580c", "#f59e0b", "#eab308", "#84cc16", "#22c55e", "#10b981", "#14b8a6", "#06b6d4", "#0ea5e9",
          "#3b82f6", "#6366f1", "#8b5cf6"]
FLOOR = -0.3  # The top of the table is at 0 [m].
SWING = {"pivot": (-0.025, 0.32), "length": 0.28, "radius": 0.02}
BALL = 0.045  # Radius [m].
SLIDE = {"angle": 22, "length": 0.5}
CUBE = 0.05


def dominoes():
    """Centre x and height of each: 9 % taller than the one before."""
    x, height = 0.0, 0.05
    for _ in COLORS:
        yield x, round(height, 4)
        x += 0.75 * height
        height *= 1.09


def row(name, position, shape, color, rest=""):
    x, y, z = position
    print(f"  - {{name: {name}, position: [{x:.6g}, {y:.6g}, {z:.6g}], shapes: [{{{shape}, color: \"{color}\"}}]{rest}}}")


def plank(position, size, color, angle=0):
    turned = f"rpy: [0, {angle} deg, 0], " if angle else ""
    x, y, z = position
    print(f"      - {{type: box, position: [{x:.6g}, {y:.6g}, {z:.6g}], {turned}size: [{size[0]:.6g}, {size[1]}, {size[2]}],"
          f" material: wood, color: \"{color}\"}}")


def main():
    row_of = list(dominoes())
    last_x, last_height = row_of[-1]
    ball_x = last_x + 0.62 * last_height
    edge = ball_x + 0.004
    print("""# A swing strikes the first of thirteen dominoes, each 9 % taller than the one before; the last pushes a ball off the
# table, which rolls down a slide into a tower of fourteen cubes.
#
# Observe: the wave grows as it runs; `auto` follows it from event to event until events crowd, then in equal steps.
# Expect:  the swing strikes after a quarter of its period, at 0.28480 s; all dominoes fall, and the tower.
#          Written by tools/chain_reaction_scene.py.
rigor: 1
name: chain-reaction
world: {gravity: [0, 0, -9.81]}
run: {duration: 3.2, step: 0.01, output_interval: 0.02}
materials:
  - {name: wood, density: 700, friction: 0.5}
  - {name: stone, density: 2500, friction: 0.4}
  - {name: steel, density: 7850, friction: 0.3}
bodies:
  - name: ground
    motion: static""")
    print(f"    shapes: [{{type: plane, offset: {FLOOR}, material: wood, color: \"#d8d2c4\"}}]")
    print("  - name: table\n    motion: static\n    shapes:")
    plank(((edge - 0.15) / 2, 0, -0.01), (edge + 0.15, 0.2, 0.02), "#a9825a")
    plank((-0.12, 0, -0.16), (0.02, 0.16, 0.28), "#8a6a48")
    plank((edge - 0.06, 0, -0.16), (0.02, 0.16, 0.28), "#8a6a48")

    angle, length = math.radians(SLIDE["angle"]), SLIDE["length"]
    x, z = edge + math.cos(angle) * length / 2, -0.08 - math.sin(angle) * length / 2
    print("  - name: slide\n    motion: static\n    shapes:")
    plank((x, 0, z - 0.01), (length, 0.16, 0.02), "#a9825a", SLIDE["angle"])
    for y in (0.085, -0.085):
        plank((x, y, z + 0.01), (length, 0.01, 0.06), "#8a6a48", SLIDE["angle"])

    swing_x = SWING["pivot"][0] - SWING["length"] * math.sin(math.pi / 3)
    swing_z = SWING["pivot"][1] - SWING["length"] / 2
    print(f"  - {{name: swing, position: [{swing_x:.12g}, 0, {swing_z:.12g}], shapes: "
          f"[{{type: sphere, radius: {SWING['radius']}, material: steel, color: \"#4a5568\"}}]}}")
    for i, (x, height) in enumerate(row_of):
        size = f"[{0.2 * height:.6g}, {0.5 * height:.6g}, {height:.6g}]"
        row(f"domino{i + 1}", (x, 0, height / 2), f"type: box, size: {size}, material: wood", COLORS[i])
    row("ball", (ball_x, 0, BALL), f"type: sphere, radius: {BALL}, material: stone", "#dc2626")
    tower = edge + math.cos(angle) * length + 0.22
    for i in range(14):
        level, side = divmod(i, 2)
        row(f"cube{i + 1}", (tower, (side - 0.5) * (CUBE + 0.002), FLOOR + CUBE * (level + 0.5)),
            f"type: box, size: [{CUBE}, {CUBE}, {CUBE}], material: wood", COLORS[i % len(COLORS)])
    print("joints:")
    for side, y in (("left", 0.06), ("right", -0.06)):
        print(f"  - {{name: {side}, type: distance, bodies: [world, swing], anchors: "
              f"[[{SWING['pivot'][0]}, {y}, {SWING['pivot'][1]}], [{swing_x:.12g}, 0, {swing_z:.12g}]]}}")


main()
