#include "rigor/io/scene/object_reader.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace rigor {

namespace {

bool is_number_type(ValueType type) {
  return type != ValueType::angle && type != ValueType::angles && type != ValueType::angle_range;
}

bool is_whole_type(ValueType type) {
  return type == ValueType::whole || type == ValueType::whole_vector;
}

std::string with_unit(const Key& key, const std::string& text) {
  return key.unit.empty() ? text : text + " (" + key.unit + ")";
}

std::string expected_text(const Key& key) {
  switch (key.type) {
    case ValueType::number:
      return with_unit(key, "a number");
    case ValueType::whole:
      return "a whole number";
    case ValueType::angle:
      return "an angle: a number (rad) or a text such as 30 deg";
    case ValueType::vector:
      return with_unit(key, "3 numbers [x, y, z]");
    case ValueType::vector2:
      return with_unit(key, "2 numbers [x, y]");
    case ValueType::whole_vector:
      return "3 whole numbers [x, y, z]";
    case ValueType::angles:
      return "3 angles [x, y, z]: numbers (rad) or texts such as 30 deg";
    case ValueType::range:
      return with_unit(key, "2 numbers [lowest, highest]");
    case ValueType::angle_range:
      return "2 angles [lowest, highest]: numbers (rad) or texts such as 30 deg";
    case ValueType::flag:
      return "true or false";
    case ValueType::quaternion:
      return "4 numbers [w, x, y, z]";
    case ValueType::scale:
      return "a number or 3 numbers [x, y, z]";
    case ValueType::vectors:
      return with_unit(key, "a list of points [x, y, z]");
    case ValueType::rows:
      return with_unit(key, "a list of rows of numbers");
    case ValueType::function:
      return with_unit(key, "a number, a formula in quotes, a sine or a table");
    case ValueType::names:
      return "a list of 2 names";
    case ValueType::objects:
    case ValueType::name_pairs:
      return "a list";
    case ValueType::object:
      return "a mapping";
    case ValueType::text:
    case ValueType::choice:
      break;
  }
  return "a text";
}

bool is_empty(const YamlNode& node) {
  return node.kind == YamlNode::Kind::null || (node.kind != YamlNode::Kind::scalar && node.entries.empty());
}

/// A hint for an unknown key: a similar one, the object that has it, or that "1,5" is not a number.
std::string unknown_key_hint(const YamlNode::Entry& entry, const KeyTable& table) {
  const std::vector<std::string> names = table.names();
  const bool is_digits = entry.key.find_first_not_of("0123456789") == std::string::npos;
  if (is_digits && is_empty(*entry.value)) return "; a number is written with a point, such as 1.5";
  if (find_nearest_name(entry.key, names)) return suggestion(entry.key, names);
  if (table.find("coordinates") && key_table("angle_coordinate").find(entry.key)) {
    return "; it has several coordinates: write it in 'coordinates', a list of one mapping for each";
  }
  for (const KeyTable& other : key_tables()) {
    if (other.find(entry.key)) return "; it is a key of " + other.title + suggestion("", names);
  }
  return suggestion(entry.key, names);
}

/// Reads the numbers of one key and reports each mistake at its position.
class NumberReader {
 public:
  NumberReader(const Key& key, const std::string& whose, SceneErrors& errors)
      : key_(key), whose_(whose), errors_(errors) {}

  std::optional<double> number(const YamlNode& node) const {
    const std::optional<double> value = parsed(node);
    if (!value) return std::nullopt;
    const std::string error = range_error(key_.name, *value, key_.range, key_.unit);
    if (!error.empty()) return fail(node, error), std::nullopt;
    if (is_whole_type(key_.type) && std::floor(*value) != *value) {
      return fail(node, key_.name + " is " + node.text + ", must be a whole number"), std::nullopt;
    }
    return value;
  }

  /// Reads exactly `count` numbers; empty if anything is wrong.
  std::vector<double> numbers(const YamlNode& node, std::size_t count) const {
    if (node.kind != YamlNode::Kind::list || node.entries.size() != count)
      return wrong_type(node), std::vector<double>{};
    std::vector<double> values;
    for (const YamlNode::Entry& entry : node.entries) {
      const std::optional<double> value = number(*entry.value);
      if (value) values.push_back(*value);
    }
    if (values.size() < count) values.clear();
    return values;
  }

  /// Reads all rows of the list, each with as many numbers as the first; empty if anything is wrong.
  std::vector<std::vector<double>> rows(const YamlNode& list) const {
    std::vector<std::vector<double>> rows;
    std::size_t count = 0;
    for (const YamlNode::Entry& entry : list.entries) {
      const YamlNode& row = *entry.value;
      if (row.kind != YamlNode::Kind::list || row.entries.empty()) {
        return fail(row, row_text(rows.size()) + " must be a list of numbers, found " + found_text(row)),
               std::vector<std::vector<double>>{};
      }
      if (rows.empty()) count = row.entries.size();
      if (row.entries.size() != count) {
        return fail(row, row_text(rows.size()) + " has " + std::to_string(row.entries.size()) +
                             " numbers, must have " + std::to_string(count) + " as row 0"),
               std::vector<std::vector<double>>{};
      }
      rows.push_back(numbers(row, count));
      if (rows.back().empty()) return {};
    }
    return rows;
  }

