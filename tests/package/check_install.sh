#!/usr/bin/env bash
# Installs a build into a temporary folder, and builds projects outside the tree against it: ten lines of CMake, the component
# geometry without the other libraries, pkg-config, all public headers at once. With `package`: makes the packages, and does
# the same with what the .deb holds. With `subdirectory`: configures a project that has Rigor as a folder of its own.
# usage: tests/package/check_install.sh BUILD SOURCE [package|subdirectory]
set -euo pipefail
build=$(realpath "$1")
source=$(realpath "$2")
mode=${3:-install}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

# quiet COMMAND...: its output is shown only if it fails.
quiet() { "$@" >"$work/log" 2>&1 || { echo "failed: $*"; tail -40 "$work/log"; exit 1; }; }

if [ "$mode" = subdirectory ]; then
  mkdir "$work/own"
  cat >"$work/own/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(own LANGUAGES C CXX)
add_subdirectory($source rigor)
add_executable(app app.cpp)
target_link_libraries(app PRIVATE rigor::rigor)
foreach(variable CMAKE_CXX_STANDARD CMAKE_BUILD_TYPE CPACK_PACKAGE_NAME BUILD_TESTING)
  if(DEFINED \${variable} AND NOT "\${\${variable}}" STREQUAL "")
    message(FATAL_ERROR "\${variable} has leaked: \${\${variable}}")
  endif()
endforeach()
END
  cp "$source/examples/hello_bounce.cpp" "$work/own/app.cpp"
  quiet cmake -S "$work/own" -B "$work/own/build" -G Ninja
  grep -q -- '-Werror' "$work/own/build/build.ninja" && { echo "-Werror has leaked"; exit 1; }
  grep -qE 'build (rigor/)?tests/|rigor_test_' "$work/own/build/build.ninja" && { echo "tests are built"; exit 1; }
  echo "add_subdirectory: no tests, no -Werror, no options"
  exit
fi

if [ "$mode" = package ]; then
  quiet cmake --build "$build" --target package
  deb=$(ls -t "$build"/packages/rigor_*.deb | head -1)
  ls "$build"/packages/rigor-*.tar.gz >/dev/null
  dpkg-deb -x "$deb" "$work/installed"
  prefix=$work/installed/usr
  dpkg-deb -f "$deb" Package Version Depends
else
  quiet cmake --install "$build" --prefix "$prefix"
fi

# Ten lines outside the tree, and the component geometry where the other libraries cannot be found.
mkdir "$work/app"
cp "$source"/examples/{hello_bounce,geometry_only}.cpp "$work/app"
cat >"$work/app/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(app LANGUAGES CXX)
if(ONLY_GEOMETRY)
  set(CMAKE_DISABLE_FIND_PACKAGE_yaml-cpp ON)
  set(CMAKE_DISABLE_FIND_PACKAGE_TBB ON)
  set(CMAKE_DISABLE_FIND_PACKAGE_PNG ON)
  find_package(rigor 0.2 REQUIRED COMPONENTS geometry)
  add_executable(app geometry_only.cpp)
  target_link_libraries(app PRIVATE rigor::geometry)
else()
  find_package(rigor 0.2 REQUIRED)
  add_executable(app hello_bounce.cpp)
  target_link_libraries(app PRIVATE rigor::rigor)
endif()
END
for only in OFF ON; do
  quiet cmake -S "$work/app" -B "$work/app/build-$only" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DONLY_GEOMETRY=$only
  quiet cmake --build "$work/app/build-$only"
  quiet "$work/app/build-$only/app"
done
# All examples as a project of their own, against what the package holds.
if [ "$mode" = package ]; then
  quiet cmake -S "$source/examples" -B "$work/examples" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS=-O0
  quiet cmake --build "$work/examples"
  for example in "$source"/examples/*.cpp; do quiet "$work/examples/$(basename "$example" .cpp)"; done
fi
if ldd "$work/app/build-ON/app" | grep -E 'hdf5|yaml|tbb|png' >/dev/null; then
  echo "the component geometry brings other libraries"; exit 1
fi

# pkg-config, and every public header.
pc=$(dirname "$(find "$prefix" -name rigor.pc)")
{ sed -n 's/^\(rigor\/.*\)/#include <\1>/p' "$source/cmake/public_headers.txt"
  echo 'int main() { return rigor::Simulation(rigor::parse_scene("rigor: 1\nbodies: []\n", "x", ".")).body_count(); }'
} >"$work/all.cpp"
flags=$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs rigor)
# shellcheck disable=SC2086
quiet g++ "$work/all.cpp" -o "$work/all" $flags -Wl,-rpath,"$prefix/lib"
quiet env LD_LIBRARY_PATH="$prefix/lib" "$work/all"
quiet "$prefix/bin/rigor" --version
for file in man/man1/rigor.1 man/man1/rigor-run.1 bash-completion/completions/rigor zsh/site-functions/_rigor \
  fish/vendor_completions.d/rigor.fish; do
  [ -s "$prefix/share/$file" ] || { echo "not installed: share/$file"; exit 1; }
done
echo "$mode: find_package, component geometry, pkg-config, $(find "$prefix/include" -name '*.hpp' | wc -l) headers, program, man pages, completions"
