#include "apps/variation.hpp"

#include "apps/usage_error.hpp"

#include <gtest/gtest.h>

namespace rigor::variation_test {
namespace {

using Values = std::vector<std::string>;

std::string refusal_of(const std::string& text) {
  try {
    parse_variation(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Variation, ValuesArePartedAtCommasAndTrimmed) {
  const Variation variation = parse_variation(" method.toi = conservative, ratio ,bisection");
  EXPECT_EQ(variation.key, "method.toi");
  EXPECT_EQ(variation.values, (Values{"conservative", "ratio", "bisection"}));
  EXPECT_EQ(parse_variation("run.step=0.01").values, (Values{"0.01"}));
  EXPECT_EQ(parse_variation("a=b=c,d").values, (Values{"b=c", "d"}));
}

TEST(Variation, CommasInBracketsAndBracesPartNothing) {
  EXPECT_EQ(parse_variation("bodies.ball.velocity=[1, 0, 0],[0, [1], 2]").values,
            (Values{"[1, 0, 0]", "[0, [1], 2]"}));
  EXPECT_EQ(parse_variation("materials.m={a: 1, b: [2, 3]}, {a: 2}").values,
            (Values{"{a: 1, b: [2, 3]}", "{a: 2}"}));
}

TEST(Variation, CommasInQuotesPartNothing) {
  EXPECT_EQ(parse_variation("name=\"a, b\",'c, d'").values, (Values{"\"a, b\"", "'c, d'"}));
  EXPECT_EQ(parse_variation(R"(name="a\", b",c)").values, (Values{R"("a\", b")", "c"}));
  EXPECT_EQ(parse_variation("name='it''s, so',c").values, (Values{"'it''s, so'", "c"}));
  EXPECT_EQ(parse_variation("name=[\"]\", 1],2").values, (Values{"[\"]\", 1]", "2"}));
  // Inside a word an apostrophe is a letter, as in YAML.
  EXPECT_EQ(parse_variation("name=it's,so").values, (Values{"it's", "so"}));
}

TEST(Variation, WhatMakesNoSenseIsRefusedByName) {
  EXPECT_EQ(refusal_of("method.toi"), "--vary 'method.toi': must be KEY=a,b,c");
  EXPECT_EQ(refusal_of("=a"), "--vary '=a': the key is empty; must be KEY=a,b,c");
  EXPECT_EQ(refusal_of("a="), "--vary 'a=': value 1 is empty; must be KEY=a,b,c");
  EXPECT_EQ(refusal_of("a=1, ,2"), "--vary 'a=1, ,2': value 2 is empty; must be KEY=a,b,c");
  EXPECT_EQ(refusal_of("a=1,"), "--vary 'a=1,': value 2 is empty; must be KEY=a,b,c");
  EXPECT_EQ(refusal_of("a=b,c, b"), "--vary 'a=b,c, b': value 'b' is given twice");
  EXPECT_EQ(refusal_of("a=0.5,0.50"), "--vary 'a=0.5,0.50': values '0.5' and '0.50' are the same number");
  EXPECT_EQ(refusal_of("a=[1,2"), "--vary 'a=[1,2': a [ is not closed");
  EXPECT_EQ(refusal_of("a={b: [1,2],3"), "--vary 'a={b: [1,2],3': a { is not closed");
  EXPECT_EQ(refusal_of("a='b,c"), "--vary 'a='b,c': a ' is not closed");
  EXPECT_EQ(refusal_of("a=[\"b],c"), "--vary 'a=[\"b],c': a \" is not closed");
}

TEST(Variation, SeveralGiveAllCombinationsTheLastFastest) {
  const std::vector<Variation> variations = {{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}};
  const std::vector<Combination> all = combinations(variations, 6);
  EXPECT_EQ(all, (std::vector<Combination>{
                     {"1", "x"}, {"1", "y"}, {"1", "z"}, {"2", "x"}, {"2", "y"}, {"2", "z"}}));
  EXPECT_EQ(combination_label(variations, all[4]), "a=2, b=y");
}

TEST(Variation, TooManyCombinationsAndAKeyTwiceAreRefused) {
  const auto refusal = [](const std::vector<Variation>& variations, std::size_t most) -> std::string {
    try {
      combinations(variations, most);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  const std::vector<Variation> variations = {{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}};
  EXPECT_EQ(refusal(variations, 6), "");
  EXPECT_EQ(refusal(variations, 5), "--vary asks for 6 runs (2 x 3), must be at most 5");
  EXPECT_EQ(refusal({{"a", {"1", "2"}}}, 1), "--vary asks for 2 runs, must be at most 1");
  EXPECT_EQ(refusal({{"a", {"1"}}, {"a", {"2"}}}, 9), "--vary a is given twice; give all its values at once");
}

}  // namespace
}  // namespace rigor::variation_test
