#!/usr/bin/env bash
# Holds sources to .clang-tidy: those that the last commits have changed, since the branch left origin/main or in the last
# commit where there is no such branch or nothing lies between, twelve at most; what the paths hold; or `all`.
# usage: tools/check_tidy.sh [jobs [changed|all|PATH...]]      for example tools/check_tidy.sh 2 rigor/solver rigor/sim/method
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${1:-2}
scope=${2:-changed}

# What clang-tidy reads to know how a source is compiled; it builds nothing.
configure() {
  cmake -S . -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRIGOR_UNITY="$2" -DRIGOR_BUILD_TESTS=OFF \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
}
run_tidy() {  # options of clang-tidy; files from the input
  xargs -P "$jobs" -n 1 clang-tidy --quiet "$@" 2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
}

if [ "$scope" = all ]; then
  # By the batches of the build: twelve sources, whose headers are read once, take 20 to 25 s, each by itself 8 to 11 s.
  configure build/tidy-all ON
  batches=$(sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/tidy-all/compile_commands.json |
    grep -E 'rigor_[a-z]+\.dir/|/(rigor|apps)/' | grep -v -E '_pch|embedded' | sort -u)
  run_tidy -p build/tidy-all --checks=-bugprone-suspicious-include <<<"$batches"
  echo "clang-tidy: $(wc -l <<<"$batches") batches hold to .clang-tidy"
  exit 0
elif [ "$scope" = changed ]; then
  base=$(git merge-base HEAD origin/main 2>/dev/null || true)
  [ -n "$base" ] && [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse -q --verify HEAD~1 || git rev-parse HEAD)
  sources=$(git diff --name-only --diff-filter=d "$base" -- 'rigor/*.cpp' 'apps/*.cpp')
  count=$(wc -w <<<"$sources")
  [ "$count" -le 12 ] || echo "clang-tidy: the first 12 of $count changed sources; tools/check_tidy.sh $jobs all takes every one"
  sources=$(head -n 12 <<<"$sources")
  [ -n "$sources" ] || { echo "clang-tidy: no source has changed"; exit 0; }
else
  sources=$(git ls-files -- "${@:2}" | grep '\.cpp$' || true)
  [ -n "$sources" ] || { echo "clang-tidy: no source lies in ${*:2}" >&2; exit 1; }
fi

# Each source by itself.
configure build/tidy OFF
run_tidy -p build/tidy <<<"$sources"
echo "clang-tidy: $(wc -w <<<"$sources") sources hold to .clang-tidy"
