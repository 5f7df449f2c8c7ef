#!/usr/bin/env bash
# The slower checks: formatting, headers alone, the viewer (with the program that `make program` leaves), clang++ with warnings
# as errors and its sanitizers under the program and some tests, clang-tidy over changed sources; with `all` over all of them, and the tests of all layers.
# usage: tools/check.sh [jobs [all]]
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${1:-2}
scope=${2:-some}

echo "== clang-format"
git ls-files '*.cpp' '*.hpp' '*.inl' | xargs clang-format --dry-run --Werror

# Some seconds of CPU time for each source: what the last commits have changed, and with `all` every source.
echo "== clang-tidy"
nice -n 19 tools/check_tidy.sh "$jobs" "$([ "$scope" = all ] && echo all || echo changed)"

# The viewer's checks wait for a browser much of the time: they go on beside the rest, which gives way to them.
viewer_log=$(mktemp)
viewer=
if command -v npm >/dev/null; then
  tools/check_viewer.sh >"$viewer_log" 2>&1 &
  viewer=$!
else
  echo "== viewer: not checked, there is no npm"
fi
trap '[ -z "$viewer" ] || kill "$viewer" 2>/dev/null; rm -f "$viewer_log"' EXIT

echo "== packages"
cmake --build --preset release -j "$jobs" --target rigor_library_rigor >/dev/null
[ ! -d build/release/python ] || cmake --build --preset release -j "$jobs" --target rigor_python >/dev/null
tests/package/check_install.sh build/release . package

echo "== headers stand alone"
# A source includes its own header first, so building the source tries it; headers without one are compiled by themselves.
for header in $(git ls-files 'rigor/*.hpp' 'apps/*.hpp'); do
  source=${header%.hpp}.cpp
  if [ ! -f "$source" ]; then
    echo "$header"
  elif [ "$(grep -m1 '^#include' "$source")" != "#include \"$header\"" ]; then
    echo "$source: include \"$header\" first, so that it is tried alone" >&2
    exit 1
  fi
done | nice -n 19 xargs -P "$jobs" -I{} clang++ -std=c++20 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow \
  -Wno-pragma-once-outside-header -I. -isystem /usr/include/eigen3 -isystem /usr/include/hdf5/serial {}

echo "== clang++ with warnings as errors, ASan and UBSan: the program on all scenes and on broken inputs, and tests"
# UBSan without its checks of null, alignment, object size and vptr: ASan sees such accesses, and they double the build.
[ -f build/asan/build.ninja ] || cmake --preset asan >/dev/null
# Tests take most of the time of this build, and the program runs the same sources: here those that feed the readers of
# files; the others with `all`. Whole scenes and the program's texts are tested in Release: the sanitizers slow them too much.
layers=$(printf '%s\n' core io)
if [ "$scope" = all ]; then
  layers=$(git ls-files tests | sed -En 's|^tests/([a-z]+)/[^/]+_test.cpp$|\1|p' | sort -u | grep -vE '^(laws|contracts|apps|golden)$')
fi
nice -n 19 cmake --build --preset asan -j "$jobs" --target rigor $(printf 'rigor_test_%s ' $layers)
nice -n 19 tools/check_program.sh build/asan/rigor "$jobs"
LSAN_OPTIONS=suppressions=$PWD/tools/leaks.txt:print_suppressions=0 ctest --preset asan -j "$jobs" --no-tests=error -R "^($(paste -sd'|' <<<"$layers")):"

if [ "$scope" = all ]; then
  echo "== random bodies against thin plates and blades: 10,000 for each scheme"
  nice -n 19 tools/passing_study.py --program build/release/rigor --jobs "$jobs" --bodies 10000 --cpu-limit 60

  echo "== stiff scenes: every run ends; audits that fail are told (docs/reliability.md)"
  nice -n 19 tools/stiff_study.py --program build/release/rigor --jobs "$jobs" --scenes 30 --cpu-limit 60 || true

  echo "== scenes that only lose energy: 200 for each scheme, against its bar (docs/reliability.md)"
  nice -n 19 tools/dissipation_study.py --program build/release/rigor --jobs "$jobs" --cpu-limit 20 || true

  echo "== crowds in joints: energy, and momenta within 1e-9 (their audits)"
  nice -n 19 tools/dissipation_study.py --program build/release/rigor --jobs "$jobs" --families joints --scenes 100 --audits \
    --schemes event-driven,time-stepping --cpu-limit 20

  echo "== meshes against the same solids as convex shapes: 2,000 poses a cell"
  tools/study_meshes.sh 2000

  echo "== the advice of failing runs, tried"
  nice -n 19 tools/check_advice.py build/release/rigor --jobs "$jobs"

  echo "== resumed runs against whole ones: 100 places a scheme"
  nice -n 19 tools/check_resume.py --program build/release/rigor --jobs "$jobs" --places 100

  echo "== hostile scenes, changed files, and ends by SIGTERM"
  nice -n 19 tools/fuzz_program.py build/release/rigor --jobs "$jobs" --files 100000
  # What is measured is time: a process that gives way to others would answer late by their fault.
  tools/check_interrupts.py build/release/rigor
  nice -n 19 tools/check_study_kills.sh build/release/rigor

  echo "== a page behind 1,000 idle connections (a second is allowed), and what floods take"
  benchmarks/live_load.py build/release/rigor

  echo "== libFuzzer on every reader, ten minutes in all"
  [ -f build/fuzz/build.ninja ] || cmake --preset fuzz >/dev/null
  nice -n 19 cmake --build --preset fuzz -j "$jobs" --target rigor_fuzzers
  fuzzers=(build/fuzz/tests/rigor_fuzz_*)
  # -len_control=0: the seeds are whole files. Memory that the libraries keep is not what is looked for.
  printf '%s\n' "${fuzzers[@]}" | ASAN_OPTIONS=detect_leaks=0 nice -n 19 xargs -P "$jobs" -I{} {} \
    -max_total_time=$((600 * jobs / ${#fuzzers[@]})) -max_len=65536 -len_control=0 -timeout=10 -rss_limit_mb=2048 \
    -verbosity=0 -print_final_stats=1 -artifact_prefix=build/fuzz/
fi

if [ -n "$viewer" ]; then
  viewer_code=0
  wait "$viewer" || viewer_code=$?
  viewer=
  cat "$viewer_log"
  exit "$viewer_code"
fi
