#!/usr/bin/env bash
# A study on two processes of MPI has the runs and the answer of one on threads, to the bit.
# usage: check_processes.sh PROGRAM ROOT
set -euo pipefail
program=$(realpath "$1")
study=$(realpath "$2")/scenes/studies/arch_friction.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$program" study "$study" --no-journal --quiet -o threads.csv -o threads.json
mpirun --allow-run-as-root --oversubscribe -n 2 "$program" study "$study" --no-journal --quiet -o processes.csv -o processes.json
cmp threads.csv processes.csv
cmp threads.json processes.json
