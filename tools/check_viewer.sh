#!/usr/bin/env bash
# The viewer in viewer/: its types, its unit tests, whether the bundle in the tree is what its sources make, and the
# pages that the program writes in a browser (Chromium, without a screen). Needs npm, Chromium and build/release/rigor.
# usage: tools/check_viewer.sh
set -euo pipefail
cd "$(dirname "$0")/../viewer"

echo "== viewer: libraries of package-lock.json"
npm ci --ignore-scripts --no-audit --no-fund --loglevel=error
if grep -nE '"resolved"' package-lock.json; then
  echo "viewer/package-lock.json names where its packages were fetched; make it with viewer/.npmrc" >&2
  exit 1
fi

echo "== viewer: types and unit tests"
npm run --silent types
npm test --silent

echo "== viewer: bundles"
kept=$(mktemp -d)
trap 'rm -rf "$kept"' EXIT
cp dist/*.js "$kept"
npm run --silent build
for bundle in dist/*.js; do
  if ! cmp "$kept/${bundle#dist/}" "$bundle"; then
    echo "viewer/$bundle is not what viewer/src makes; it is rebuilt now: commit it" >&2
    exit 1
  fi
done

echo "== viewer: pages in a browser"
npm run --silent browser
