#!/usr/bin/env bash
# The slower checks: formatting, headers alone, clang++ with warnings as errors and its sanitizers under the tests, the
# viewer (with the program that `make build` leaves).
# usage: tools/check.sh [jobs]
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${1:-2}

echo "== clang-format"
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror

if command -v npm >/dev/null; then
  tools/check_viewer.sh
else
  echo "== viewer: not checked, there is no npm"
fi

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
done | xargs -P "$jobs" -I{} clang++ -std=c++20 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow \
  -Wno-pragma-once-outside-header -I. -isystem /usr/include/eigen3 -isystem /usr/include/hdf5/serial {}

echo "== clang++ with warnings as errors, ASan and UBSan: the program, and all tests of the layers"
# UBSan without its checks of null, alignment, object size and vptr: ASan sees such accesses, and they double the build.
[ -f build/asan/build.ninja ] || cmake --preset asan >/dev/null
# Whole scenes and the program itself run in Release (make test): under the sanitizers they take too long.
layers=$(git ls-files tests | sed -En 's|^tests/([a-z]+)/[^/]+_test.cpp$|\1|p' | sort -u | grep -vE '^(laws|contracts|apps)$')
cmake --build --preset asan -j "$jobs" --target rigor_apps $(printf 'rigor_test_%s ' $layers)
LSAN_OPTIONS=suppressions=$PWD/tools/leaks.txt:print_suppressions=0 ctest --preset asan -j "$jobs" --no-tests=error -R "^($(paste -sd'|' <<<"$layers")):"
