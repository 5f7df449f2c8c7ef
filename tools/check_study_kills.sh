#!/usr/bin/env bash
# Kills a study with SIGKILL at random times, again and again, and compares its runs whenever it comes to its end with those of an
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

check() { # name, longest wait [tenths of a second], command...
  local name=$1 longest=$2 count=0 pid victim
  shift 2
  while [ "$count" -lt "$kills" ]; do
    setsid "$@" study scenes/studies/dice.yaml --journal "$name.journal" --quiet -o "$name.csv" >"$name.log" 2>&1 &
    pid=$!
    sleep "$((RANDOM % longest / 10)).$((RANDOM % 95 + 5))"
    if ! kill -0 "$pid" 2>/dev/null; then
      # It has come to its end: it has to be right, and the next one begins anew.
      wait "$pid"
      cmp whole.csv "$name.csv" || { echo "$name: the runs differ after $count kills"; exit 1; }
      rm "$name.journal"
      continue
    fi
    # Every other time one process of several, whereupon mpirun ends the others; else all at once.
    victim=$(pgrep -P "$pid" | shuf -n 1 || true)
    if [ -n "$victim" ] && [ $((count % 2)) = 0 ]; then
      kill -KILL "$victim" 2>/dev/null || true
    else
      kill -KILL -- "-$pid" 2>/dev/null || true
    fi
    wait "$pid" 2>/dev/null || true
    count=$((count + 1))
  done
  "$@" study scenes/studies/dice.yaml --journal "$name.journal" --quiet -o "$name.csv"
  cmp whole.csv "$name.csv" || { echo "$name: the runs differ after $count kills"; exit 1; }
  echo "$name: equal to the bit after $count kills"
}
check threads 2 "$program"
if command -v mpirun >/dev/null; then
  check processes 15 mpirun --allow-run-as-root --oversubscribe -n 2 "$program"
fi
