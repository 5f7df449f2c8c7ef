#include "rigor/io/scene/scene_errors.hpp"

#include "rigor/model/limits.hpp"

#include <algorithm>
#include <charconv>
#include <tuple>

namespace rigor {

namespace {

/// Source, line and column of a message "name:12:5: ...", parsed from its beginning.
std::tuple<std::size_t, int, int> place_of(const std::string& message,
                                           const std::vector<std::string>& names) {
  for (std::size_t source = 0; source < names.size(); ++source) {
    if (!message.starts_with(names[source] + ":")) continue;
    const char* const end = message.data() + message.size();
    int line = 0, column = 0;
    const auto [after_line, error] = std::from_chars(message.data() + names[source].size() + 1, end, line);
    if (error == std::errc() && after_line < end) std::from_chars(after_line + 1, end, column);
    return {source, line, column};
  }
  return {names.size(), 0, 0};
}

}  // namespace

void SceneErrors::add_at_key(const YamlNode& object, const YamlNode::Entry& entry,
                             const std::string& message) {
  // An entry that comes from an override has its own source.
  const int source = entry.line == 0 ? entry.value->source : object.source;
  add_text(sources_.where(source, entry.line, entry.column) + message);
}

void SceneErrors::add_text(const std::string& message) {
  if (is_full()) {
    ++left_out_;
    return;
  }
  messages_.push_back(message);
}

bool SceneErrors::is_full() const {
  return messages_.size() >= limits::message_count;
}

std::vector<std::string> SceneErrors::sorted_messages() const {
  std::vector<std::string> sorted = messages_;
  std::stable_sort(sorted.begin(), sorted.end(), [this](const std::string& a, const std::string& b) {
    return place_of(a, sources_.names) < place_of(b, sources_.names);
  });
  if (is_full())
    sorted.push_back("these are the first " + std::to_string(sorted.size()) + " mistakes; there may be more");
  return sorted;
}

}  // namespace rigor
