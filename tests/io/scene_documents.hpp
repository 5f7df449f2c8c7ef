#pragma once

#include "rigor/core/range.hpp"
#include "rigor/io/scene/scene_keys.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

/// What docs/scene.md and schema/scene.schema.json have to say, made from the reader's key tables.
namespace rigor::documents {

using Json = nlohmann::ordered_json;

inline const char* const angle_pattern = "^[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)? *(deg|rad)$";

inline Json number_schema(const Key& key) {
  const bool is_whole = key.type == ValueType::whole || key.type == ValueType::whole_vector;
  Json schema = {{"type", is_whole ? "integer" : "number"}};
  if (std::isfinite(key.range.lowest)) {
    schema[key.range.lowest_is_excluded ? "exclusiveMinimum" : "minimum"] = key.range.lowest;
  }
  if (std::isfinite(key.range.highest)) schema["maximum"] = key.range.highest;
  return schema;
}

inline Json list_schema(const Json& items, int count) {
  Json schema = {{"type", "array"}, {"items", items}};
  if (count > 0) schema["minItems"] = schema["maxItems"] = count;
  return schema;
}

inline Json reference(const std::string& object) {
  return {{"$ref", "#/definitions/" + object}};
}

inline Json value_schema(const Key& key) {
  const Json number = number_schema(key);
  const Json text = {{"type", "string"}};
  const Json angle = {{"anyOf", {number, {{"type", "string"}, {"pattern", angle_pattern}}}}};
  switch (key.type) {
    case ValueType::number:
    case ValueType::whole:
      return number;
    case ValueType::text:
      return text;
    case ValueType::choice:
      return {{"enum", key.choices}};
    case ValueType::angle:
      return angle;
    case ValueType::flag:
      return {{"type", "boolean"}};
    case ValueType::vector2:
    case ValueType::range:
      return list_schema(number, 2);
    case ValueType::angle_range:
      return list_schema(angle, 2);
    case ValueType::vector:
    case ValueType::whole_vector:
      return list_schema(number, 3);
    case ValueType::angles:
      return list_schema(angle, 3);
    case ValueType::quaternion:
      return list_schema(number, 4);
    case ValueType::scale:
      return {{"anyOf", {number, list_schema(number, 3)}}};
    case ValueType::vectors:
      return list_schema(list_schema(number, 3), 0);
    case ValueType::rows:
      return list_schema(list_schema(number, 0), 0);
    case ValueType::function:
      return {{"anyOf", {number, text, reference("function")}}};
    case ValueType::names:
      return list_schema(text, 2);
    case ValueType::name_pairs:
      return list_schema(list_schema(text, 2), 0);
    case ValueType::object:
      // A mapping without a table has a format of its own.
      if (key.object.empty()) return {{"$ref", key.name + ".schema.json#/definitions/" + key.name}};
      return reference(key.object);
    case ValueType::objects:
      return list_schema(reference(key.object), 0);
  }
  return {};
}

inline std::string description(const Key& key) {
  std::string text = key.meaning;
  if (!key.unit.empty()) text += " [" + key.unit + "]";
  if (!key.is_required() && key.fallback != "-") text += "; default " + key.fallback;
  return text;
}

inline Json object_schema(const KeyTable& table) {
  Json properties = Json::object(), required = Json::array();
  for (const Key& key : table.keys) {
    if (!key.is_available) continue;
    Json value = value_schema(key);
    // In draft 7 what stands beside a reference is not seen.
    if (value.contains("$ref")) value = {{"allOf", Json::array({value})}};
    value["description"] = description(key);
    properties[key.name] = value;
    if (key.is_required()) required.push_back(key.name);
  }
  Json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

inline Json scene_schema() {
  Json definitions = Json::object();
  for (const KeyTable& table : key_tables()) definitions[table.object] = object_schema(table);
  for (const char* const family : {"shape", "force", "joint", "coordinate"}) {
    Json any = Json::array();
    for (const std::string& type : types_of(family)) any.push_back(reference(type));
    // Joints, shapes and forces differ by their type; the same numbers may stand for either coordinate.
    definitions[family] = {{family == std::string("coordinate") ? "anyOf" : "oneOf", any}};
  }
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "Scene of Rigor"},
          {"allOf", Json::array({reference("scene")})},
          {"definitions", definitions}};
}

inline std::string value_text(const Key& key) {
  static const std::map<ValueType, std::string> texts = {
      {ValueType::number, "number"},
      {ValueType::whole, "whole number"},
      {ValueType::text, "text"},
      {ValueType::angle, "angle"},
      {ValueType::vector, "3 numbers"},
      {ValueType::whole_vector, "3 whole numbers"},
      {ValueType::angles, "3 angles"},
      {ValueType::quaternion, "4 numbers"},
      {ValueType::scale, "number or 3"},
      {ValueType::vectors, "list of 3 numbers"},
      {ValueType::vector2, "2 numbers"},
      {ValueType::rows, "list of rows of numbers"},
      {ValueType::function, "number, formula or [function](#function)"},
      {ValueType::flag, "`true`, `false`"},
      {ValueType::range, "2 numbers"},
      {ValueType::angle_range, "2 angles"},
      {ValueType::names, "2 names"},
      {ValueType::name_pairs, "list of 2 names"}};
  if (key.object.empty() && key.type == ValueType::object) return "mapping";
  if (key.type == ValueType::object) return "[" + key.object + "](#" + key.object + ")";
  if (key.type == ValueType::objects) return "list of [" + key.object + "](#" + key.object + ")";
  if (key.type != ValueType::choice) return texts.at(key.type);
  std::string choices;
  for (const std::string& choice : key.choices) choices += (choices.empty() ? "`" : ", `") + choice + "`";
  return choices;
}

inline std::string range_column(const Key& key) {
  const bool has_range = std::isfinite(key.range.lowest) || std::isfinite(key.range.highest);
  return has_range ? range_text(key.range, "") : "";
}

/// The line of the key in the table of its object.
inline std::string table_row(const Key& key) {
  if (!key.is_available) return "| `" + key.name + "` | | | | | not in this version: " + key.instead + " |";
  return "| `" + key.name + "` | " + value_text(key) + " | " + key.unit + " | " + key.fallback + " | " +
         range_column(key) + " | " + key.meaning + " |";
}

}  // namespace rigor::documents
