#include "rigor/core/range.hpp"
#include "rigor/core/input_error.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace rigor::range_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Range, ContainsItsEndsUnlessExcluded) {
  EXPECT_TRUE((Range{0, 1}).contains(0));
  EXPECT_TRUE((Range{0, 1}).contains(1));
  EXPECT_FALSE((Range{0, 1}).contains(std::nextafter(1, 2)));
  EXPECT_FALSE((Range{0, 1, true}).contains(0));
  EXPECT_TRUE((Range{0, 1, true}).contains(std::numeric_limits<double>::denorm_min()));
}

TEST(Range, NeverContainsNanOrInfinity) {
  for (const Range& range : {Range{}, Range{0, 1}, Range{0, kInfinity, true}}) {
    EXPECT_FALSE(range.contains(kNan));
    EXPECT_FALSE(range.contains(kInfinity));
    EXPECT_FALSE(range.contains(-kInfinity));
  }
}

TEST(Range, SaysWhatIsAllowed) {
  EXPECT_EQ(range_error("mass", -1, {0, kInfinity, true}, "kg"), "mass is -1 kg, must be > 0 kg");
  EXPECT_EQ(range_error("mass", 0, {0, 10, true}, "kg"), "mass is 0 kg, must be > 0 and at most 10 kg");
  EXPECT_EQ(range_error("restitution", 1.5, {0, 1}, ""), "restitution is 1.5, must be from 0 to 1");
  EXPECT_EQ(range_error("drag", kNan, {0, kInfinity}, "kg/s"), "drag is nan kg/s, must be at least 0 kg/s");
  EXPECT_EQ(range_error("x", kInfinity, {}, "m"), "x is inf m, must be finite");
  EXPECT_EQ(range_error("x", 2, {-kInfinity, 1}, "m"), "x is 2 m, must be at most 1 m");
  EXPECT_EQ(range_error("rigor", 2, {1, 1}, ""), "rigor is 2, must be 1");
  EXPECT_EQ(range_error("mass", 1, {0, 10, true}, "kg"), "");
  EXPECT_EQ(range_error("mask", -1, {0, 4294967295.0}, ""), "mask is -1, must be from 0 to 4294967295");
}

TEST(NumberText, ReadsBackAsTheSameNumber) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-1), "-1");
  EXPECT_EQ(std::stod(number_text(1.0 / 3)), 1.0 / 3);
}

TEST(InputErrorTest, KeepsAllMessages) {
  const InputError error(std::vector<std::string>{"first", "second"});
  EXPECT_EQ(error.messages().size(), 2u);
  EXPECT_STREQ(error.what(), "first\nsecond");
}

}  // namespace
}  // namespace rigor::range_test
