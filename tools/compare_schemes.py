#!/usr/bin/env python3
"""Runs scenes with all schemes and several steps through `rigor compare`, and makes the table of docs/choosing.md.

Each scene is run with each scheme and with each step: the scene's own run.step times the factors. Output times are the longest
step apart, so that no step is shortened by them. A run is ended after --cpu-limit seconds of processor time. Scenes of more than
--most-bodies dynamic bodies are run by time stepping only (with the solver that they name), and without a reference: every
other scheme is too slow for them at once.

A scene with a scheme is a process of its own, --jobs of them side by side. Its rows are added to the CSV file as soon as it is
done, and what the file holds is not run again: stop or kill the tool and start it again at any time. The file and the table are
in the order of scenes, schemes and factors, whatever the number of jobs. CPU times are a little longer where cores share
caches: measure with as many jobs as there are cores of their own, or one. --table runs nothing and needs no program.

usage: tools/compare_schemes.py [--program RIGOR] [--jobs N] [--csv FILE] [--docs FILE] [--cpu-limit S] [--duration S]
                                [--schemes a,b] [--factors 4,2,1] [--most-bodies N] [--table] [SCENE...]
"""
import argparse
import json
import math
import pathlib
import re
import signal
import statistics
import sys

from measured_runs import ROOT, Runs, keep_rows, known_rows

FIELDS = ["scene", "scheme", "factor", "step", "end", "reason", "end_time", "error", "angle", "good_until",
          "compared_until", "reference", "reference_error", "order", "relative_rise", "max_penetration",
          "max_joint_drift", "impacts", "steps", "cpu_time"]
SCHEMES = ["event-driven", "time-stepping", "penalty", "impulse-based", "hybrid"]  # In the order of the tables.
BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"
WHOLE = ("ok", "audit failed")  # Ends of runs that went to their end.
TOO_SLOW = ("out of time", "hangs", "not tried")
SLACK = 20  # [s] of processor time that a process may take beyond what its runs may.


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path, help="default: all of scenes/")
    parser.add_argument("--program", "--rigor", default=str(ROOT / "build/release/rigor"), help="rigor, wherever it lies")
    parser.add_argument("--jobs", type=int, default=1, help="processes side by side; 1 where CPU times must be exact")
    parser.add_argument("--csv", default="out/schemes.csv", type=pathlib.Path,
                        help="results, kept from one start to the next")
    parser.add_argument("--docs", type=pathlib.Path,
                        help="file whose table between the marks is replaced, such as docs/choosing.md")
    parser.add_argument("--cpu-limit", type=float, default=20, help="processor time of a run [s]")
    parser.add_argument("--duration", type=float, default=5, help="longest simulated time [s]")
    parser.add_argument("--schemes", default=",".join(SCHEMES), help="names with commas")
    parser.add_argument("--factors", default="4,2,1,0.5,0.25,0.125", help="steps in units of the scene's run.step")
    parser.add_argument("--most-bodies", type=int, default=1000,
                        help="dynamic bodies beyond which only time stepping is tried")
    parser.add_argument("--table", action="store_true", help="run nothing: the table of what the CSV file holds")
    options = parser.parse_args()
    options.scenes = options.scenes or sorted((ROOT / "scenes").glob("*.yaml"))
    options.schemes = options.schemes.split(",")
    options.factors = [float(text) for text in options.factors.split(",")]
    return options


def in_order(row):
    """Where a row stands in the file and in the tables."""
    scheme = row["scheme"]
    return row["scene"], SCHEMES.index(scheme) if scheme in SCHEMES else len(SCHEMES), scheme, -float(row["factor"])


def run_setting(path, key, fallback):
    """A number of the scene's line `run: {...}`, or what the scene format has as its default."""
    found = re.search(rf"^run:.*\b{key}: *([-+.\deE]+)", path.read_text(), re.MULTILINE)
    return float(found.group(1)) if found else fallback


def broken_bounds(run):
    """What of the run's audit broke its tolerance."""
    mark = "violated: "
    warnings = run["audit"]["warnings"] if run.get("audit") else []
    return "; ".join(text.removeprefix(mark) for text in warnings if text.startswith(mark))


def exact(value):
    """All digits of a number, or nothing where it is null."""
    return "" if value is None else repr(value)


