#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A value of a YAML document with its position. It is immutable once read; parts may be shared (aliases).
struct YamlNode {
  enum class Kind { null, scalar, list, map };
  using Pointer = std::shared_ptr<const YamlNode>;
  struct Entry {
    std::string key;           ///< Empty in a list.
    int line = 0, column = 0;  ///< Position of the key.
    Pointer value;
  };

  Kind kind = Kind::null;
  bool is_quoted = false;      ///< A scalar in quotes, which is text even if it looks like a number.
  int source = 0;              ///< Index into YamlSources.
  int line = 0, column = 0;    ///< From 1; 0 if the source has no lines.
  int height = 0;              ///< Levels below this one.
  std::size_t size = 1;        ///< Number of values in it, including itself, with aliases expanded.
  std::string text;            ///< Text of a scalar.
  std::vector<Entry> entries;  ///< Of a list or map, in order; a map may still contain a key twice.

  /// The first entry with this key in a map, or nothing.
  const Entry* find(std::string_view key) const;
};

/// Names of the sources: the file, then each override.
struct YamlSources {
  std::vector<std::string> names;

  /// "scene.yaml:12:5: ", or "--set a.b=1: " for sources without lines.
  std::string where(int source, int line, int column) const;
  std::string where(const YamlNode& node) const { return where(node.source, node.line, node.column); }
};

/// Limits on a document, far above any scene and far below what would exhaust memory or time.
struct YamlLimits {
  std::size_t max_bytes = std::size_t{32} << 20;
  std::size_t max_nodes = 500000;  ///< With aliases expanded.
  int max_depth = 32;
};

/// Reads the single document of the text. has_lines: positions in it are meaningful to the user. JSON is read
/// as well, including surrogate pairs in its strings. Refused are encodings other than UTF-8, syntax errors,
/// several documents, tags, keys that are not plain text, aliases that refer to themselves, and documents
/// beyond the limits. Throws InputError.
YamlNode::Pointer parse_yaml(const std::string& text, int source, const YamlSources& sources,
                             bool has_lines = true, const YamlLimits& limits = {});

}  // namespace rigor
