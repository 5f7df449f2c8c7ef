"""Many runs of a program, side by side, and their rows in a CSV file: what the tools that measure share."""
import concurrent.futures
import csv
import os
import pathlib
import signal
import subprocess
import sys
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent  # The project's folder, wherever a tool is called from.


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
