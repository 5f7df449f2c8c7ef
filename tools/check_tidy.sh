#!/usr/bin/env bash
# Holds sources to .clang-tidy (seconds for each): those that the last commits have changed, since the branch left origin/main,
# or in the last commit where there is no such branch or nothing lies between, twelve at most; `all`; or what the paths hold.
# usage: tools/check_tidy.sh [jobs [changed|all|PATH...]]      for example tools/check_tidy.sh 2 rigor/solver rigor/sim/method
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${1:-2}
scope=${2:-changed}

if [ "$scope" = all ]; then
  sources=$(git ls-files 'rigor/*.cpp' 'apps/*.cpp')
elif [ "$scope" != changed ]; then
  sources=$(git ls-files -- "${@:2}" | grep '\.cpp$' || true)
  [ -n "$sources" ] || { echo "clang-tidy: no source lies in ${*:2}" >&2; exit 1; }
else
  base=$(git merge-base HEAD origin/main 2>/dev/null || true)
  [ -n "$base" ] && [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse -q --verify HEAD~1 || git rev-parse HEAD)
  sources=$(git diff --name-only --diff-filter=d "$base" -- 'rigor/*.cpp' 'apps/*.cpp')
  count=$(wc -w <<<"$sources")
  [ "$count" -le 12 ] || echo "clang-tidy: the first 12 of $count changed sources; tools/check_tidy.sh $jobs all takes every one"
  sources=$(head -n 12 <<<"$sources")
fi
[ -n "$sources" ] || { echo "clang-tidy: no source has changed"; exit 0; }

# Each source by itself: what clang-tidy reads says how.
cmake -S . -B build/tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DRIGOR_UNITY=OFF -DRIGOR_BUILD_TESTS=OFF \
  -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
xargs -P "$jobs" -n 4 clang-tidy -p build/tidy --quiet <<<"$sources" 2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
echo "clang-tidy: $(wc -w <<<"$sources") sources hold to .clang-tidy"
