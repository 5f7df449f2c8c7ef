#pragma once

#include "rigor/io/files/yaml_document.hpp"
#include "rigor/io/scene/scene_errors.hpp"
#include "rigor/io/scene/scene_keys.hpp"
#include "rigor/math/types.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Reads one mapping of a scene by its key table. The constructor checks the keys: unknown, duplicate,
/// missing, or of a later version. Each value is checked when it is requested; an invalid one is reported and
/// counts as absent, so that one mistake gives one message.
class ObjectReader {
 public:
  /// whose: "body 'ball'". All arguments must outlive this object.
  ObjectReader(const YamlNode& node, const KeyTable& table, std::string whose, SceneErrors& errors);

  const YamlNode& node() const { return node_; }
  const std::string& whose() const { return whose_; }
  SceneErrors& errors() const { return errors_; }

  /// Value of a key of the table, or null if it is absent or null.
  const YamlNode* find(std::string_view key) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }

  std::optional<double> number(std::string_view key) const;     ///< number, whole, angle [rad].
  std::optional<std::string> text(std::string_view key) const;  ///< text, choice.
  std::optional<bool> flag(std::string_view key) const;
  /// For range and angle_range [rad]: lowest and highest value as written.
  std::optional<std::array<double, 2>> range(std::string_view key) const;
  std::optional<Vec2> vector2(std::string_view key) const;
  std::optional<Vec3> vector(std::string_view key) const;      ///< vector, whole_vector, angles [rad], scale.
  std::optional<Quat> quaternion(std::string_view key) const;  ///< As written, with a norm near 1.
  std::vector<Vec3> vectors(std::string_view key) const;       ///< Empty if absent or wrong.
  /// Rows of one length, at least 1 by 1; empty if absent or wrong.
  std::vector<std::vector<double>> rows(std::string_view key) const;
  std::vector<std::string> names(std::string_view key) const;     ///< Two names, or none.
  std::vector<const YamlNode*> list(std::string_view key) const;  ///< Of objects or name_pairs.

  /// Reports "body 'ball': message" at the value of the key, or at the object if the key is absent.
  void fail(std::string_view key, const std::string& message) const;

 private:
  const Key& key_of(std::string_view name) const;
  void check_keys() const;

  const YamlNode& node_;
  const KeyTable& table_;
  std::string whose_;
  SceneErrors& errors_;
};

/// "body 'ball'" for an object with a name, "body 3" for one without.
std::string whose_text(const std::string& kind, const YamlNode& object, std::size_t index);

/// The two names of a pair; none, and a message that starts with `whose`, if it is not a list of two texts.
std::vector<std::string> read_name_pair(const YamlNode& node, const std::string& whose, SceneErrors& errors);

}  // namespace rigor
