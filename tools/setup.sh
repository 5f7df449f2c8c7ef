#!/usr/bin/env bash
# Installs the Debian packages that building Rigor needs, if any is missing. As root or with sudo; says what and how
# much first and asks once on a terminal (RIGOR_YES=1, or no terminal: no question). With all packages there it does
# nothing and needs no network.
# usage: tools/setup.sh [build|python|docs|check|bench|bench-bulk]
set -euo pipefail

packages=(g++ make cmake ninja-build git ca-certificates libeigen3-dev libyaml-cpp-dev nlohmann-json3-dev libcli11-dev
  libfmt-dev libhdf5-dev libpng-dev libqhull-dev libgtest-dev zlib1g-dev libboost-dev libtbb-dev libmuparser-dev
  libnlopt-dev pkg-config)
case "${1:-build}" in
  build) ;;
  check)
    packages+=(clang libclang-rt-dev clang-format clang-tidy chromium)
    # Node may have come from elsewhere; Debian's npm would not go with it.
    command -v npm >/dev/null || packages+=(nodejs npm) ;;
  python) packages+=(python3-dev python3-numpy python3-matplotlib python3-pytest pybind11-dev) ;;
  docs) packages=(doxygen) ;;
  bench) packages+=(libbenchmark-dev python3) ;;
  bench-bulk) packages+=(libbullet-dev) ;;
  *) echo "usage: tools/setup.sh [build|python|docs|check|bench|bench-bulk]" >&2; exit 2 ;;
esac

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "Rigor's set-up knows Debian 12; install these packages by hand: ${missing[*]}" >&2
  exit 5
fi
as_root=()
if [ "$(id -u)" != 0 ]; then
  command -v sudo >/dev/null || { echo "Not root and no sudo: run as root: apt-get install ${missing[*]}" >&2; exit 5; }
  as_root=(sudo)
fi

"${as_root[@]}" apt-get update -qq
size=$("${as_root[@]}" apt-get install --no-install-recommends --assume-no "${missing[@]}" 2>/dev/null \
  | grep -E '^(Need to get|After this operation)' || true)
echo "Rigor needs ${#missing[@]} Debian packages that are not installed: ${missing[*]}"
[ -n "$size" ] && echo "$size"
if [ -t 0 ] && [ -z "${RIGOR_YES:-}" ]; then
  read -r -p "Install them? [Y/n] " answer
  case "$answer" in [nN]*) echo "Nothing was installed."; exit 5 ;; esac
fi
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
echo "Installed."
