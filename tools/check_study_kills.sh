#!/usr/bin/env bash
# Kills a study with SIGKILL at random times, again and again, until it is at its end, and compares its runs with those of an
# undisturbed one, to the bit; once on threads and, where mpirun is there, once on two processes.
# usage: tools/check_study_kills.sh PROGRAM [kills]
set -euo pipefail
program=$(realpath "$1")
kills=${2:-50}
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
study=$PWD/scenes/studies/die_fairness.yaml
# Fewer throws than in the study that is shown, for each way a study of its own.
mkdir -p "$work/scenes/studies"
cp scenes/dice.yaml "$work/scenes/"
sed 's/^repeats: .*/repeats: 60/; /^expect:/,$d' "$study" >"$work/scenes/studies/dice.yaml"
cd "$work"
"$program" study scenes/studies/dice.yaml --no-journal --quiet -o whole.csv

check() { # name, command...
  local name=$1 count=0 pid
  shift
  while [ "$count" -lt "$kills" ]; do
    setsid "$@" study scenes/studies/dice.yaml --journal "$name.journal" --quiet -o "$name.csv" >"$name.log" 2>&1 &
    pid=$!
    sleep "0.$((RANDOM % 20 + 5))"
    if ! kill -0 "$pid" 2>/dev/null; then break; fi
    kill -KILL -- "-$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
    count=$((count + 1))
  done
  "$@" study scenes/studies/dice.yaml --journal "$name.journal" --quiet -o "$name.csv"
  cmp whole.csv "$name.csv" || { echo "$name: the runs differ after $count kills"; exit 1; }
  echo "$name: equal to the bit after $count kills"
}
check threads "$program"
if command -v mpirun >/dev/null; then
  check processes mpirun --allow-run-as-root --oversubscribe -n 2 "$program"
fi
