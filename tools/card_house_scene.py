#!/usr/bin/env python3
"""Writes the scene of a card house: storeys of leaning pairs of cards, with one long flat card on the peaks of each.

usage: tools/card_house_scene.py STOREYS TILT_DEG FRICTION > scenes/card_house.yaml

The tops of a pair are cut so that the two cards meet in a plane: two sharp edges would have no normal.
"""
import math
import sys

LENGTH, WIDTH, THICKNESS, CUT = 0.09, 0.06, 0.001, 0.0003  # [m]; how far the cut is from the sharp edge


def profile(tilt):
    """Corners (x, z) of the left card of a pair: it stands on its inner edge at (-x, 0) and meets its partner at x = 0."""
    s, c = math.sin(tilt), math.cos(tilt)
    foot, outer = (0.0, 0.0), (-THICKNESS * c, THICKNESS * s)
    sharp, peak = (LENGTH * s, LENGTH * c), (LENGTH * s - THICKNESS * c, LENGTH * c + THICKNESS * s)
    low = (sharp[0] - CUT, sharp[1] - CUT * c / s)
    high = (sharp[0] - CUT, sharp[1] + CUT * s / c)
    return [(x - low[0], z) for x, z in (foot, low, high, peak, outer)]


def centroid(corners):
    """Of the polygon, counter-clockwise."""
    area = x = z = 0.0
    for (x0, z0), (x1, z1) in zip(corners, corners[1:] + corners[:1]):
        cross = x0 * z1 - x1 * z0
        area, x, z = area + cross / 2, x + (x0 + x1) * cross / 6, z + (z0 + z1) * cross / 6
    return x / area, z / area


def main():
    storeys, tilt, friction = int(sys.argv[1]), math.radians(float(sys.argv[2])), sys.argv[3]
    corners = profile(tilt)
    foot, high, peak = corners[0], corners[2], corners[3]
    # Of a single pair: moments about the foot of the weight and of the push, which acts at the highest point of the cut.
    least = (centroid(corners)[0] - foot[0]) / high[1]
    print(f"""# A card house of {storeys} storeys: {storeys * (storeys + 1)} leaning cards at {sys.argv[2]} degrees and {storeys - 1} flat ones.
#
# Observe: cards lean on each other and stand by friction alone, without sleeping.
# Expect:  displacement 0 after 10 s. The pair at the top carries nothing: it stands if friction is above {least!r}
#          (about half the slope of the cards) and slides apart below. Written by tools/card_house_scene.py.
rigor: 1
name: card-house
world: {{gravity: [0, 0, -9.81]}}
run: {{duration: 10, step: 0.01, output_interval: 0.1}}
materials:
  - {{name: card, density: 1000, friction: {friction}, restitution: 0}}
bodies:
  - name: table
    motion: static
    shapes: [{{type: plane, material: card}}]""")
    pitch, floor = LENGTH, 0.0
    for storey in range(storeys):
        pairs = storeys - storey
        for pair in range(pairs):
            middle = (pair - (pairs - 1) / 2) * pitch
            for side, name in ((1, "left"), (-1, "right")):
                vertices = [[side * x, y, z] for y in (-WIDTH / 2, WIDTH / 2) for x, z in corners]
                print(f"""  - name: {name}{storey + 1}_{pair + 1}
    position: [{middle!r}, 0, {floor!r}]
    shapes:
      - type: convex
        material: card
        vertices: {vertices!r}""")
        if pairs > 1:
            print(f"""  - name: flat{storey + 1}
    position: [0, 0, {floor + peak[1] + THICKNESS / 2!r}]
    shapes: [{{type: box, size: [{round((pairs - 0.9) * pitch, 9)}, {WIDTH}, {THICKNESS}], material: card}}]""")
        floor += peak[1] + THICKNESS


main()
