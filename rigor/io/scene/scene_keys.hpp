#pragma once

#include "rigor/core/range.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// The form of the value of a key in a scene file.
enum class ValueType {
  number,
  whole,  ///< Number without fraction.
  text,
  flag,          ///< true or false.
  choice,        ///< One of Key::choices.
  angle,         ///< Number in rad, or text such as "30 deg" or "0.5 rad".
  vector,        ///< 3 numbers.
  whole_vector,  ///< 3 whole numbers.
  angles,        ///< 3 angles.
  vector2,       ///< 2 numbers x, y.
  range,         ///< 2 numbers, lowest and highest.
  angle_range,   ///< 2 angles, lowest and highest.
  quaternion,    ///< 4 numbers w, x, y, z.
  scale,         ///< Number, or 3 numbers.
  vectors,       ///< List of vectors.
  rows,          ///< List of lists of numbers, all of the same length.
  names,         ///< Two names.
  name_pairs,    ///< List of two names.
  object,        ///< Mapping with the keys of the table Key::object.
  objects,       ///< List of such mappings.
  function,      ///< Of the time: number, formula, or mapping with the keys of the table "function".
};

/// A key of an object of the scene file: everything that the reader, the documentation and the JSON Schema
/// know about it.
struct Key {
  std::string name;
  ValueType type;
  std::string unit;
  std::string fallback;  ///< Default as written in a file, or "required", or "-" if absence has a meaning.
  Range range;           ///< Range of a number, or of each number of a list.
  std::string meaning;
  std::vector<std::string> choices;  ///< Values that this version supports.
  std::string object;  ///< Table of the mapping's keys: "inertia"; a family ("shape") stands for its tables.
  bool is_available = true;  ///< In this version; otherwise only an empty value is allowed.
  std::string instead;       ///< For unavailable keys: the alternative.

  bool is_required() const { return std::string_view(fallback) == "required"; }
};

/// The keys of one kind of object.
struct KeyTable {
  std::string object;  ///< "body", "sphere", ...
  std::string title;   ///< With an article, for messages: "a body".
  std::string family;  ///< "shape", "force" or "joint" for their types, "coordinate", or empty.
  std::vector<Key> keys;

  const Key* find(std::string_view name) const;
  /// Names of the keys that this version supports.
  std::vector<std::string> names() const;
};

/// All tables, in the order of the documentation.
const std::vector<KeyTable>& key_tables();
/// The table of an object, which must exist.
const KeyTable& key_table(std::string_view object);
/// Names of the types of a family: "sphere", "box", ...
std::vector<std::string> types_of(std::string_view family);

// Parts of key_tables(), one a file.
std::vector<KeyTable> top_key_tables();
std::vector<KeyTable> body_key_tables();
std::vector<KeyTable> shape_key_tables();
std::vector<KeyTable> force_key_tables();
std::vector<KeyTable> joint_key_tables();

}  // namespace rigor
