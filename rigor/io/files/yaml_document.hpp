#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A value of a YAML document with its place. Immutable once read; parts may be shared (aliases).
struct YamlNode {
  enum class Kind { null, scalar, list, map };
  using Pointer = std::shared_ptr<const YamlNode>;
  struct Entry {
    std::string key;           ///< Empty in a list.
    int line = 0, column = 0;  ///< Of the key.
    Pointer value;
  };

  Kind kind = Kind::null;
  bool is_quoted = false;      ///< Scalars: written in quotes, so it is text even if it looks like a number.
  int source = 0;              ///< Index into YamlSources.
  int line = 0, column = 0;    ///< From 1; 0 if the source has no lines.
  int height = 0;              ///< Levels below this one.
  std::size_t size = 1;        ///< Values in it, itself included, aliases written out.
  std::string text;            ///< Scalars.
  std::vector<Entry> entries;  ///< Of a list or map, in their order; a map may still hold a key twice.

  /// First entry of the key in a map, or nothing.
  const Entry* find(std::string_view key) const;
};

/// Names of what was read: the file, then each override.
struct YamlSources {
  std::vector<std::string> names;

  /// "scene.yaml:12:5: ", or "--set a.b=1: " where there are no lines.
  std::string where(int source, int line, int column) const;
  std::string where(const YamlNode& node) const { return where(node.source, node.line, node.column); }
};

/// What a document may hold. The limits are far above any scene and far below what hurts.
struct YamlLimits {
  std::size_t max_bytes = std::size_t{32} << 20;
  std::size_t max_nodes = 500000;  ///< Aliases written out.
  int max_depth = 32;
};

/// The one document of the text; has_lines: whether places in it mean something to the user. JSON is read as
/// well, surrogate pairs in its strings included. Refused: other encodings than UTF-8, syntax errors, several
/// documents, tags, keys that are not plain text, aliases that lead into themselves, too much of anything.
/// Throws InputError.
YamlNode::Pointer parse_yaml(const std::string& text, int source, const YamlSources& sources,
                             bool has_lines = true, const YamlLimits& limits = {});

}  // namespace rigor
