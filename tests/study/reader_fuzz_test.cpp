#include "fuzz/reader_targets.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::reader_fuzz_test {
namespace {

/// Some bytes changed, and pieces left out, doubled or moved.
std::string mutated(std::string bytes, std::mt19937_64& engine) {
  for (std::uint64_t k = 1 + engine() % 6; k > 0 && !bytes.empty(); --k) {
    const std::size_t at = engine() % bytes.size();
    const std::size_t length = 1 + engine() % std::min<std::size_t>(40, bytes.size() - at);
    switch (engine() % 6) {
      case 0:
        bytes.erase(at, length);
        break;
      case 1:
        bytes.insert(engine() % bytes.size(), bytes.substr(at, length));
        break;
      case 2:
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << engine() % 8);
        break;
      case 3:
        // Numbers and signs of all the formats.
        bytes[at] = "0123456789.,-+eE:[]{}\"#nai \n"[engine() % 28];
        break;
      default:
        bytes[at] = static_cast<char>(engine());
    }
  }
  return bytes;
}

class ReaderFuzz : public testing::TestWithParam<std::size_t> {};

TEST_P(ReaderFuzz, ChangedFilesAreReadOrRefused) {
  const test::ReaderTarget& target = test::reader_targets()[GetParam()];
  EXPECT_NO_THROW(target.read(target.seed)) << target.name;
  std::mt19937_64 engine(GetParam() + 1);
  for (int i = 0; i < 150; ++i) {
    EXPECT_EQ(test::fault_of_reader(target, mutated(target.seed, engine)), "") << i;
  }
  // Bytes of the beginning alone, and nothing at all.
  for (std::size_t length = 0; length < std::min<std::size_t>(60, target.seed.size()); ++length)
    EXPECT_EQ(test::fault_of_reader(target, target.seed.substr(0, length)), "") << length;
}

INSTANTIATE_TEST_SUITE_P(Readers, ReaderFuzz, testing::Range<std::size_t>(0, 9),
                         [](const testing::TestParamInfo<std::size_t>& parameter) {
                           return std::string(test::reader_targets()[parameter.param].name);
                         });

}  // namespace
}  // namespace rigor::reader_fuzz_test
