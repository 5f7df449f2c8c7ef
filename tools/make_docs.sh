#!/usr/bin/env bash
# Makes the site of the public headers (cmake/public_headers.txt) with Doxygen, and fails if one of them has something
# public that is not documented.
# usage: tools/make_docs.sh OUT [root of the repository]
set -euo pipefail
mkdir -p "$1"
out=$(realpath "$1")
cd "${2:-$(dirname "$0")/..}"
command -v doxygen >/dev/null || { echo "doxygen is not installed: tools/setup.sh docs" >&2; exit 5; }

mapfile -t headers < <(grep '^rigor/' cmake/public_headers.txt)
version=$(sed -n 's/^project(.*VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
{
  cat docs/doxygen/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "INPUT = docs/cpp.md ${headers[*]}"
  echo "USE_MDFILE_AS_MAINPAGE = docs/cpp.md"
  echo "STRIP_FROM_PATH = ."
  echo "OUTPUT_DIRECTORY = $out"
  echo "WARN_LOGFILE = $out/warnings.txt"
} | doxygen - >/dev/null

# Links of the tutorial lead to pages of the repository that are no part of the site.
grep -v '^.*docs/cpp\.md:' "$out/warnings.txt" >"$out/offences.txt" || true
if [ -s "$out/offences.txt" ]; then
  cat "$out/offences.txt"
  echo "$(wc -l <"$out/offences.txt") warnings"
  exit 1
fi
echo "$out/html/index.html: ${#headers[@]} headers"
