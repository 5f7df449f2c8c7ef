#!/usr/bin/env bash
# Solids given as meshes against the same solids given as convex shapes, over random poses: one line a solid and a kind of
# shape with the poses where the depth, its bounds, a normal or the set of contacts is another, and microseconds a query. Then
# how closely the bounds enclose the depth of two meshes. Fails where the tests of the same name would.
# usage: tools/study_meshes.sh [poses a cell [build folder]]
set -euo pipefail
cd "$(dirname "$0")/.."
poses=${1:-2000}
build=${2:-build/release}

RIGOR_STUDY_POSES=$poses nice -n 19 "$build/tests/rigor_test_geometry" --gtest_brief=1 \
  --gtest_filter='MeshAgainstConvex.*:MeshBounds.OfShallowOverlapsAreNarrow'
