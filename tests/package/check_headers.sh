#!/usr/bin/env bash
# Holds the line between public and private headers: cmake/public_headers.txt lists at most 40, each exists, each is
# named in docs/cpp.md, and those of the component `geometry` include no header of a layer above it.
# usage: tests/package/check_headers.sh [root of the repository]
set -euo pipefail
cd "${1:-.}"
most=40
bad=0
complain() { echo "$1"; bad=1; }

mapfile -t public < <(grep '^rigor/' cmake/public_headers.txt)
[ ${#public[@]} -le $most ] || complain "${#public[@]} public headers, at most $most"
for header in "${public[@]}"; do
  [ -f "$header" ] || { complain "$header does not exist"; continue; }
  grep -qF "\`$header\`" docs/cpp.md || complain "$header is not in docs/cpp.md"
done

# All that a header includes, itself among it.
closure() {
  local waiting=("$@") found=() header
  while [ ${#waiting[@]} -gt 0 ]; do
    header=${waiting[0]}
    waiting=("${waiting[@]:1}")
    [[ " ${found[*]} " == *" $header "* ]] && continue
    found+=("$header")
    mapfile -t -O ${#waiting[@]} waiting < <(sed -n 's/^#include "\(rigor\/[^"]*\)".*/\1/p' "$header")
  done
  printf '%s\n' "${found[@]}"
}
above=$(closure rigor/geometry.hpp | grep -vE '^rigor/(core|math|geometry)/|^rigor/geometry.hpp$' || true)
[ -z "$above" ] || complain "rigor/geometry.hpp includes: $above"
# What a program includes is installed whole, and small: no header of a solver, an island or a step is among it.
inner=$(closure "${public[@]}" | grep -E '^rigor/(solver|bulk|view)/|^rigor/sim/(islands|event_driven|time_stepping|penalty)/' || true)
[ -z "$inner" ] || complain "public headers include headers of the engine: $inner"
[ $bad = 0 ] && echo "${#public[@]} public headers"
exit $bad
