#include "rigor/core/quoted.hpp"

#include <gtest/gtest.h>
#include <string>

namespace rigor::quoted_test {
namespace {

TEST(Quoted, LeavesOrdinaryTextAsItIs) {
  EXPECT_EQ(quoted_text("ball"), "'ball'");
  EXPECT_EQ(quoted_text("%s%s%n"), "'%s%s%n'");
  EXPECT_EQ(quoted_text("Kugel größer 球 😀"), "'Kugel größer 球 😀'");
}

TEST(Quoted, EscapesWhatDrivesATerminal) {
  EXPECT_EQ(quoted_text("a\x1b[2Jb"), "'a\\x1b[2Jb'");
  EXPECT_EQ(quoted_text("line\nline"), "'line\\x0aline'");
  EXPECT_EQ(quoted_text("\x7f"), "'\\x7f'");
  EXPECT_EQ(quoted_text("\xc2\x9b"), "'\\xc2\\x9b'");
}

TEST(Quoted, EscapesWhatIsNotUtf8) {
  EXPECT_EQ(quoted_text("a\xff\xfe\x80"), "'a\\xff\\xfe\\x80'");
}

TEST(Quoted, CutsLongTextAtACharacter) {
  EXPECT_EQ(quoted_text(std::string(8000000, 'x')), "'" + std::string(60, 'x') + "...'");
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "ü";
  const std::string cut = quoted_text(umlauts);
  EXPECT_EQ(cut.size(), 60u + 5u);
  EXPECT_EQ(utf8_length(cut.substr(59)), 2);
}

TEST(Utf8, LengthsOfCharacters) {
  EXPECT_EQ(utf8_length("a"), 1);
  EXPECT_EQ(utf8_length("ü"), 2);
  EXPECT_EQ(utf8_length("球"), 3);
  EXPECT_EQ(utf8_length("😀"), 4);
  EXPECT_EQ(utf8_length(""), 0);
}

TEST(Utf8, OverlongFormsSurrogatesAndLonelyBytesAreRefused) {
  EXPECT_EQ(utf8_length("\xc0\xaf"), 0);
  EXPECT_EQ(utf8_length("\xe0\x80\xaf"), 0);
  EXPECT_EQ(utf8_length("\xed\xa0\x80"), 0);
  EXPECT_EQ(utf8_length("\xf4\x90\x80\x80"), 0);
  EXPECT_EQ(utf8_length("\x80"), 0);
  EXPECT_EQ(utf8_length("\xe7\x90"), 0);
  EXPECT_EQ(utf8_length("\xff"), 0);
}

}  // namespace
}  // namespace rigor::quoted_test
