#include "rigor/study/plan/study_keys.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace rigor::study_docs_test {
namespace {

/// The row of a key in the documentation.
std::string table_row(const Key& key) {
  std::string choices;
  for (const std::string& choice : key.choices) choices += (choices.empty() ? ": `" : ", `") + choice + "`";
  return "| `" + key.name + "` | " + key.unit + " | " + key.fallback + " | " + key.meaning + choices + " |";
}

TEST(StudyDocumentation, HasEveryKeyOfTheReaderAndNoOther) {
  std::ifstream file(std::filesystem::path(RIGOR_SOURCE_DIR) / "docs" / "studies.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string document = text.str();
  for (const KeyTable& table : study_key_tables()) {
    std::string expected;
    for (const Key& key : table.keys) expected += table_row(key) + "\n";
    const std::size_t start = document.find("\n### " + table.object + "\n");
    const std::string section =
        start == std::string::npos ? "" : document.substr(start, document.find("\n### ", start + 1) - start);
    std::string rows;
    std::istringstream lines(section);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("| `")) rows += line + "\n";
    }
    EXPECT_EQ(rows, expected) << "in docs/studies.md, section " << table.object;
  }
}

}  // namespace
}  // namespace rigor::study_docs_test
