#!/usr/bin/env python3
"""Runs the random dissipative piles of tools/random_pile_scene.py over their 5 s, and tells what their audits say.

Each run is a process of the benchmark rigor_scene_runs, --jobs of them side by side; its row is added to the CSV file as soon as
it is done, and what the file holds is not run again: stop or kill the tool and start it again at any time. The file and the
table are in the order of schemes and seeds, whatever the number of jobs. Ends with a table of the largest values of each scheme;
--table runs nothing and makes that table of what the file holds.

usage: tools/measure_piles.py [--program RIGOR_SCENE_RUNS] [--jobs N] [--csv FILE] [--cpu-limit S] [--seeds A-B] [--restitution E]
                              [--set KEY=VALUE]... [--table] [SCHEME...]
"""
import argparse
import csv
import pathlib
import sys
import tempfile

from measured_runs import ROOT, Runs, keep_rows, known_rows
from random_pile_scene import pile

SCHEMES = ["time-stepping", "event-driven", "hybrid", "penalty"]
FIELDS = ["scene", "scheme", "end", "end_time", "relative_rise", "mean_square_energy_error", "overlap", "last_overlap",
          "fallbacks", "coarse_steps", "residual", "impacts", "steps", "cpu_time"]  # As rigor_scene_runs names them.


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("schemes", nargs="*", metavar="SCHEME", help="default: " + " ".join(SCHEMES))
    parser.add_argument("--program", default=str(ROOT / "build/bench/benchmarks/rigor_scene_runs"),
                        help="rigor_scene_runs, wherever it lies")
    parser.add_argument("--jobs", type=int, default=1, help="runs side by side; 1 where CPU times must be exact")
    parser.add_argument("--csv", default="out/piles.csv", type=pathlib.Path,
                        help="results, kept from one start to the next")
    parser.add_argument("--cpu-limit", type=float, default=600, help="processor time of a run [s]")
    parser.add_argument("--seeds", default="0-39", help="first and last")
    parser.add_argument("--restitution", type=float, default=0)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="as of rigor run")
    parser.add_argument("--table", action="store_true", help="run nothing: the table of what the CSV file holds")
    options = parser.parse_args()
    options.schemes = options.schemes or SCHEMES
    return options


def in_order(row):
    """Where a row stands in the file: schemes as the tables have them, then seeds."""
    scheme = row["scheme"]
    return SCHEMES.index(scheme) if scheme in SCHEMES else len(SCHEMES), scheme, int(row["scene"].removeprefix("pile-"))


def run(runs, options, scheme, seed):
    """The row of one run; of a program that failed, what there is of it."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / f"pile-{seed}.yaml"
        scene.write_text(pile(seed, options.restitution))
        command = [options.program, scene, "--cpu-limit", f"{options.cpu_limit:g}"]
        for override in [f"method.scheme={scheme}", *options.set]:
            command += ["--set", override]
        done = runs.call(command)
    rows = list(csv.DictReader(done.stdout.splitlines()))
    empty = dict.fromkeys(FIELDS, "")
    return empty | (rows[0] if rows else {"scene": f"pile-{seed}", "scheme": scheme, "end": f"exit {done.returncode}"})


def add_missing(options, rows):
    """Runs what the rows lack, and keeps the file up to date."""
    first, last = (int(part) for part in options.seeds.split("-"))
    known = {(row["scene"], row["scheme"]) for row in rows}
    missing = [(scheme, seed) for scheme in options.schemes for seed in range(first, last + 1)
               if (f"pile-{seed}", scheme) not in known]
    runs = Runs(options.jobs)
    for _, row in runs.results(lambda item: run(runs, options, *item), missing):
        rows.append(row)
        keep_rows(options.csv, FIELDS, sorted(rows, key=in_order))
        print(",".join(row.values()), file=sys.stderr, flush=True)


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
    rows = known_rows(options.csv)
    if not options.table:
        add_missing(options, rows)
    print("\n".join(table(sorted(rows, key=in_order), options.schemes)))


if __name__ == "__main__":
    main()
