#include "apps/variation.hpp"

#include "apps/usage_error.hpp"
#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

namespace rigor {

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

[[noreturn]] void fail(const std::string& text, const std::string& what) {
  throw UsageError(fmt::format("--vary {}: {}", quoted_text(text), what));
}

/// Reads values as YAML would, but only far enough to know which commas separate them.
class ValueScanner {
 public:
  /// Reads the next character; whether it is a comma between values.
  bool parts_at(char c) {
    if (!quote_.empty()) {
      take_quoted(c);
      return false;
    }
    const bool is_comma = c == ',' && open_.empty();
    take_plain(c);
    return is_comma;
  }

  /// What is still open at the end: a bracket or a quote, or nothing.
  std::string open() const {
    return quote_.empty() && !open_.empty() ? open_.substr(open_.size() - 1) : quote_;
  }

 private:
  void take_quoted(char c) {
    if (is_escaped_) {
      is_escaped_ = false;
    } else if (c == '\\' && quote_ == "\"") {
      is_escaped_ = true;
    } else if (c == quote_[0]) {
      quote_.clear();
      // Two single quotes in a row, which stand for a quote, reopen the text.
      can_open_quote_ = c == '\'';
    }
  }

  void take_plain(char c) {
    if ((c == '"' || c == '\'') && can_open_quote_) quote_ = c;
    if (c == '[' || c == '{') open_ += c;
    if (!open_.empty() && c == (open_.back() == '[' ? ']' : '}')) open_.pop_back();
    // An apostrophe inside a word is not a quote.
    if (blanks.find(c) == std::string_view::npos)
      can_open_quote_ = std::string_view("[{,:").find(c) != std::string_view::npos;
  }

  std::string open_;   ///< Brackets and braces, the innermost last.
  std::string quote_;  ///< The open quote, or empty.
  bool is_escaped_ = false;
  bool can_open_quote_ = true;
};

std::vector<std::string> split_values(const std::string& text, std::string_view list) {
  std::vector<std::string> values;
  ValueScanner scanner;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!scanner.parts_at(list[i])) continue;
    values.push_back(trimmed(list.substr(begin, i - begin)));
    begin = i + 1;
  }
  if (!scanner.open().empty()) fail(text, fmt::format("a {} is not closed", scanner.open()));
  values.push_back(trimmed(list.substr(begin)));
  return values;
}

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

void check_values(const std::string& text, const std::vector<std::string>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].empty()) fail(text, fmt::format("value {} is empty; must be KEY=a,b,c", i + 1));
    for (std::size_t k = 0; k < i; ++k) {
      if (values[k] == values[i]) fail(text, fmt::format("value {} is given twice", quoted_text(values[i])));
      const std::optional<double> number = number_of(values[i]);
      if (number && number == number_of(values[k]))
        fail(text, fmt::format("values {} and {} are the same number", quoted_text(values[k]),
                               quoted_text(values[i])));
    }
  }
}

}  // namespace

Variation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) fail(text, "must be KEY=a,b,c");
  Variation variation{trimmed(std::string_view(text).substr(0, equals)),
                      split_values(text, std::string_view(text).substr(equals + 1))};
  if (variation.key.empty()) fail(text, "the key is empty; must be KEY=a,b,c");
  check_values(text, variation.values);
  return variation;
}

std::vector<Combination> combinations(const std::vector<Variation>& variations, std::size_t most) {
  std::size_t count = 1;
  std::string factors;
  for (std::size_t i = 0; i < variations.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (variations[k].key == variations[i].key)
        throw UsageError(
            fmt::format("--vary {} is given twice; give all its values at once", variations[i].key));
    }
    count *= variations[i].values.size();
    factors += fmt::format("{}{}", i == 0 ? "" : " x ", variations[i].values.size());
    // Counting can stop here, because all factors are at least one.
    if (count > most)
      throw UsageError(fmt::format("--vary asks for {} runs{}, must be at most {}", count,
                                   i > 0 ? fmt::format(" ({})", factors) : "", most));
  }
  std::vector<Combination> all = {{}};
  for (const Variation& variation : variations) {
    std::vector<Combination> longer;
    for (const Combination& combination : all) {
      for (const std::string& value : variation.values) {
        longer.push_back(combination);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string combination_label(const std::vector<Variation>& variations, const Combination& combination) {
  std::string label;
  for (std::size_t i = 0; i < variations.size(); ++i) {
    label += fmt::format("{}{}={}", i == 0 ? "" : ", ", variations[i].key, combination[i]);
  }
  return label;
}

}  // namespace rigor
