#include "io/scene_documents.hpp"

#include "rigor/study/plan/study_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace rigor::study_schema_test {
namespace {

using documents::Json;

const Json text = {{"type", "string"}};
const Json number_or_text = {{"type", {"number", "string"}}};

Json list_of(const Json& items) {
  return documents::list_schema(items, 0);
}

/// What a key's type alone does not say: lists of texts and numbers, mappings of any keys, and formulas,
/// which may be numbers.
Json special_schema(const std::string& object, const std::string& key) {
  if (object == "study" && (key == "set" || key == "assign")) return {{"type", "object"}};
  if (object == "parameter" && key == "values") {
    Json values = list_of(
        {{"anyOf", {{{"type", "number"}}, {{"type", "string"}, {"pattern", documents::angle_pattern}}}}});
    values["minItems"] = 1;
    return values;
  }
  if (key == "keys") return {{"anyOf", {text, list_of(text)}}};
  if (key == "bodies") {
    Json names = list_of(text);
    names["maxItems"] = 2;
    return {{"anyOf", {text, names}}};
  }
  const bool is_formula =
      key == "value" || key == "min" || key == "max" || key == "first" || key == "when" || key == "formula";
  return object == "outcome" && is_formula ? number_or_text : Json();
}

/// Names of definitions are parts of addresses, which have no spaces.
std::string definition(std::string object) {
  std::replace(object.begin(), object.end(), ' ', '_');
  return object;
}

Json table_schema(const KeyTable& table) {
  KeyTable plain = table;
  for (Key& key : plain.keys) key.object = definition(key.object);
  std::erase_if(plain.keys,
                [&](const Key& key) { return !special_schema(table.object, key.name).is_null(); });
  const Json given = documents::object_schema(plain);
  Json schema = documents::object_schema(table), properties = Json::object();
  for (const Key& key : table.keys) {
    const Json special = special_schema(table.object, key.name);
    properties[key.name] = special.is_null() ? given["properties"][key.name] : special;
    properties[key.name]["description"] = documents::description(key);
  }
  schema["properties"] = properties;
  return schema;
}

Json study_schema() {
  Json definitions = {{"study_file", table_schema(study_key_table("study"))},
                      {"study", table_schema(scene_study_table())}};
  for (const KeyTable& table : study_key_tables()) {
    if (table.object != "study") definitions[definition(table.object)] = table_schema(table);
  }
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "Study of Rigor"},
          {"allOf", Json::array({documents::reference("study_file")})},
          {"definitions", definitions}};
}

TEST(StudySchema, IsThatOfTheReadersKeys) {
  const std::string expected = study_schema().dump(1) + "\n";
  std::ifstream file(std::filesystem::path(RIGOR_SOURCE_DIR) / "schema" / "study.schema.json");
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  if (written == expected) return;
  const std::filesystem::path right = std::filesystem::path(testing::TempDir()) / "study.schema.json";
  std::ofstream(right) << expected;
  FAIL() << "schema/study.schema.json differs from the reader's key tables; the right one is in " << right;
}

}  // namespace
}  // namespace rigor::study_schema_test
