#include "rigor/io/scene/scene_overrides.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/scene/scene_keys.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace rigor {

namespace {

/// One level of the path: the index of the entry in its list or map, and the rest of the path.
struct Step {
  std::size_t index;
  std::string_view rest;
};

std::string_view without_point(std::string_view path) {
  return path.starts_with('.') ? path.substr(1) : path;
}

/// Whether the path goes through `name`, which may contain points itself.
bool leads_through(std::string_view path, std::string_view name) {
  if (!path.starts_with(name)) return false;
  const std::string_view rest = path.substr(name.size());
  return rest.empty() || rest[0] == '.' || rest[0] == '[';
}

/// The table of the mappings below a key; null if there is none, or one a type.
const KeyTable* table_below(const Key* key) {
  if (!key || key->object.empty()) return nullptr;
  for (const KeyTable& table : key_tables()) {
    if (table.object == key->object) return &table;
  }
  return nullptr;
}

/// The default of a key that is a list of scalars, "[0, 0, 0]", as a node; of any other, nothing.
YamlNode default_list(const Key* key, int source) {
  YamlNode list;
  list.source = source;
  if (!key || !key->fallback.starts_with('[') || !key->fallback.ends_with(']')) return list;
  list.kind = YamlNode::Kind::list;
  std::string_view left = std::string_view(key->fallback).substr(1, key->fallback.size() - 2);
  while (!left.empty()) {
    const std::size_t comma = std::min(left.find(", "), left.size());
    const auto entry = std::make_shared<YamlNode>();
    entry->kind = YamlNode::Kind::scalar;
    entry->source = source;
    entry->text = left.substr(0, comma);
    list.entries.push_back({"", 0, 0, entry});
    left.remove_prefix(std::min(left.size(), comma + 2));
  }
  return list;
}

class Override {
 public:
  Override(std::string where, YamlNode::Pointer value) : where_(std::move(where)), value_(std::move(value)) {}

  /// A copy of the node with the value placed at the end of the path. table: of the keys of a mapping here;
  /// null if they are not known.
  YamlNode::Pointer applied(const YamlNode& node, std::string_view path, const KeyTable* table) const {
    if (path.empty()) return value_;
    if (node.kind == YamlNode::Kind::list) return in_list(node, path, table);
    if (node.kind == YamlNode::Kind::scalar) fail("there is nothing below " + quoted_text(node.text));
    return in_map(node, path, table);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError(where_ + message); }

  YamlNode::Pointer in_map(const YamlNode& node, std::string_view path, const KeyTable* table) const {
    const std::size_t end = path.find_first_of(".[");
    const std::string_view key = path.substr(0, end);
    const std::string_view rest = end == std::string_view::npos ? "" : without_point(path.substr(end));
    if (key.empty()) fail("a key is empty");
    const Key* const known = table ? table->find(key) : nullptr;
    const auto copy = std::make_shared<YamlNode>(node);
    copy->kind = YamlNode::Kind::map;
    for (YamlNode::Entry& entry : copy->entries) {
      if (entry.key != key) continue;
      entry.value = applied(*entry.value, rest, table_below(known));
      return copy;
    }
    // One number of a list that is not written: the others are those of its default.
    const YamlNode missing = default_list(known, value_->source);
    copy->entries.push_back({std::string(key), 0, 0, applied(missing, rest, table_below(known))});
    return copy;
  }

  YamlNode::Pointer in_list(const YamlNode& node, std::string_view path, const KeyTable* table) const {
    std::optional<Step> step = by_name(node, path);
    if (!step) step = by_index(node, path);
    const auto copy = std::make_shared<YamlNode>(node);
    copy->entries[step->index].value = applied(*node.entries[step->index].value, step->rest, table);
    return copy;
  }

  static std::string_view name_of(const YamlNode::Entry& entry) {
    const YamlNode::Entry* const name = entry.value->find("name");
    return name && name->value->kind == YamlNode::Kind::scalar ? std::string_view(name->value->text) : "";
  }

  /// The entry with the longest matching name, because names may contain points.
  static std::optional<Step> by_name(const YamlNode& node, std::string_view path) {
    std::optional<Step> best;
    std::size_t length = 0;
    for (std::size_t i = 0; i < node.entries.size(); ++i) {
      const std::string_view name = name_of(node.entries[i]);
      if (name.size() <= length || !leads_through(path, name)) continue;
      length = name.size();
      best = Step{i, without_point(path.substr(length))};
    }
    return best;
  }

  Step by_index(const YamlNode& node, std::string_view path) const {
    const bool has_bracket = path.starts_with('[');
    const char* const begin = path.data() + (has_bracket ? 1 : 0);
    const char* const path_end = path.data() + path.size();
    std::size_t index = 0;
    auto [end, error] = std::from_chars(begin, path_end, index);
    const bool is_closed = !has_bracket || (end < path_end && *end == ']');
    if (has_bracket && is_closed && error == std::errc()) ++end;
    const bool is_end = end == path_end || *end == '.' || *end == '[';
    if (error != std::errc() || !is_closed || !is_end) fail_name(node, path);
    if (index >= node.entries.size()) {
      fail("index " + std::to_string(index) + ", but the list has " + std::to_string(node.entries.size()) +
           " entries (the first is 0)");
    }
    return {index, without_point(path.substr(at(end - path.data())))};
  }

  [[noreturn]] void fail_name(const YamlNode& node, std::string_view path) const {
    std::vector<std::string> names;
    for (const YamlNode::Entry& entry : node.entries) {
      if (!name_of(entry).empty()) names.emplace_back(name_of(entry));
    }
    const std::string_view written = path.substr(0, path.find('.'));
    fail("there is no " + quoted_text(written) + " in the list" + suggestion(written, names));
  }

  std::string where_;
  YamlNode::Pointer value_;
};

}  // namespace

YamlNode::Pointer with_override(const YamlNode::Pointer& root, const std::string& text, int source,
                                const YamlSources& sources) {
  const std::string where = sources.where(source, 0, 0);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw InputError(where + "must be KEY=VALUE");
  const YamlNode::Pointer value = parse_yaml(text.substr(equals + 1), source, sources, false);
  return with_value(root, text.substr(0, equals), value, where);
}

YamlNode::Pointer with_value(const YamlNode::Pointer& root, const std::string& path,
                             const YamlNode::Pointer& value, const std::string& where) {
  const auto steps = std::count_if(path.begin(), path.end(), [](char c) { return c == '.' || c == '['; });
  if (steps >= YamlLimits{}.max_depth) throw InputError(where + "the key has too many parts");
  return Override(where, value).applied(*root, path, &key_table("scene"));
}

}  // namespace rigor