def rows_of(table, scene, scheme, factors):
    """A row a run, one of each factor."""
    reference = table["references"][0] if table["references"] else None
    own = reference and reference["own_error"]
    for run, factor in zip(table["runs"], factors, strict=True):
        error = run["error"]
        yield {
            "scene": scene, "scheme": scheme, "factor": f"{factor:g}", "step": repr(run["step"]), "end": run["end"],
            "reason": run["reason"] or broken_bounds(run), "end_time": repr(run["end_time"]),
            "error": repr(error["position"]["value"]) if error else "",
            "angle": repr(error["angle"]["value"]) if error else "",
            "good_until": repr(error["good_until"]) if error else "",
            "compared_until": repr(error["compared_until"]) if error else "",
            "reference": reference["name"] if reference else "",
            "reference_error": repr(own["position"]["value"]) if own else "",
            "order": exact(run["order"]),
            "relative_rise": exact(run["relative_rise"]), "max_penetration": repr(run["max_penetration"]),
            "max_joint_drift": repr(run["max_joint_drift"]), "impacts": run["impacts"], "steps": run["steps"],
            "cpu_time": repr(run["cpu_time"])}


def without_runs(options, scene, scheme, end, reason):
    """The rows of a scene with a scheme, where no run can tell anything."""
    return [dict.fromkeys(FIELDS, "") | {"scene": scene, "scheme": scheme, "factor": f"{factor:g}", "end": end,
                                         "reason": reason} for factor in options.factors]


def dynamic_bodies(runs, options, path):
    """How many there are; 0 of a scene that is refused, for `rigor compare` tells why."""
    found = re.search(r"\((\d+) dynamic", runs.call([options.program, "check", path]).stdout)
    return int(found.group(1)) if found else 0


def compare(runs, options, path, scheme):
    """The rows of one scene with one scheme, by one process."""
    bodies = dynamic_bodies(runs, options, path)
    is_large = bodies > options.most_bodies
    if is_large and scheme != "time-stepping":
        return without_runs(options, path.stem, scheme, "not tried", f"not tried with {bodies} dynamic bodies")
    step = run_setting(path, "step", 0.01)
    steps = [factor * step for factor in options.factors]
    duration = min(options.duration, run_setting(path, "duration", 10))
    command = [options.program, "compare", path, "--vary", f"method.scheme={scheme}", "--vary",
               "run.step=" + ",".join(f"{h:.17g}" for h in steps), "--set", f"run.output_interval={max(steps):.17g}",
               "--duration", f"{duration:.17g}", "--cpu-limit", f"{options.cpu_limit:g}", "--json", "-", "--quiet"]
    if is_large:
        command += ["--reference", "none"]
    limit = int(options.cpu_limit * (len(steps) + 4)) + SLACK
    done = runs.call(command, limit)
    try:
        return list(rows_of(json.loads(done.stdout), path.stem, scheme, options.factors))
    except json.JSONDecodeError:
        # All its runs are refused, or the program has ended in a way that it should not.
        said = done.stderr.strip().splitlines()
        if done.returncode == -signal.SIGXCPU:
            return without_runs(options, path.stem, scheme, "hangs", f"no answer after {limit} s")
        end = "refused" if done.returncode == 3 else f"exit {done.returncode}"
        return without_runs(options, path.stem, scheme, end, said[0] if said else "")


def add_missing(options, rows):
    """Runs what the rows lack, and keeps the file up to date."""
    known = {(row["scene"], row["scheme"], row["factor"]) for row in rows}
    missing = [(path, scheme) for path in options.scenes for scheme in options.schemes
               if any((path.stem, scheme, f"{factor:g}") not in known for factor in options.factors)]
    runs = Runs(options.jobs)
    for (path, scheme), made in runs.results(lambda item: compare(runs, options, *item), missing):
        # All factors were run: the order of a run is told against its neighbour.
        new = [row for row in made if (row["scene"], row["scheme"], row["factor"]) not in known]
        rows += new
        keep_rows(options.csv, FIELDS, sorted(rows, key=in_order))
        print(f"{path.stem} {scheme}: " + ", ".join(row["end"] for row in new), file=sys.stderr, flush=True)


def number(text):
    """The number, or nothing where there is none; older files have None there."""
    value = float(text) if text not in ("", "None", None) else math.nan
    return value if math.isfinite(value) else None


def numbers(rows, key):
    return [value for value in (number(row[key]) for row in rows) if value is not None]


def cell(values, pick):
    return f"{pick(values):.2g}" if values else "-"


def ratios(rows, base):
    """CPU time of each whole run over that of the event-driven one of the same scene at the scene's own step."""
    found = []
    for row in rows:
        mine, other = number(row["cpu_time"]), base.get(row["scene"])
        if mine and other:
            found.append(mine / other)
    return found


def rates(rows, key):
    """Of each run, how many a simulated second."""
    pairs = [(number(row[key]), number(row["end_time"])) for row in rows]
    return [count / end for count, end in pairs if count is not None and end]


def outcome(row):
    """What came of a run, in a word."""
    if row["end"] in TOO_SLOW:
        return "too slow"
    return {"ok": "runs", "audit failed": "audit", "refused": "refuses"}.get(row["end"], "stops")


