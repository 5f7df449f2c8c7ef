#include "io/scene_documents.hpp"

#include "rigor/io/scene/scene_keys.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

namespace rigor::schema_test {
namespace {

const std::filesystem::path kRoot = RIGOR_SOURCE_DIR;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The part of docs/scene.md under the heading of an object.
std::string section(const std::string& document, const std::string& object) {
  const std::size_t start = document.find("\n### " + object + "\n");
  if (start == std::string::npos) return "";
  return document.substr(start, document.find("\n### ", start + 1) - start);
}

TEST(Schema, IsThatOfTheReadersKeys) {
  const std::string expected = documents::scene_schema().dump(1) + "\n";
  if (text_of(kRoot / "schema" / "scene.schema.json") == expected) return;
  const std::filesystem::path right = std::filesystem::path(testing::TempDir()) / "scene.schema.json";
  std::ofstream(right) << expected;
  FAIL() << "schema/scene.schema.json differs from the reader's key tables; the right one is in " << right;
}

TEST(SceneDocumentation, HasEveryKeyOfTheReaderAndNoOther) {
  const std::string document = text_of(kRoot / "docs" / "scene.md");
  for (const KeyTable& table : key_tables()) {
    const std::string text = section(document, table.object);
    ASSERT_FALSE(text.empty()) << "docs/scene.md has no heading '### " << table.object << "'";
    std::string expected;
    for (const Key& key : table.keys) expected += documents::table_row(key) + "\n";
    std::string rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("| `")) rows += line + "\n";
    }
    EXPECT_EQ(rows, expected) << "in docs/scene.md, section " << table.object;
  }
}

TEST(SceneDocumentation, ItsExampleIsAScene) {
  const std::string document = text_of(kRoot / "docs" / "scene.md");
  const std::string fence = "```yaml\n";
  const std::size_t start = document.find(fence) + fence.size();
  const Scene scene =
      parse_scene(document.substr(start, document.find("```", start) - start), "example.yaml", ".");
  EXPECT_EQ(scene.model->body_count(), 2);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneDocumentation, ItsChainIsAScene) {
  const std::string document = text_of(kRoot / "docs" / "scene.md");
  const std::size_t start = document.find("    bodies:\n      - {name: link");
  ASSERT_NE(start, std::string::npos);
  std::string text = "rigor: 1\n";
  std::istringstream lines(document.substr(start));
  for (std::string line; std::getline(lines, line) && line.starts_with("    ");)
    text += line.substr(4) + "\n";
  const Scene scene = parse_scene(text, "chain.yaml", ".");
  EXPECT_EQ(scene.model->body_count(), 1000);
  EXPECT_EQ(scene.model->joints().size(), 1000u);
}

TEST(KeyTables, RefersOnlyToTablesThatExist) {
  for (const KeyTable& table : key_tables()) {
    for (const Key& key : table.keys) {
      const bool is_object = key.type == ValueType::object || key.type == ValueType::objects;
      if (!is_object || !key.is_available) continue;
      if (!types_of(key.object).empty()) continue;
      EXPECT_EQ(key_table(key.object).object, key.object);
    }
  }
}

TEST(KeyTables, NameEachKeyOnce) {
  for (const KeyTable& table : key_tables()) {
    std::set<std::string> names;
    for (const Key& key : table.keys)
      EXPECT_TRUE(names.insert(key.name).second) << table.object << "." << key.name;
  }
}

}  // namespace
}  // namespace rigor::schema_test
