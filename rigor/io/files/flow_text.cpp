#include "rigor/io/files/flow_text.hpp"

#include "rigor/io/files/json_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace rigor {

namespace {

/// Whether a text means itself without quotes wherever it stands on a line.
bool is_plain(const std::string& text) {
  const auto is_safe = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '+' || c == '-' ||
           c == ' ';
  };
  // "- " begins a list, and blanks at the ends are lost.
  return !text.empty() && text.front() != ' ' && text.back() != ' ' && !text.starts_with("- ") &&
         text != "-" && !text.starts_with("---") && !text.starts_with("...") &&
         std::all_of(text.begin(), text.end(), is_safe);
}

/// In double quotes, whose escapes YAML shares with JSON.
std::string in_quotes(const std::string& text) {
  return json_line(nlohmann::ordered_json(text));
}

}  // namespace

std::string flow_text(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::null) return "null";
  if (node.kind == YamlNode::Kind::scalar)
    return !node.is_quoted && is_plain(node.text) ? node.text : in_quotes(node.text);
  const bool is_map = node.kind == YamlNode::Kind::map;
  std::string text = is_map ? "{" : "[";
  for (const YamlNode::Entry& entry : node.entries) {
    if (text.size() > 1) text += ", ";
    if (is_map) text += (is_plain(entry.key) ? entry.key : in_quotes(entry.key)) + ": ";
    text += flow_text(*entry.value);
  }
  return text + (is_map ? "}" : "]");
}

}  // namespace rigor
