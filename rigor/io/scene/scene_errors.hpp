#pragma once

#include "rigor/io/files/yaml_document.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rigor {

/// Collects the errors of a scene with their positions.
class SceneErrors {
 public:
  explicit SceneErrors(const YamlSources& sources) : sources_(sources) {}

  void add(const YamlNode& node, const std::string& message) { add_text(where(node) + message); }
  /// A message at a key rather than at its value.
  void add_at_key(const YamlNode& object, const YamlNode::Entry& entry, const std::string& message);
  /// Adds a message that already has its position.
  void add_text(const std::string& message);
  void add_warning(const YamlNode& node, const std::string& message) {
    warnings_.push_back(where(node) + message);
  }

  std::string where(const YamlNode& node) const { return sources_.where(node); }
  /// Whether enough errors have been found that looking for more is of no use.
  bool is_full() const;
  std::size_t count() const { return messages_.size() + left_out_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// All messages in the order of the lines, those of the file before those of the overrides; the last one
  /// says if there were too many to show.
  std::vector<std::string> sorted_messages() const;

 private:
  const YamlSources& sources_;
  std::vector<std::string> messages_;
  std::vector<std::string> warnings_;
  std::size_t left_out_ = 0;
};

}  // namespace rigor
