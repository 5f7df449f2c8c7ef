// The words of the courses: docs/methods.md has the table of the program, and its links lead to headings.

#include "apps/course_words.hpp"

#include "rigor/sim/method/method.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace rigor::course_words_test {
namespace {

const std::filesystem::path kDocs = std::filesystem::path(RIGOR_SOURCE_DIR) / "docs";

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The anchor of a heading: lower case, blanks as hyphens, without other punctuation.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(heading.find_first_not_of("# "))) {
    const bool is_kept = static_cast<unsigned char>(c) >= 128 ||
                         std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
    if (c == ' ') anchor += '-';
    if (is_kept) anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return anchor;
}

std::set<std::string> anchors_of(const std::filesystem::path& path) {
  std::set<std::string> anchors;
  for (const std::string& line : lines_of(path)) {
    if (line.starts_with("#")) anchors.insert(anchor_of(line));
  }
  return anchors;
}

TEST(CourseWords, DocsHaveTheTableOfTheProgram) {
  std::vector<std::string> expected;
  for (const CourseWord& word : course_words()) {
    const std::string page(word.page);
    const std::string stem = page.substr(0, page.find(".md"));
    expected.push_back("| " + std::string(word.names) + " | " + std::string(word.here) + " | " +
                       std::string(word.chosen) + " | [" + stem + "](" + page + ") |");
  }
  const std::vector<std::string> lines = lines_of(kDocs / "methods.md");
  const auto heading = std::find(lines.begin(), lines.end(), "## The course's words");
  ASSERT_NE(heading, lines.end());
  const auto next =
      std::find_if(heading + 1, lines.end(), [](const std::string& line) { return line.starts_with("## "); });
  std::vector<std::string> rows;
  std::copy_if(heading, next, std::back_inserter(rows),
               [](const std::string& line) { return line.starts_with("| "); });
  ASSERT_FALSE(rows.empty());
  rows.erase(rows.begin());  // The names of the columns.
  EXPECT_EQ(rows, expected);
}

TEST(CourseWords, EveryLinkLeadsToAHeading) {
  for (const CourseWord& word : course_words()) {
    const std::string page(word.page);
    const std::size_t hash = page.find('#');
    const std::filesystem::path file = kDocs / page.substr(0, hash);
    ASSERT_TRUE(std::filesystem::is_regular_file(file)) << file;
    if (hash == std::string::npos) continue;
    EXPECT_TRUE(anchors_of(file).contains(page.substr(hash + 1))) << page;
  }
}

TEST(CourseWords, ChoicesThatTheyNameExist) {
  for (const CourseWord& word : course_words()) {
    std::string_view rest = word.chosen;
    for (std::size_t i = rest.find("`method."); i != std::string_view::npos; i = rest.find("`method.")) {
      const std::string_view name = rest.substr(i + 8, rest.find('`', i + 1) - i - 8);
      const std::size_t colon = name.find(": ");
      const std::string key(name.substr(0, colon));
      if (colon != std::string_view::npos) {
        Method method;
        EXPECT_EQ(set_method_choice(key, name.substr(colon + 2), method), "") << word.names;
      } else {
        const std::vector<std::string> keys = method_choice_keys();
        const bool is_number = std::any_of(method_numbers().begin(), method_numbers().end(),
                                           [&](const MethodNumber& number) { return number.key == key; });
        EXPECT_TRUE(is_number || std::find(keys.begin(), keys.end(), key) != keys.end()) << key;
      }
      rest = rest.substr(i + 8);
    }
  }
}

TEST(CourseWords, SpellingOfTheTwoEnglishesAndHyphensAreOne) {
  EXPECT_TRUE(speaks_of("renormalisation, quaternion drift", "Re-normalization"));
  EXPECT_TRUE(speaks_of("contact region", "Contact Region"));
  EXPECT_TRUE(speaks_of("SWIFT++, patches", "swift"));
  EXPECT_FALSE(speaks_of("GJK", "RAPID"));
  EXPECT_FALSE(speaks_of("GJK", "++"));
}

TEST(CourseWords, NoNameStandsTwice) {
  std::set<std::string> names;
  for (const CourseWord& word : course_words()) {
    for (const std::string& name : names_of(word)) EXPECT_TRUE(names.insert(name).second) << name;
  }
  EXPECT_GE(names.size(), 100u);
}

}  // namespace
}  // namespace rigor::course_words_test
