#!/usr/bin/env bash
# The slower checks: formatting, every header alone, clang++ with warnings as errors, tests under ASan and UBSan, the
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

echo "== clang++: the program with warnings as errors, headers alone"
[ -f build/clang/build.ninja ] || cmake --preset clang >/dev/null
cmake --build --preset clang -j "$jobs" --target rigor
git ls-files 'rigor/*.hpp' | xargs -P "$jobs" -I{} clang++ -std=c++20 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow -Wno-pragma-once-outside-header \
  -I. -isystem /usr/include/eigen3 -isystem /usr/include/hdf5/serial {}

echo "== ASan and UBSan: all tests of the layers"
# UBSan without its checks of null, alignment, object size and vptr: ASan sees such accesses, and they double the build.
[ -f build/asan/build.ninja ] || cmake --preset asan >/dev/null
# Whole scenes and the program itself run in Release (make test): under the sanitizers they take too long.
layers=$(git ls-files tests | sed -En 's|^tests/([a-z]+)/[^/]+_test.cpp$|\1|p' | sort -u | grep -vE '^(laws|contracts|apps)$')
cmake --build --preset asan -j "$jobs" --target $(printf 'rigor_test_%s ' $layers)
LSAN_OPTIONS=suppressions=$PWD/tools/leaks.txt:print_suppressions=0 ctest --preset asan -j "$jobs" --no-tests=error -R "^($(paste -sd'|' <<<"$layers")):"
