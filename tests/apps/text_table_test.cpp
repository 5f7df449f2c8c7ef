#include "apps/text_table.hpp"

#include <gtest/gtest.h>

namespace rigor::text_table_test {
namespace {

/// As text in a file, without colours.
std::string plain(const std::vector<TableColumn>& columns, std::size_t key_count, int width) {
  std::FILE* const file = std::tmpfile();
  const std::string text = table_text(columns, key_count, width, file);
  std::fclose(file);
  return text;
}

const TableColumn number{"", "#", true, false, {{"1"}, {"10"}}};
const TableColumn name{"a.", "name", false, false, {{"Δx"}, {"ratio"}}};
const TableColumn mass{"mass", "[kg]", true, false, {{"0.5"}, {"12.25"}}};
const TableColumn empty{"", "body", false, false, {{""}, {"b"}}};

TEST(TextTable, ColumnsAreAlignedByCharactersAndLinesEndWithoutSpaces) {
  EXPECT_EQ(plain({number, name, mass, empty}, 1, 80),
            "    a.      mass\n"
            " #  name    [kg]  body\n"
            " 1  Δx       0.5\n"
            "10  ratio  12.25  b\n");
}

TEST(TextTable, WhatDoesNotFitGoesOnBelowWithTheKeysAgain) {
  const std::string text = plain({number, name, mass, mass}, 2, 20);
  EXPECT_EQ(text,
            "    a.      mass\n"
            " #  name    [kg]\n"
            " 1  Δx       0.5\n"
            "10  ratio  12.25\n"
            "\n"
            "    a.      mass\n"
            " #  name    [kg]\n"
            " 1  Δx       0.5\n"
            "10  ratio  12.25\n");
  // Keys of 9 characters and twice 2 + 5 of a number.
  EXPECT_NE(plain({number, name, mass, mass}, 2, 22).find("\n\n"), std::string::npos);
  EXPECT_EQ(plain({number, name, mass, mass}, 2, 23).find("\n\n"), std::string::npos);
}

TEST(TextTable, KeysWiderThanHalfOfTheLineAreShownOnce) {
  const TableColumn wide{"", "value", false, false, {{"aaaaaaaaaaaa"}, {"b"}}};
  EXPECT_EQ(plain({number, wide, mass, mass}, 2, 25),
            "                   mass\n"
            " #  value          [kg]\n"
            " 1  aaaaaaaaaaaa    0.5\n"
            "10  b             12.25\n"
            "\n"
            "     mass\n"
            " #   [kg]\n"
            " 1    0.5\n"
            "10  12.25\n");
}

TEST(TextTable, AGroupStaysTogetherWhereALineHoldsIt) {
  TableColumn first = mass;
  first.is_with_next = true;
  // 2 of the key, then 7 for each number: three fit, but not the group beside the first.
  const std::string text = plain({number, mass, first, mass}, 1, 20);
  EXPECT_EQ(text.substr(0, text.find('\n')), "     mass");
  // No line holds the group: it is parted.
  EXPECT_NE(plain({number, first, mass}, 1, 10).find("\n\n"), std::string::npos);
}

TEST(TextTable, TextsAreCutByCharacters) {
  EXPECT_EQ(text_length("Δv ≥ 0"), 6u);
  EXPECT_EQ(shortened("Δv ≥ 0", 6), "Δv ≥ 0");
  EXPECT_EQ(shortened("Δv ≥ 0", 5), "Δv ≥…");
  EXPECT_EQ(shortened("abc", 1), "…");
}

TEST(TextTable, WrappedTextBreaksAtSpacesAndNowhereElse) {
  EXPECT_EQ(wrapped_text("one two three four", 2, 11), "  one two\n    three\n    four\n");
  EXPECT_EQ(wrapped_text("one two", 0, 7), "one two\n");
  EXPECT_EQ(wrapped_text("one two", 0, 6), "one\n  two\n");
  // Δ is one character; a word that is too long stands alone.
  EXPECT_EQ(wrapped_text("ΔΔΔ bb unbreakable c", 0, 6), "ΔΔΔ bb\n  unbreakable\n  c\n");
  EXPECT_EQ(wrapped_text("", 2, 9), "  \n");
}

}  // namespace
}  // namespace rigor::text_table_test
