"""Many runs of a program, side by side, and their rows in a CSV file: what the tools that measure share."""
import argparse
import concurrent.futures
import csv
import os
import pathlib
import signal
import subprocess
import sys
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent  # The project's folder, wherever a tool is called from.


METHODS = {  # By the name of a scheme in a study: the scene's method.
    "auto": "{scheme: auto}",
    "event-driven": "{scheme: event-driven}",
    "hybrid": "{scheme: hybrid}",
    "time-stepping": "{scheme: time-stepping, solver: exact}",
    "substep": "{scheme: time-stepping, solver: substep}",
    "impulse-based": "{scheme: impulse-based}",
    "penalty": "{scheme: penalty}",
}


def study_parser(description, schemes):
    """What the studies of random scenes are asked for; their counts they add themselves."""
    parser = argparse.ArgumentParser(description=description.split("\n")[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/rigor"), help="rigor, wherever it lies")
    parser.add_argument("--jobs", type=int, default=1, help="processes side by side")
    parser.add_argument("--seed", type=int, default=1, help="number of the first case")
    parser.add_argument("--schemes", default=schemes, type=lambda names: names.split(","), help="names with commas")
    parser.add_argument("--cpu-limit", type=int, default=20, help="processor time of a run [s]")
    parser.add_argument("--keep", type=pathlib.Path, help="folder in which the scenes of all that was not right are kept")
    return parser


def numbers(values):
    """As a list of a scene."""
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"


def known_rows(path):
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def keep_rows(path, fields, rows):
    """Writes the whole file anew and puts it in the place of the old one: it is whole whenever the tool is killed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(path.name + ".new")
    with new.open("w", newline="") as file:
        writer = csv.DictWriter(file, fields, restval="")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(new, path)


class Runs:
    """Runs of programs by at most `jobs` threads; all of them end with the tool, whatever ends it."""

    def __init__(self, jobs):
        self.jobs, self.running, self.is_over, self.lock = jobs, set(), False, threading.Lock()
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))

    def call(self, command, cpu_limit=None):
        """Runs the program to its end and gives what it said; the kernel ends it after cpu_limit [s] of processor time."""
        limit = "unlimited" if cpu_limit is None else f"{cpu_limit:d}"
        bounded = ["sh", "-c", 'ulimit -S -t "$0" && exec "$@"', limit, *map(str, command)]
        with self.lock:
            if self.is_over:
                raise SystemExit
            process = subprocess.Popen(bounded, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.running.add(process)
        stdout, stderr = process.communicate()
        with self.lock:
            self.running.discard(process)
        return subprocess.CompletedProcess(command, process.returncode, stdout, stderr)

    def results(self, function, work):
        """Of each item of work the item and function(item), in the order in which they end: one thread reads them all."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            items = {pool.submit(function, item): item for item in work}
            try:
                for done in concurrent.futures.as_completed(items):
                    yield items[done], done.result()
            finally:
                pool.shutdown(wait=False, cancel_futures=True)
                self.end_all()

    def end_all(self):
        with self.lock:
            self.is_over = True
            for process in self.running:
                process.kill()
