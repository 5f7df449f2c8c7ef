#!/usr/bin/env python3
"""Writes the heights of scenes/terrain.yaml: z = 0.1 (2 + cos kx + cos ky), k = 2 pi / 1.2, on 2.4 m by 2.4 m in steps of 0.1 m.

Each cosine is rounded to a micrometre before they are added, so that the four corners of each cell lie in a plane.

usage: tools/make_hills.py [FILE]     (default: scenes/heights/hills.csv)
"""
import math
import pathlib
import sys

AMPLITUDE, WAVELENGTH, SIZE, CELLS = 0.1, 1.2, 2.4, 24


def micrometres(i):
    x = SIZE * (i / CELLS - 0.5)
    return round(1e6 * AMPLITUDE * (1 + math.cos(2 * math.pi * x / WAVELENGTH)))


def main():
    waves = [micrometres(i) for i in range(CELLS + 1)]
    lines = [",".join(f"{(a + b) / 1e6:.6g}" for b in waves) for a in waves]
    pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "scenes/heights/hills.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