  std::optional<Vec3> vector(const YamlNode& node) const {
    const std::vector<double> values = numbers(node, 3);
    if (values.empty()) return std::nullopt;
    return Vec3(values[0], values[1], values[2]);
  }

  void wrong_type(const YamlNode& node, const std::string& hint = "") const {
    fail(node, key_.name + " must be " + expected_text(key_) + ", found " + found_text(node) + hint);
  }

  void fail(const YamlNode& node, const std::string& message) const {
    errors_.add(node, whose_ + ": " + message);
  }

 private:
  std::string row_text(std::size_t index) const {
    return "row " + std::to_string(index) + " of " + key_.name;
  }

  std::optional<double> parsed(const YamlNode& node) const {
    std::string hint;
    if (node.kind == YamlNode::Kind::scalar) {
      const NumberText number = parse_number(node.text);
      if (number.value && !node.is_quoted) return number.value;
      if (!is_number_type(key_.type)) {
        if (const std::optional<double> angle = parse_angle(node.text)) return angle;
      }
      hint = number.value ? "; write it without quotes" : number.hint;
    }
    wrong_type(node, hint);
    return std::nullopt;
  }

  const Key& key_;
  const std::string& whose_;
  SceneErrors& errors_;
};

}  // namespace

ObjectReader::ObjectReader(const YamlNode& node, const KeyTable& table, std::string whose,
                           SceneErrors& errors)
    : node_(node), table_(table), whose_(std::move(whose)), errors_(errors) {
  if (node_.kind != YamlNode::Kind::map) {
    errors_.add(node_, whose_ + ": must be a mapping of keys, found " + found_text(node_));
    return;
  }
  check_keys();
}

void ObjectReader::check_keys() const {
  // The first entry of each key of the table, and of those that it does not have.
  std::vector<const YamlNode::Entry*> seen(table_.keys.size(), nullptr);
  std::map<std::string_view, const YamlNode::Entry*> unknown;
  for (const YamlNode::Entry& entry : node_.entries) {
    if (errors_.is_full()) return;
    const Key* const key = table_.find(entry.key);
    const YamlNode::Entry*& first =
        key ? seen[static_cast<std::size_t>(key - table_.keys.data())] : unknown[entry.key];
    if (first) {
      errors_.add_at_key(node_, entry,
                         "key " + quoted_text(entry.key) + " is given twice in " + whose_ +
                             " (first in line " + std::to_string(first->line) + ")");
    } else if (!key) {
      errors_.add_at_key(
          node_, entry,
          "unknown key " + quoted_text(entry.key) + " in " + whose_ + unknown_key_hint(entry, table_));
    } else if (!key->is_available && !is_empty(*entry.value)) {
      errors_.add_at_key(node_, entry,
                         "key " + quoted_text(entry.key) + " of " + whose_ +
                             " is not available in this version; " + key->instead);
    } else if (key->is_available && entry.value->kind == YamlNode::Kind::null) {
      const std::string hint = entry.key == "color" ? "; '#' starts a comment, put it in quotes" : "";
      errors_.add_at_key(
          node_, entry,
          whose_ + ": " + entry.key + " must be " + expected_text(*key) + ", found nothing" + hint);
    }
    if (!first) first = &entry;
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const Key& key = table_.keys[k];
    if (!seen[k] && key.is_required()) {
      errors_.add(node_, whose_ + ": the key '" + key.name + "' is missing: " + expected_text(key));
    }
  }
}

const Key& ObjectReader::key_of(std::string_view name) const {
  const Key* const key = table_.find(name);
  RIGOR_ASSERT(key);
  return *key;
}

const YamlNode* ObjectReader::find(std::string_view key) const {
  RIGOR_SLOW_ASSERT(table_.find(key));
  const YamlNode::Entry* const entry = node_.find(key);
  return entry && entry->value->kind != YamlNode::Kind::null ? entry->value.get() : nullptr;
}

std::optional<double> ObjectReader::number(std::string_view key) const {
  const YamlNode* const value = find(key);
  if (!value) return std::nullopt;
  return NumberReader(key_of(key), whose_, errors_).number(*value);
}

std::optional<std::string> ObjectReader::text(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return std::nullopt;
  const Key& key = key_of(name);
  if (value->kind != YamlNode::Kind::scalar || !is_text(*value)) {
    const std::string hint = value->kind == YamlNode::Kind::scalar ? "; put it in quotes" : "";
    fail(name, key.name + " must be " + expected_text(key) + ", found " + found_text(*value) + hint);
    return std::nullopt;
  }
  const bool is_allowed = key.choices.empty() ||
                          std::find(key.choices.begin(), key.choices.end(), value->text) != key.choices.end();
  if (is_allowed) return value->text;
  fail(name, "unknown " + key.name + " " + quoted_text(value->text) + suggestion(value->text, key.choices));
  return std::nullopt;
}

