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

TEST(Quoted, EscapesWhatTurnsTheDirectionOfWriting) {
  EXPECT_EQ(quoted_text("a\u202Eb"), "'a\\xe2\\x80\\xaeb'");
  for (const char* const mark :
       {"\u061C", "\u200E", "\u200F", "\u202A", "\u202E", "\u2066", "\u2069", "\u2028", "\u2029"})
    EXPECT_EQ(escaped_text(mark).find(mark), std::string::npos) << escaped_text(mark);
  for (const char* const letter :
       {"\u00A0", "\u061B", "\u0627", "\u05D0", "\u200D", "\u2027", "\u202F", "\u206A"})
    EXPECT_EQ(escaped_text(letter), letter);
}

TEST(Quoted, TextThatIsShownIsNotCut) {
  EXPECT_EQ(escaped_text(std::string(1000, 'x')), std::string(1000, 'x'));
  EXPECT_EQ(escaped_text("a\x1b[2J\xff"), "a\\x1b[2J\\xff");
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
