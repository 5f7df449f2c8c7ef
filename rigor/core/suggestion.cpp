#include "rigor/core/suggestion.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rigor {

namespace {

/// Longer words are never typing errors of a name; comparing them would only cost time.
constexpr std::size_t longest_compared = 64;
constexpr std::size_t most_listed = 12;

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table d[i][j]: the distance between the first i letters of a and the first j letters of b.
  std::vector<int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substitution = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({substitution, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::optional<std::string> find_nearest_name(std::string_view written, std::span<const std::string> names) {
  if (written.empty() || written.size() > longest_compared) return std::nullopt;
  const std::string small = lower_case(written);
  std::optional<std::string> nearest;
  int allowed = std::max(1, static_cast<int>(written.size()) / 3);
  for (const std::string& name : names) {
    if (name.size() > longest_compared) continue;
    const int distance = edit_distance(small, lower_case(name));
    const bool shares_nothing = distance >= static_cast<int>(std::max(name.size(), written.size()));
    if (distance > allowed || shares_nothing) continue;
    nearest = name;
    allowed = distance - 1;
  }
  return nearest;
}

std::string suggestion(std::string_view written, std::span<const std::string> names) {
  const std::optional<std::string> nearest = find_nearest_name(written, names);
  if (nearest) return "; did you mean '" + *nearest + "'?";
  if (names.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i)
    list += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most_listed) list += ", ...";
  return "; one of: " + list;
}

}  // namespace rigor
