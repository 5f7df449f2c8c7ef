#!/usr/bin/env bash
# The shared libraries: their names and symbols carry the version, what a program needs is in them, and a program that is
# linked with them alone runs; the geometry without the other libraries.
# usage: tests/package/check_shared.sh FOLDER SOURCE VERSION COMPILER
set -euo pipefail
folder=$(realpath "$1")
source=$(realpath "$2")
version=$3
compiler=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for library in rigor rigor_geometry; do
  file=$folder/lib$library.so
  # Not `grep -q`: what writes to it must be able to end, for it counts (pipefail).
  objdump -p "$file" | grep "SONAME *lib$library.so.$version$" >/dev/null || { echo "$file: no version in its name"; exit 1; }
  # All that it defines for others has the version.
  symbols=$(nm -D --defined-only "$file")
  bare=$(grep -v "@@RIGOR_$version$" <<<"$symbols" | grep -cv " A RIGOR_$version" || true)
  [ "$bare" = 0 ] || { echo "$file: $bare symbols without RIGOR_$version"; exit 1; }
  grep -q "@@RIGOR_$version$" <<<"$symbols" || { echo "$file: no symbols"; exit 1; }
done

build() { # example, libraries...
  local example=$1
  shift
  "$compiler" -std=c++20 -O0 -isystem /usr/include/eigen3 -I"$source" "$source/examples/$example.cpp" -o "$work/$example" \
    -L"$folder" "$@" -Wl,-rpath,"$folder"
  "$work/$example" >/dev/null
}
build hello_bounce -lrigor -lrigor_geometry
build geometry_only -lrigor_geometry
ldd "$work/hello_bounce" | grep "librigor.so.$version => $folder" >/dev/null || { echo "not linked with the shared library"; exit 1; }
if ldd "$work/geometry_only" | grep -E 'hdf5|yaml|tbb|png' >/dev/null; then
  echo "the shared geometry brings other libraries"; exit 1
fi
echo "shared: names, versions of $(nm -D --defined-only "$folder/librigor.so" | wc -l) symbols, two programs"
