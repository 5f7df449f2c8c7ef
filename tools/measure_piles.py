#!/usr/bin/env python3
"""Runs the random dissipative piles of tools/random_pile_scene.py over their 5 s, and tells what their audits say.

One run after the other, by the benchmark rigor_scene_runs; a line a run is added to the CSV file, and what the file
holds is not run again. Ends with a table of the largest values of each scheme.

usage: tools/measure_piles.py [--program PROGRAM] [--csv FILE] [--cpu-limit S] [--seeds A-B] [--restitution E]
                              [--set KEY=VALUE]... [SCHEME...]
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

from random_pile_scene import pile

SCHEMES = ["time-stepping", "event-driven", "hybrid", "penalty"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("schemes", nargs="*", metavar="SCHEME", help="default: " + " ".join(SCHEMES))
    parser.add_argument("--program", default="build/bench/benchmarks/rigor_scene_runs")
    parser.add_argument("--csv", default="out/piles.csv", help="results, kept from one start to the next")
    parser.add_argument("--cpu-limit", type=float, default=600, help="processor time of a run [s]")
    parser.add_argument("--seeds", default="0-39", help="first and last")
    parser.add_argument("--restitution", type=float, default=0)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="as of rigor run")
    return parser.parse_args()


def known_rows(path):
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def run(options, seed, scheme):
    """The row of one run; of a program that failed, what there is of it."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / f"pile-{seed}.yaml"
        scene.write_text(pile(seed, options.restitution))
        command = [options.program, str(scene), "--cpu-limit", f"{options.cpu_limit:g}"]
        for override in [f"method.scheme={scheme}", *options.set]:
            command += ["--set", override]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    rows = list(csv.DictReader(done.stdout.splitlines()))
    return rows[0] if rows else {"scene": f"pile-{seed}", "scheme": scheme, "end": f"exit {done.returncode}"}


def add_row(path, row):
    path.parent.mkdir(parents=True, exist_ok=True)
    is_new = not path.exists()
    with path.open("a", newline="") as file:
        writer = csv.DictWriter(file, row)
        if is_new:
            writer.writeheader()
        writer.writerow(row)


def table(rows, schemes):
    """Of each scheme the largest values of the runs that went to their end."""
    yield "| scheme | piles to the end | rise of energy | deepest overlap [m] | in the last second [m] | fallbacks | residual | CPU time [s] |"
    yield "|---|---|---|---|---|---|---|---|"
    for scheme in schemes:
        own = [row for row in rows if row["scheme"] == scheme]
        whole = [row for row in own if row["end"] in ("ok", "audit failed")]
        if not whole:
            continue

        def largest(key):
            return max(float(row[key]) for row in whole)

        fallbacks = sum(int(row["fallbacks"]) for row in whole)
        cpu = sum(float(row["cpu_time"]) for row in whole)
        yield (f"| {scheme} | {len(whole)} of {len(own)} | {largest('relative_rise'):.2g} | {largest('overlap'):.2g} | "
               f"{largest('last_overlap'):.2g} | {fallbacks} | {largest('residual'):.2g} | "
               f"{cpu:.0f}, {largest('cpu_time'):.1f} at most |")


def main():
    options = arguments()
    path = pathlib.Path(options.csv)
    schemes = options.schemes or SCHEMES
    first, last = (int(part) for part in options.seeds.split("-"))
    known = {(row["scene"], row["scheme"]) for row in known_rows(path)}
    for scheme in schemes:
        for seed in range(first, last + 1):
            if (f"pile-{seed}", scheme) in known:
                continue
            row = run(options, seed, scheme)
            add_row(path, row)
            print(",".join(str(value) for value in row.values()), flush=True)
    print("\n".join(table(known_rows(path), schemes)))


if __name__ == "__main__":
    sys.exit(main())
