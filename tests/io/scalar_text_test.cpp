#include "rigor/io/files/scalar_text.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace rigor::scalar_text_test {
namespace {

TEST(ParseNumber, ReadsDecimalNumbersExactly) {
  EXPECT_EQ(*parse_number("1").value, 1);
  EXPECT_EQ(*parse_number("-0.1").value, -0.1);
  EXPECT_EQ(*parse_number("+2.5").value, 2.5);
  EXPECT_EQ(*parse_number(".5").value, 0.5);
  EXPECT_EQ(*parse_number("5.").value, 5);
  EXPECT_EQ(*parse_number("1e-3").value, 1e-3);
  EXPECT_EQ(*parse_number("6.02214076E+23").value, 6.02214076e23);
  EXPECT_EQ(*parse_number("0.1000000000000000055511151231257827").value, 0.1);
  EXPECT_EQ(*parse_number("010").value, 10);
  EXPECT_EQ(*parse_number("4.9406564584124654e-324").value, std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::signbit(*parse_number("-0").value));
}

TEST(ParseNumber, RefusesWhatIsNotANumber) {
  for (const char* text : {"",      " ",      "1e",     "e5",  "--1",   "+-1", "-+1", "1,5",  "0x10",
                           "0o17",  "1_000",  "abc",    "1 2", "1.2.3", ".",   "+",   "-",    "true",
                           "1e999", "-1e999", "1e-999", "1f",  "1d",    "½",   "%s",  "nano", "infinite"}) {
    EXPECT_FALSE(parse_number(text).value) << text;
  }
}

TEST(ParseNumber, WordsForNanAndInfinityAreNumbersThatNoRangeHolds) {
  for (const char* text : {"nan", "NaN", ".nan", ".NaN", "-nan"})
    EXPECT_TRUE(std::isnan(*parse_number(text).value));
  for (const char* text : {"inf", ".inf", "+.Inf", "Infinity"})
    EXPECT_EQ(*parse_number(text).value, INFINITY);
  EXPECT_EQ(*parse_number("-.inf").value, -INFINITY);
}

TEST(ParseNumber, Hints) {
  EXPECT_EQ(parse_number("1,5").hint, "; write 1.5");
  EXPECT_EQ(parse_number("0x10").hint, "; numbers are decimal");
  EXPECT_EQ(parse_number("1e999").hint, "; it is out of the range of a double");
  EXPECT_EQ(parse_number("abc").hint, "");
}

TEST(ParseAngle, ReadsDegreesAndRadians) {
  EXPECT_EQ(*parse_angle("180 deg"), std::numbers::pi);
  EXPECT_EQ(*parse_angle("-90deg"), -std::numbers::pi / 2);
  EXPECT_EQ(*parse_angle("0.5 rad"), 0.5);
  EXPECT_EQ(*parse_angle("1e-1   rad "), 0.1);
}

TEST(ParseAngle, RefusesOtherUnitsAndWords) {
  for (const char* text :
       {"", "deg", " deg", "30", "30 grad", "30 degrees", "x deg", "30 deg x", "1,5 rad", "rad 3"}) {
    EXPECT_FALSE(parse_angle(text)) << text;
  }
}

}  // namespace
}  // namespace rigor::scalar_text_test
