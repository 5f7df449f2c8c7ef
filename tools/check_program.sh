#!/usr/bin/env bash
# Runs the program on every scene, with every scheme and output, and on broken inputs, and looks at nothing but its exit
# codes: made for a program built with sanitizers, which end it with a code of their own.
# usage: tools/check_program.sh PROGRAM [jobs]
set -euo pipefail
program=$(realpath "$1")
jobs=${2:-2}
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/broken"

# One line a call: the exit codes that are right, then the arguments.
calls() {
  local scene scheme mesh part size
  for scene in scenes/*.yaml; do
    echo "0,1 run $scene --quiet --duration 0.05 -o $folder/$(basename "$scene" .yaml).csv"
    size=$(stat -c %s "$scene")
    # Whole beginnings of a file are often scenes too; a relative path of a mesh leads nowhere then.
    for part in 3 5 7; do
      head -c $((size * part / 9)) "$scene" >"$folder/broken/$part.$(basename "$scene")"
      echo "0,3,5 check $folder/broken/$part.$(basename "$scene")"
    done
  done
  for scene in cradle dominoes pile stack_10 rolling_disk chain double_pendulum rocks; do
    for scheme in time-stepping penalty impulse-based hybrid auto; do
      echo "0,1,3,4 run scenes/$scene.yaml --quiet --duration 0.02 --set method.scheme=$scheme"
    done
  done
  for part in h5 json html png; do
    echo "0,1 run scenes/cradle.yaml --quiet --duration 0.05 -o $folder/outputs.$part"
  done
  for mesh in tests/data/meshes/*; do echo "0,3,5 mass $mesh"; done
  for mesh in scenes/meshes/*.obj; do echo "0,3 mass $mesh"; done
  echo "0 check $(echo scenes/*.yaml)"
  echo "0 check scenes/dominoes.yaml --estimate"
  echo "0 methods"
  echo "0 methods contact region"
  echo "2 methods projecton"
  echo "0 impact --K=3.5,0,0,3.5,0,1 --u=2,1,-3 --mu 0.2 --e 0.8"
  echo "0 distance scenes/dominoes.yaml floor domino1"
}

# call LINE: of calls().
call() {
  local codes=${1%% *} code=0
  # shellcheck disable=SC2086 # The arguments are words.
  "$program" ${1#* } >"$folder/$$.out" 2>&1 || code=$?
  if [[ ",$codes," != *",$code,"* ]]; then
    echo "rigor ${1#* }: exit code $code, not one of $codes" >&2
    tail -n 60 "$folder/$$.out" >&2
    return 1
  fi
  rm -f "$folder/$$.out"
}

export -f call
export program folder
export ASAN_OPTIONS=exitcode=99 UBSAN_OPTIONS=exitcode=99:print_stacktrace=1
export LSAN_OPTIONS=suppressions=$PWD/tools/leaks.txt:print_suppressions=0:exitcode=99
calls >"$folder/calls"
xargs -P "$jobs" -d '\n' -I{} bash -c 'call "$1"' call {} <"$folder/calls"
echo "$(wc -l <"$folder/calls") calls of the program, all with a right exit code"