std::optional<bool> ObjectReader::flag(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return std::nullopt;
  const bool is_plain = value->kind == YamlNode::Kind::scalar && !value->is_quoted;
  if (is_plain && (value->text == "true" || value->text == "false")) return value->text == "true";
  NumberReader(key_of(name), whose_, errors_).wrong_type(*value);
  return std::nullopt;
}

std::optional<std::array<double, 2>> ObjectReader::range(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return std::nullopt;
  const std::vector<double> ends = NumberReader(key_of(name), whose_, errors_).numbers(*value, 2);
  if (ends.empty()) return std::nullopt;
  return std::array<double, 2>{ends[0], ends[1]};
}

std::optional<Vec2> ObjectReader::vector2(std::string_view name) const {
  const std::optional<std::array<double, 2>> numbers = range(name);
  if (!numbers) return std::nullopt;
  return Vec2((*numbers)[0], (*numbers)[1]);
}

std::optional<Vec3> ObjectReader::vector(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return std::nullopt;
  const Key& key = key_of(name);
  const NumberReader reader(key, whose_, errors_);
  if (key.type == ValueType::scale && value->kind == YamlNode::Kind::scalar) {
    const std::optional<double> factor = reader.number(*value);
    if (!factor) return std::nullopt;
    return Vec3(Vec3::Constant(*factor));
  }
  return reader.vector(*value);
}

std::optional<Quat> ObjectReader::quaternion(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return std::nullopt;
  const NumberReader reader(key_of(name), whose_, errors_);
  const std::vector<double> q = reader.numbers(*value, 4);
  if (q.empty()) return std::nullopt;
  const Quat result(q[0], q[1], q[2], q[3]);
  const double norm = result.coeffs().stableNorm();
  if (std::abs(norm - 1) <= limits::quaternion_error) return result;
  fail(name, std::string(name) + " has norm " + number_text(norm) + ", must be 1 (off by at most " +
                 number_text(limits::quaternion_error) + ")");
  return std::nullopt;
}

std::vector<Vec3> ObjectReader::vectors(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return {};
  const NumberReader reader(key_of(name), whose_, errors_);
  if (value->kind != YamlNode::Kind::list) return reader.wrong_type(*value), std::vector<Vec3>{};
  std::vector<Vec3> points;
  for (const YamlNode::Entry& entry : value->entries) {
    const std::optional<Vec3> point = reader.vector(*entry.value);
    if (!point) return {};
    points.push_back(*point);
  }
  return points;
}

std::vector<std::vector<double>> ObjectReader::rows(std::string_view name) const {
  const YamlNode* const value = find(name);
  if (!value) return {};
  const NumberReader reader(key_of(name), whose_, errors_);
  if (value->kind == YamlNode::Kind::list && !value->entries.empty()) return reader.rows(*value);
  reader.wrong_type(*value);
  return {};
}

std::vector<std::string> ObjectReader::names(std::string_view key) const {
  const YamlNode* const value = find(key);
  if (!value) return {};
  return read_name_pair(*value, whose_ + ": " + std::string(key), errors_);
}

std::vector<const YamlNode*> ObjectReader::list(std::string_view key) const {
  const YamlNode* const value = find(key);
  if (!value) return {};
  std::vector<const YamlNode*> items;
  if (value->kind != YamlNode::Kind::list) {
    NumberReader(key_of(key), whose_, errors_).wrong_type(*value);
    return items;
  }
  for (const YamlNode::Entry& entry : value->entries) items.push_back(entry.value.get());
  return items;
}

void ObjectReader::fail(std::string_view key, const std::string& message) const {
  const YamlNode* const value = find(key);
  errors_.add(value ? *value : node_, whose_ + ": " + message);
}

std::string whose_text(const std::string& kind, const YamlNode& object, std::size_t index) {
  const YamlNode::Entry* const name = object.find("name");
  const bool has_name = name && name->value->kind == YamlNode::Kind::scalar && !name->value->text.empty();
  return kind + " " + (has_name ? quoted_text(name->value->text) : std::to_string(index));
}

std::vector<std::string> read_name_pair(const YamlNode& node, const std::string& whose, SceneErrors& errors) {
  std::vector<std::string> names;
  if (node.kind == YamlNode::Kind::list) {
    for (const YamlNode::Entry& entry : node.entries) {
      if (entry.value->kind == YamlNode::Kind::scalar) names.push_back(entry.value->text);
    }
  }
  if (names.size() == 2 && node.entries.size() == 2) return names;
  errors.add(node, whose + " must be a list of 2 names, found " + found_text(node));
  return {};
}

}  // namespace rigor
