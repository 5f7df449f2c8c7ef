#include "rigor/core/suggestion.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace rigor::suggestion_test {
namespace {

const std::vector<std::string> kNames = {"friction", "restitution", "density", "name"};

TEST(EditDistance, CountsInsertionsDeletionsSubstitutionsAndSwaps) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("abc", ""), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("mass", "masss"), 1);
  EXPECT_EQ(edit_distance("mass", "mess"), 1);
  EXPECT_EQ(edit_distance("mass", "amss"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  // Each letter is edited at most once: "ca" -> "ac" -> "abc" is not allowed, so 3 and not 2.
  EXPECT_EQ(edit_distance("ca", "abc"), 3);
}

TEST(EditDistance, IsSymmetric) {
  for (const std::string& a : kNames) {
    for (const std::string& b : kNames) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
  }
}

TEST(Suggestion, NamesTheNearest) {
  EXPECT_EQ(suggestion("freiction", kNames), "; did you mean 'friction'?");
  EXPECT_EQ(suggestion("fricton", kNames), "; did you mean 'friction'?");
  EXPECT_EQ(suggestion("DENSITY", kNames), "; did you mean 'density'?");
  EXPECT_EQ(suggestion("nmae", kNames), "; did you mean 'name'?");
}

TEST(Suggestion, ListsTheNamesWhenNoneIsNear) {
  EXPECT_EQ(suggestion("colour", kNames), "; one of: friction, restitution, density, name");
  EXPECT_EQ(suggestion("", kNames), "; one of: friction, restitution, density, name");
  EXPECT_EQ(suggestion("x", std::vector<std::string>{}), "");
}

TEST(Suggestion, ListsAtMostTwelve) {
  std::vector<std::string> many;
  for (int i = 0; i < 20; ++i) many.push_back("name" + std::to_string(100 + i));
  const std::string text = suggestion("something else", many);
  EXPECT_NE(text.find("name111, ..."), std::string::npos);
  EXPECT_EQ(text.find("name112"), std::string::npos);
}

TEST(Suggestion, SingleLettersAreNotNearEachOther) {
  EXPECT_FALSE(find_nearest_name("x", std::vector<std::string>{"y"}));
}

TEST(Suggestion, DoesNotCompareTextsOfMegabytes) {
  EXPECT_FALSE(find_nearest_name(std::string(8000000, 'x'), kNames));
}

}  // namespace
}  // namespace rigor::suggestion_test
