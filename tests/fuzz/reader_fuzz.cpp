// Fuzz target of one reader, RIGOR_FUZZ_TARGET, for libFuzzer: the programs rigor_fuzz_<reader> of the preset
// fuzz. Without a folder of inputs they begin with the reader's own seed: rigor_fuzz_scene
// -max_total_time=60.

#include "fuzz/reader_targets.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

const rigor::test::ReaderTarget& fuzz_target() {
  for (const rigor::test::ReaderTarget& target : rigor::test::reader_targets()) {
    if (std::strcmp(target.name, RIGOR_FUZZ_TARGET) == 0) return target;
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault =
      rigor::test::fault_of_reader(fuzz_target(), {reinterpret_cast<const char*>(data), size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

/// The seed takes the place of inputs too short to be anything.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int) {
  const std::string& seed = fuzz_target().seed;
  if (size < 8 && seed.size() <= max_size) {
    std::memcpy(data, seed.data(), seed.size());
    size = seed.size();
  }
  return LLVMFuzzerMutate(data, size, max_size);
}
