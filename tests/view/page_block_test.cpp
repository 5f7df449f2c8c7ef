#include "rigor/view/page/page_block.hpp"

#include "view/page_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace rigor::page_block_test {
namespace {

TEST(PageBlock, Base64IsThatOfItsStandard) {
  // RFC 4648, section 10.
  const std::vector<std::pair<std::string, std::string>> samples = {{"", ""},
                                                                    {"f", "Zg=="},
                                                                    {"fo", "Zm8="},
                                                                    {"foo", "Zm9v"},
                                                                    {"foob", "Zm9vYg=="},
                                                                    {"fooba", "Zm9vYmE="},
                                                                    {"foobar", "Zm9vYmFy"},
                                                                    {"\xff\xfe\xfd", "//79"}};
  for (const auto& [bytes, text] : samples) EXPECT_EQ(base64(bytes), text);
}

TEST(PageBlock, ABlockInflatesToItsBytesAndTellsSizeAndChecksum) {
  for (const std::string& bytes : {std::string(), std::string(1, '\0'), std::string(100000, 'x')}) {
    const PageBlock block = make_page_block("frames", bytes);
    EXPECT_EQ(test::inflated(block), bytes);
    const std::vector<test::ReadBlock> read = test::blocks_of_page("<p>" + block_html(block, 1) + "</p>");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].run, 1);
    EXPECT_EQ(read[0].kind, "frames");
    EXPECT_EQ(read[0].bytes, bytes);
    EXPECT_TRUE(read[0].is_sound);
  }
}

TEST(PageBlock, SevenBitTextHoldsEveryByteAnEighthLongerAndNothingThatHtmlChanges) {
  std::mt19937 random(1);
  for (const std::size_t size : {0u, 1u, 2u, 6u, 7u, 8u, 13u, 100u, 10000u}) {
    for (const unsigned mask : {255u, 0u, 61u}) {
      std::string bytes;
      for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(random() & mask);
      const std::string text = seven_bit_text(bytes);
      EXPECT_EQ(text.find_first_of(std::string({'\0', '\r', '<'})), std::string::npos);
      EXPECT_EQ(test::decoded_seven_bit_text(text, size), bytes);
      EXPECT_LE(text.size(), size * 8 / 7 + 4);
    }
  }
  // 0000000 0111100 1111111 111 and four bits that fill a group: NUL takes what is after it with itself.
  EXPECT_EQ(seven_bit_text(std::string({'\x00', '\xf3', '\xff'})), "\xc2\xbc\x7fp");
}

TEST(PageBlock, AColumnOfAnyOrderComesBack) {
  const std::vector<std::int64_t> values = {5, -3, 100, 7, 7, 8, 1000000, 0, 1, 4, 9, 16};
  for (const ColumnOrder order : {ColumnOrder::constant, ColumnOrder::linear, ColumnOrder::quadratic}) {
    std::string bytes;
    append_column(values, bytes, order);
    EXPECT_EQ(test::BytesReader(bytes).column(values.size(), static_cast<int>(order)), values);
  }
  // A parabola is foreseen by a parabola.
  std::string bytes;
  append_column(std::vector<std::int64_t>{100, 400, 900, 1600, 2500}, bytes, ColumnOrder::quadratic);
  EXPECT_EQ(bytes.substr(bytes.size() - 2), std::string(2, '\0'));
}

TEST(PageBlock, VarintsHoldEveryNumberThatIsStored) {
  std::string bytes;
  append_varint(0, bytes);
  append_varint(-1, bytes);
  append_varint(63, bytes);
  EXPECT_EQ(bytes, std::string({0, 1, 126}));
  const std::int64_t most = std::int64_t{1} << 52;
  const std::vector<std::int64_t> numbers = {0, -1, 63, 64, -64, -65, 8191, 8192, most, -most};
  bytes.clear();
  for (const std::int64_t number : numbers) append_varint(number, bytes);
  test::BytesReader reader(bytes);
  for (const std::int64_t number : numbers) EXPECT_EQ(reader.varint(), number);
  EXPECT_TRUE(reader.is_at_end());
}

TEST(PageBlock, AColumnOfSteadyMotionIsOneByteAFrame) {
  std::vector<std::int64_t> values;
  for (int k = 0; k < 100; ++k) values.push_back(100000 - 777 * k);
  std::string bytes;
  append_column(values, bytes);
  // The first two say where it begins and how fast it goes.
  EXPECT_EQ(bytes.size(), 3u + 2u + 98u);
  EXPECT_EQ(test::BytesReader(bytes).column(values.size()), values);
}

TEST(PageBlock, NumbersAreRoundedToTheNearestStepAndHeldInRange) {
  EXPECT_EQ(quantised(0.74, 0.5), 1);
  EXPECT_EQ(quantised(-0.76, 0.5), -2);
  EXPECT_EQ(quantised(1e300, 1e-6), std::int64_t{1} << 50);
  EXPECT_EQ(quantised(-1e300, 1e-6), -(std::int64_t{1} << 50));
  EXPECT_EQ(quantised(std::numeric_limits<double>::infinity(), 1), 0);
  EXPECT_EQ(quantised(std::numeric_limits<double>::quiet_NaN(), 1), 0);
  EXPECT_EQ(power_of_two_below(1), 1);
  EXPECT_EQ(power_of_two_below(0.99), 0.5);
}

}  // namespace
}  // namespace rigor::page_block_test