def summary(rows, base):
    """A line a scheme: how its runs ended, and how often it solves the sub-problems of the dynamics."""
    lines = ["| scheme | runs | whole | audit failed | refused | too slow | stopped | impacts a second | steps a second | "
             "CPU time over event-driven |", "|---|---|---|---|---|---|---|---|---|---|"]
    for scheme in dict.fromkeys(row["scheme"] for row in rows):
        own = [row for row in rows if row["scheme"] == scheme]
        ends = [outcome(row) for row in own]
        good = [row for row in own if row["end"] in WHOLE and row["factor"] == "1"]
        lines.append(f"| {scheme} | {len(own)} | {ends.count('runs')} | {ends.count('audit')} | {ends.count('refuses')} | "
                     f"{ends.count('too slow')} | {ends.count('stops')} | {spread(rates(good, 'impacts'))} | "
                     f"{spread(rates(good, 'steps'))} | {spread(ratios(good, base))} |")
    return "\n".join(lines) + "\n"


def spread(values):
    """Median, and the largest."""
    return f"{statistics.median(values):.3g}, {max(values):.2g}" if values else "-"


def by_step(rows, base):
    """A line a scheme and step: errors, energy, penetration, CPU time of the runs that went to their end."""
    lines = ["| scheme | step | scenes | whole | refused | ended early | error, median [m] | order, median | rise of energy, "
             "largest | penetration, largest [m] | CPU time over event-driven, median |",
             "|---|---|---|---|---|---|---|---|---|---|---|"]
    for scheme in dict.fromkeys(row["scheme"] for row in rows):
        own = [row for row in rows if row["scheme"] == scheme]
        for factor in sorted({row["factor"] for row in own}, key=float, reverse=True):
            here = [row for row in own if row["factor"] == factor]
            good = [row for row in here if row["end"] in WHOLE]
            refused = sum(row["end"] == "refused" for row in here)
            lines.append(
                f"| {scheme} | {factor} | {len(here)} | {len(good)} | {refused} | {len(here) - len(good) - refused} | "
                f"{cell(numbers(good, 'error'), statistics.median)} | {cell(numbers(good, 'order'), statistics.median)} | "
                f"{cell(numbers(good, 'relative_rise'), max)} | {cell(numbers(good, 'max_penetration'), max)} | "
                f"{cell(ratios(good, base), statistics.median)} |")
    return "\n".join(lines) + "\n"


def matrix(rows):
    """A line a scene: what came of each scheme at the scene's own step; the reasons stand below."""
    schemes = list(dict.fromkeys(row["scheme"] for row in rows))
    own = {(row["scene"], row["scheme"]): row for row in rows if row["factor"] == "1"}
    reasons = []

    def entry(row):
        if row is None:
            return "-"
        word = outcome(row)
        if word in ("runs", "too slow") or not row["reason"]:
            return word
        # Where the scene says so is left out, and so are the numbers of an audit.
        reason = re.sub(r"^(error: )?\S+\.yaml:\d+:\d+: ", "", row["reason"])
        reason = "; ".join(part.split(" is ")[0] for part in reason.split("; ")) if word == "audit" else reason
        if reason not in reasons:
            reasons.append(reason)
        return f"{word} ({reasons.index(reason) + 1})"

    lines = ["| scene | " + " | ".join(schemes) + " |", "|---" * (len(schemes) + 1) + "|"]
    for scene in dict.fromkeys(row["scene"] for row in rows):
        lines.append(f"| {scene} | " + " | ".join(entry(own.get((scene, scheme))) for scheme in schemes) + " |")
    return "\n".join(lines) + "\n\n" + "".join(f"{i}. {reason}\n" for i, reason in enumerate(reasons, 1))


def markdown(rows):
    base = {row["scene"]: number(row["cpu_time"])
            for row in rows if row["end"] in WHOLE and row["scheme"] == "event-driven" and row["factor"] == "1"}
    text = (summary(rows, base) + "\nBy step:\n\n" + by_step(rows, base) +
            "\nBy scene, at its own step:\n\n" + matrix(rows))
    return text.rstrip("\n") + "\n"


def write_docs(path, table):
    text = path.read_text()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit(f"{path}: must have the lines {BEGIN} and {END}, once each")
    head, rest = text.split(BEGIN)
    path.write_text(head + BEGIN + "\n" + table + END + rest.split(END)[1])


def main():
    options = arguments()
    rows = known_rows(options.csv)
    if not options.table:
        add_missing(options, rows)
    table = markdown(sorted(rows, key=in_order))
    if options.docs:
        write_docs(options.docs, table)
    else:
        print(table, end="")


if __name__ == "__main__":
    main()
