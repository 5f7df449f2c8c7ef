#!/usr/bin/env python3
"""Runs the program on random jointed scenes and on changed scenes, meshes, checkpoints and trajectories: it must end by
itself with one of its exit codes and a reason, or by SIGTERM within a second, and every number that it writes is one.

    tools/fuzz_program.py PROGRAM [--scenes N] [--files N] [--seed S] [--jobs J] [--patience S]

Exit code 1 if anything else happens; the inputs of it are kept.
"""
import argparse
import collections
import concurrent.futures
import csv
import math
import pathlib
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

import hostile_joints
from measured_runs import ROOT

MOST_SECONDS_TO_END = 1.0
CODES = {0, 1, 2, 3, 4, 5, 130}


def run(program, arguments, patience):
    """Exit code, its errors, and the seconds from SIGTERM to the end if it was needed."""
    process = subprocess.Popen([program, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        errors = process.communicate(timeout=patience)[1]
        return process.returncode, errors, 0.0
    except subprocess.TimeoutExpired:
        pass
    begin = time.monotonic()
    process.send_signal(signal.SIGTERM)
    try:
        errors = process.communicate(timeout=20)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        errors = process.communicate()[1]
    return process.returncode, errors, time.monotonic() - begin


def trouble_of(code, errors, seconds):
    # While it loads and checks, a signal ends the program at once.
    was_ended = seconds > 0 and code == -signal.SIGTERM
    if code not in CODES and not was_ended:
        return f"exit code {code}: {errors[-300:]!r}"
    if code in (2, 3, 4, 5) and b"error: " not in errors:
        return f"exit code {code} without a reason"
    if b"broken promise" in errors:
        return "broken promise: " + errors.decode(errors="replace")[:300]
    return f"{seconds:.2f} s from SIGTERM to the end" if seconds > MOST_SECONDS_TO_END else ""


def row_trouble(names, values):
    """Forces of joints may be missing, all else is numbers."""
    if len(values) != len(names):
        return f"a row of {len(values)} values under {len(names)} names"
    for name, value in zip(names, values):
        if not math.isfinite(float(value)) and ".force." not in name and ".torque." not in name:
            return f"{name} is {value}"
    return ""


def rows_trouble(path):
    """Of a trajectory in CSV."""
    if not path.exists():
        return ""
    with path.open(newline="") as file:
        rows = csv.reader(file)
        names = next(rows, [])
        return next(filter(None, (row_trouble(names, values) for values in rows)), "")


def try_scene(program, folder, seed, patience):
    path, rows = folder / f"{seed}.yaml", folder / f"{seed}.csv"
    path.write_text(hostile_joints.scene(seed))
    code, errors, seconds = run(program, ["run", path, "--quiet", "-o", rows], patience)
    trouble = trouble_of(code, errors, seconds) or rows_trouble(rows)
    rows.unlink(missing_ok=True)
    if not trouble:
        path.unlink()
    return path, trouble, code


def fnv1a(data):
    value = 14695981039346656037
    for byte in data:
        value = (value ^ byte) * 1099511628211 % 2 ** 64
    return value


def signed(data):
    """A checkpoint with its two checksums made right: of the State, which ends it, and of the whole."""
    data = bytearray(data)
    state = data.rfind(b"RIGORST\x1a")
    if len(data) < 24:
        return bytes(data)
    if state >= 0 and len(data) - 16 > state:
        data[-16:-8] = struct.pack("<Q", fnv1a(data[state:-16]))
    data[-8:] = struct.pack("<Q", fnv1a(data[:-8]))
    return bytes(data)


def changed(draw, data):
    data = bytearray(data)
    for _ in range(draw.randint(1, 5)):
        if not data:
            break
        at, length = draw.randrange(len(data)), draw.randint(1, 40)
        kind = draw.randrange(7)
        if kind == 0:
            del data[at:at + length]
        elif kind == 1:
            data[at:at] = data[at // 2:at // 2 + length]
        elif kind == 2:
            data[at] ^= 1 << draw.randrange(8)
        elif kind == 3:
            data[at] = draw.choice(b"0123456789.,-+eE:[]{}#nai \n")
        elif kind == 4 and len(data) >= 8:
            at = at // 8 * 8 % (len(data) - 7)
            data[at:at + 8] = struct.pack("<d", draw.choice([math.nan, math.inf, -9e16, 1e300, -1.0, 1e-320]))
        else:
            data[at] = draw.randrange(256)
    return bytes(data)


def seeds(program, folder):
    """Files that are good, each with the arguments that read it; {} is its name."""
    found = [(path.read_bytes(), ".yaml", ["check", "{}"], False) for path in sorted((ROOT / "scenes").glob("*.yaml"))]
    found += [(path.read_bytes(), path.suffix, ["mass", "{}"], False)
              for path in sorted((ROOT / "tests/data/meshes").iterdir()) if path.stat().st_size < 100000]
    for name in ("double_pendulum", "bouncing_ball", "cradle", "dominoes"):
        scene = ROOT / "scenes" / f"{name}.yaml"
        checkpoint, trajectory = folder / f"{name}.cp", folder / f"{name}.h5"
        subprocess.run([program, "run", scene, "--quiet", "--duration", "0.1", "--checkpoint", checkpoint, "-o", trajectory], check=True)
        found.append((checkpoint.read_bytes(), ".cp", ["run", scene, "--quiet", "--duration", "0.15", "--resume", "{}"], True))
        found.append((trajectory.read_bytes(), ".h5", ["plot", "{}", "energy.total", "-o", "{}.svg"], False))
    return found


def try_file(program, folder, good, number, seed, patience):
    data, suffix, arguments, is_signed = good
    draw = random.Random(seed * 1000003 + number)
    bad = changed(draw, data)
    if is_signed and draw.random() < 0.9:
        bad = signed(bad[:8 + 8 * ((len(bad) - 8) // 8)])
    path = folder / f"{number}{suffix}"
    path.write_bytes(bad)
    code, errors, seconds = run(program, [str(word).format(path) for word in arguments], patience)
    trouble = trouble_of(code, errors, seconds)
    pathlib.Path(f"{path}.svg").unlink(missing_ok=True)
    if not trouble:
        path.unlink()
    return path, trouble, code


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("--scenes", type=int, default=2000)
    parser.add_argument("--files", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--patience", type=float, default=2.0, help="before SIGTERM [s]")
    options = parser.parse_args()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="rigor_fuzz_"))
    good = seeds(options.program, folder) if options.files > 0 else []
    draw = random.Random(options.seed)
    picks = [draw.choice(good) for _ in range(options.files)] if good else []
    troubles = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        groups = {
            "jointed scenes": [pool.submit(try_scene, options.program, folder, options.seed * 1000000 + i, options.patience)
                               for i in range(options.scenes)],
            "changed files": [pool.submit(try_file, options.program, folder, pick, i, options.seed, options.patience)
                              for i, pick in enumerate(picks)]}
        for name, calls in groups.items():
            codes = collections.Counter()
            for call in concurrent.futures.as_completed(calls):
                path, trouble, code = call.result()
                codes[code] += 1
                if trouble:
                    troubles += 1
                    print(f"{path}: {trouble}", file=sys.stderr, flush=True)
            told = ", ".join(f"{count} with {code}" for code, count in sorted(codes.items()))
            print(f"{name}: {len(calls)} runs; exit codes: {told}")
    if troubles:
        print(f"{troubles} of them did what they must not; their inputs are in {folder}", file=sys.stderr)
        return 1
    shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
