#!/usr/bin/env python3
"""Scenes that fail, and whether what the program says about them helps.

usage: check_advice.py RIGOR [--rounds N] [--seed K] [--least SHARE] [--jobs N] [--kinds a,b]

Draws scenes of the kinds of `failing_scenes.py`, runs each, and takes those that are refused for their overlaps (exit code 3), stop (4) or
break their audit (1). Of each it takes the advice that the program prints: lines `try --set KEY=VALUE: ...`, `rigor run --separate`, or
words that the scene knows how to obey. It runs the scene again with each until one succeeds. Prints a line a failing scene; exit code 1 if
fewer than 30 scenes failed, or a smaller share than SHARE (five sixths) of them was helped.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import failing_scenes
from measured_runs import Runs

LEAST_FAILURES = 30
PATIENCE = 20  # Processor time of a run [s]; what takes longer did not fail, and did not succeed.


def run(options, runs, path, advice=()):
    """Exit code and all that was printed; 130 if it was not at its end in time."""
    done = runs.call([options.rigor, "run", path, "--cpu-limit", PATIENCE, *advice], 2 * PATIENCE)
    printed = done.stdout + done.stderr
    return (130 if "out of time" in printed else done.returncode), printed


def advice_in(printed, words, folder, name):
    """What the program says is to be tried: how it is called, the scene if it is another, and its arguments."""
    found = [(setting, None, ["--set", setting]) for setting in re.findall(r"^  try --set (\S+):", printed, re.MULTILINE)]
    if "--separate" in printed:
        found.append(("--separate", None, ["--separate"]))
    for number, (phrase, text) in enumerate(words.items()):
        if phrase in printed:
            other = folder / f"{name}-{number}.yaml"
            other.write_text(text)
            found.append((phrase, other, []))
    return found


def try_scene(options, runs, folder, kind, seed):
    """Whether it failed, whether an advice helped, and a line about it."""
    name = f"{kind.__name__}-{seed}"
    path = folder / f"{name}.yaml"
    text, words = failing_scenes.draw_scene(kind, seed, folder)
    path.write_text(text)
    code, printed = run(options, runs, path)
    if code not in (1, 3, 4):
        return False, False, "" if code in (0, 130) else f"{name}: exit {code}: {printed[-300:]}"
    found = advice_in(printed, words, folder, name)
    cure = next((told for told, other, arguments in found if run(options, runs, other or path, arguments)[0] == 0), None)
    method = re.search(r"^method: (.*)", text, re.MULTILINE).group(1)
    return True, cure is not None, f"{name} {method}: exit {code}, " + (f"{cure} helps" if cure else f"nothing of {[told for told, _, _ in found]} helps")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("--rounds", type=int, default=4, help="scenes of each kind")
    parser.add_argument("--seed", type=int, default=0, help="of the first round")
    parser.add_argument("--least", type=float, default=5 / 6, help="share of the failing scenes that is to be helped")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--kinds", type=lambda names: names.split(","), help="names with commas; else all")
    options = parser.parse_args()
    kinds = [kind for kind in failing_scenes.KINDS if not options.kinds or kind.__name__ in options.kinds]
    runs = Runs(options.jobs)
    helped, failed = dict.fromkeys(kinds, 0), dict.fromkeys(kinds, 0)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        work = [(kind, options.seed + k) for k in range(options.rounds) for kind in kinds]
        for (kind, _), (has_failed, is_helped, line) in runs.results(lambda item: try_scene(options, runs, folder, *item), work):
            failed[kind] += has_failed
            helped[kind] += is_helped
            if line:
                print(line, flush=True)
    print(", ".join(f"{kind.__name__} {helped[kind]} of {failed[kind]}" for kind in kinds))
    total, of_them = sum(failed.values()), sum(helped.values())
    print(f"{of_them} of {total} helped; {len(work) - total} of {len(work)} did not fail")
    return 0 if of_them >= options.least * total and total >= LEAST_FAILURES else 1


if __name__ == "__main__":
    sys.exit(main())
