#!/usr/bin/env python3
"""Solves the break of scenes/studies/break_on_table.yaml in 60 digits and prints when two neighbours part by 1 cm.

usage: tools/break_reference.py [Y...]

Balls without friction and with restitution 1 exchange their velocities along the line of centres; between collisions they move
straight. The next collision is found among all pairs. Independent of the engine.
"""
import re
import sys
from decimal import Decimal, getcontext
from pathlib import Path

getcontext().prec = 60
ZERO, RADIUS = Decimal(0), Decimal("0.028")
WALLS = (Decimal("0.8") - RADIUS, Decimal("0.4") - RADIUS)
STEP, END, BOUND, DELTA = Decimal("0.01"), Decimal("3"), Decimal("0.01"), Decimal("1e-9")


def read_balls():
    text = (Path(__file__).parent.parent / "scenes/studies/break_on_table.yaml").read_text()
    return [[Decimal(x), Decimal(y)] for x, y in re.findall(r"name: (?:cue|ball\d+), position: \[([-\d.e]+), ([-\d.e]+),", text)]


def meeting(p, v, q, w):
    """Time until two balls touch, or None."""
    dx, dy, ux, uy = q[0] - p[0], q[1] - p[1], w[0] - v[0], w[1] - v[1]
    b, a = dx * ux + dy * uy, ux * ux + uy * uy
    if b >= 0:
        return None
    discriminant = b * b - a * (dx * dx + dy * dy - 4 * RADIUS * RADIUS)
    return (-b - discriminant.sqrt()) / a if discriminant > 0 else None


def next_event(x, v):
    best = (None, None, None)
    for i in range(len(x)):
        for k in (0, 1):
            if v[i][k] != 0:
                t = ((WALLS[k] if v[i][k] > 0 else -WALLS[k]) - x[i][k]) / v[i][k]
                if best[0] is None or t < best[0]:
                    best = (t, i, ("wall", k))
        for j in range(i):
            t = meeting(x[i], v[i], x[j], v[j])
            if t is not None and (best[0] is None or t < best[0]):
                best = (t, i, ("ball", j))
    return best


def strike(x, v, i, what):
    if what[0] == "wall":
        v[i][what[1]] = -v[i][what[1]]
        return
    j = what[1]
    n = [x[j][0] - x[i][0], x[j][1] - x[i][1]]
    share = ((v[i][0] - v[j][0]) * n[0] + (v[i][1] - v[j][1]) * n[1]) / (n[0] * n[0] + n[1] * n[1])
    for k in (0, 1):
        v[i][k] -= share * n[k]
        v[j][k] += share * n[k]


def positions(y):
    """Of all balls at each output."""
    x = read_balls()
    x[0][1] = y
    v = [[ZERO, ZERO] for _ in x]
    v[0][0] = Decimal(5)
    t, output, shown = ZERO, ZERO, []
    while output <= END:
        wait, i, what = next_event(x, v)
        while output <= END and output < t + wait:
            shown.append([[p[k] + (output - t) * u[k] for k in (0, 1)] for p, u in zip(x, v)])
            output += STEP
        for p, u in zip(x, v):
            for k in (0, 1):
                p[k] += wait * u[k]
        t += wait
        strike(x, v, i, what)
    return shown


def main():
    for y in map(Decimal, sys.argv[1:] or ["0.002", "0.005", "0.008", "0.011", "0.014"]):
        first, second = positions(y), positions(y + DELTA)
        apart = [max(((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2).sqrt() for p, q in zip(a, b)) for a, b in zip(first, second)]
        horizon = next((k for k, d in enumerate(apart) if d > BOUND), None)
        print(f"y = {y}: horizon {horizon * float(STEP) if horizon is not None else 'inf'} s, distances",
              " ".join(f"{float(apart[k]):.3g}" for k in (50, 100, 150, 200, 250, 300)))


main()
