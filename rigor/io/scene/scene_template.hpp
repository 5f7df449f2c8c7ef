#pragma once

#include "rigor/io/scene/scene_reader.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A value that is put into a scene at a key, as of `--set`.
struct SceneValue {
  std::string key;
  YamlNode::Pointer value;
};

/// A scene file that is read and parsed once, and made a Scene many times with other values in it.
/// Used by any number of threads.
class SceneTemplate {
 public:
  /// settings: values that all scenes have in common. Throws InputError as read_scene does, but for what only
  /// shows when a scene is made.
  explicit SceneTemplate(const std::filesystem::path& path, const std::vector<SceneValue>& settings = {});

  /// The scene with these values as well; whose: in messages, "run 12". has_synonyms: false if a scene with
  /// values at the same keys has been made without warnings. Throws InputError.
  Scene make(const std::vector<SceneValue>& values, const std::string& whose, bool has_synonyms = true) const;

  const std::filesystem::path& path() const { return path_; }
  /// Of the file.
  const std::string& text() const { return text_; }

 private:
  std::filesystem::path path_;
  std::string text_;
  YamlNode::Pointer root_;
};

/// A scalar with this number; source: its index in YamlSources.
YamlNode::Pointer number_node(double value, int source);

}  // namespace rigor
