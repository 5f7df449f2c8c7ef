#include "rigor/io/files/yaml_document.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/text_file.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>
#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>
#include <utility>

namespace rigor {

namespace {

using Node = std::shared_ptr<YamlNode>;

/// Builds the tree from the parser's events. Everything is checked before it is stored.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(int source, const YamlSources& sources, bool has_lines, const YamlLimits& limits)
      : source_(source), sources_(sources), has_lines_(has_lines), limits_(limits) {}

  YamlNode::Pointer root() const { return root_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (root_) fail(mark, "a second document starts here; a scene is one document");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    store(make_node(mark, YamlNode::Kind::null), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_tag(mark, tag);
    if (wants_key()) {
      if (anchor != 0) fail(mark, "an anchor on a key; keys are plain text");
      open_.back().key = {value, place(mark).first, place(mark).second, nullptr};
      open_.back().has_key = true;
      return;
    }
    const Node node = make_node(mark, YamlNode::Kind::scalar);
    node->is_quoted = tag == "!";
    node->text = value;
    const bool is_null = !node->is_quoted && (value.empty() || value == "~" || value == "null");
    if (is_null) node->kind = YamlNode::Kind::null;
    store(node, anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::list);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::map);
  }
  void OnMapEnd() override { close(); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (wants_key()) fail(mark, "an alias as a key; keys are plain text");
    const auto named = anchors_.find(anchor);
    if (named == anchors_.end()) fail(mark, "an alias inside of what it names");
    count(mark, named->second->size);
    if (static_cast<int>(open_.size()) + named->second->height >= limits_.max_depth) fail_depth(mark);
    attach(named->second);
  }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    const auto [line, column] = place(mark);
    throw InputError(sources_.where(source_, line, column) + message);
  }

 private:
  struct Open {
    Node node;
    YAML::anchor_t anchor = 0;
    YamlNode::Entry key;
    bool has_key = false;
  };

  /// Line and column, counted from 1, or zeros.
  std::pair<int, int> place(const YAML::Mark& mark) const {
    return has_lines_ && mark.line >= 0 ? std::pair{mark.line + 1, mark.column + 1} : std::pair{0, 0};
  }

  bool wants_key() const {
    return !open_.empty() && open_.back().node->kind == YamlNode::Kind::map && !open_.back().has_key;
  }

  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    fail(mark, "the tag " + quoted_text(tag) + "; tags are not part of a scene");
  }

  [[noreturn]] void fail_depth(const YAML::Mark& mark) const {
    fail(mark, "nested deeper than " + std::to_string(limits_.max_depth) + " levels");
  }

  void count(const YAML::Mark& mark, std::size_t nodes) {
    node_count_ += nodes;
    if (node_count_ > limits_.max_nodes) {
      fail(mark, "more than " + std::to_string(limits_.max_nodes) + " values (aliases written out)");
    }
  }

  Node make_node(const YAML::Mark& mark, YamlNode::Kind kind) {
    if (wants_key()) fail(mark, "a key that is not plain text, or a bracket that is not closed");
    count(mark, 1);
    Node node = std::make_shared<YamlNode>();
    node->kind = kind;
    node->source = source_;
    std::tie(node->line, node->column) = place(mark);
    return node;
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
    check_tag(mark, tag);
    if (static_cast<int>(open_.size()) >= limits_.max_depth) fail_depth(mark);
    open_.push_back({make_node(mark, kind), anchor, {}, false});
  }

  void close() {
    const Open closed = std::move(open_.back());
    open_.pop_back();
    store(closed.node, closed.anchor);
  }

  void store(const Node& node, YAML::anchor_t anchor) {
    if (anchor != 0) anchors_[anchor] = node;
    attach(node);
  }

  /// Attaches a finished node to the node that contains it.
  void attach(const Node& node) {
    if (open_.empty()) {
      root_ = node;
      return;
    }
    Open& parent = open_.back();
    parent.key.value = node;
    parent.node->entries.push_back(std::move(parent.key));
    parent.node->size += node->size;
    parent.node->height = std::max(parent.node->height, node->height + 1);
    parent.key = {};
    parent.has_key = false;
  }

  int source_;
  const YamlSources& sources_;
  bool has_lines_;
  const YamlLimits& limits_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Node> anchors_;
  std::size_t node_count_ = 0;
  Node root_;
};

/// Value of the 4 hexadecimal digits at `at`, if there is an escape \uXXXX there; else 0.
std::uint32_t escaped_unit(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "\\u") != 0 || at + 6 > text.size()) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = at + 2; i < at + 6; ++i) {
    const char c = text[i];
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) return 0;
    value = value * 16 + static_cast<std::uint32_t>(digit);
  }
  return value;
}

/// JSON writes characters beyond U+FFFF as two escapes \uD83D\uDE00, which YAML does not know: they become
/// \U0001F600. This is done only in text that starts like JSON; the length of the line changes by at most two
/// characters.
std::string with_long_escapes(std::string text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || (text[first] != '{' && text[first] != '[')) return text;
  // Each backslash belongs to the character after it.
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 2)) {
    const std::uint32_t high = escaped_unit(text, at);
    if (high < 0xD800 || high > 0xDBFF || at + 12 > text.size()) continue;
    const std::uint32_t low = escaped_unit(text, at + 6);
    if (low < 0xDC00 || low > 0xDFFF) continue;
    const std::uint32_t code = 0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00);
    std::string escape = "\\U00000000";
    for (std::size_t digit = 0; digit < 6; ++digit) {
      escape[9 - digit] = "0123456789ABCDEF"[code >> (4 * digit) & 15];
    }
    text.replace(at, 12, escape);
  }
  return text;
}

}  // namespace

const YamlNode::Entry* YamlNode::find(std::string_view key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return kind == Kind::map && found != entries.end() ? &*found : nullptr;
}

std::string YamlSources::where(int source, int line, int column) const {
  const std::string& name = names[static_cast<std::size_t>(source)];
  if (line == 0) return name + ": ";
  return name + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

YamlNode::Pointer parse_yaml(const std::string& text, int source, const YamlSources& sources, bool has_lines,
                             const YamlLimits& limits) {
  const std::string& name = sources.names[static_cast<std::size_t>(source)];
  if (text.size() > limits.max_bytes) {
    throw InputError(name + ": it has " + std::to_string(text.size()) + " bytes, must be at most " +
                     std::to_string(limits.max_bytes));
  }
  check_text(text, name);
  TreeBuilder builder(source, sources, has_lines, limits);
  try {
    std::istringstream stream(with_long_escapes(text));
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    builder.fail(error.mark, "not YAML: " + error.msg);
  }
  if (!builder.root()) throw InputError(name + ": it is empty");
  return builder.root();
}

}  // namespace rigor
