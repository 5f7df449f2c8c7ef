// Fuzz target over two convex shapes and their poses, for libFuzzer:
//
//   clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -I. -Itests -I/usr/include/eigen3
//     tests/fuzz/convex_pair_fuzz.cpp rigor/geometry/*.cpp rigor/math/*.cpp rigor/core/*.cpp -lfmt -lqhull_r

#include "fuzz/convex_pair.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault = rigor::test::fault_of_bytes({data, size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}
