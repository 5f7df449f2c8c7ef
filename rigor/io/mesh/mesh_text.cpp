#include "rigor/io/mesh/mesh_text.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

namespace rigor {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

char lowered(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Removes the plus sign, which std::from_chars does not accept.
std::string_view without_plus(std::string_view word) {
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return has_plus ? word.substr(1) : word;
}

}  // namespace

MeshText::MeshText(std::string_view text, std::string name, char comment)
    : text_(text), name_(std::move(name)), comment_(comment) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;  // byte order mark of UTF-8
}

bool MeshText::next_line() {
  words_.clear();
  while (words_.empty()) {
    if (!append_line()) return false;
  }
  return true;
}

bool MeshText::append_line() {
  if (position_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  ++line_;
  split(text_.substr(position_, end - position_));
  position_ = std::min(end + 1, text_.size());
  return true;
}

void MeshText::split(std::string_view line) {
  if (comment_ != 0) line = line.substr(0, line.find(comment_));
  for (std::size_t i = 0; i < line.size();) {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && !is_blank(line[end])) ++end;
    words_.push_back(line.substr(i, end - i));
    i = end;
  }
}

double MeshText::number(std::string_view word) const {
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    fail(quoted_text(word) +
         " is out of the range of double precision; allowed are sizes between 1e-307 and 1e308, and 0");
  }
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    fail(quoted_text(word) + " is not a number; allowed are finite decimal numbers such as -1.5 or 2e-3");
  }
  return value;
}

std::int64_t MeshText::whole_number(std::string_view word) const {
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) fail(quoted_text(word) + " is too large for a whole number");
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(quoted_text(word) + " is not a whole number");
  return value;
}

void MeshText::fail(const std::string& what) const {
  fail_at(std::max<std::size_t>(line_, 1), what);
}

void MeshText::fail_at(std::size_t line, const std::string& what) const {
  throw InputError(fmt::format("{}:{}: {}", name_, line, what));
}

bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return lowered(a) == b; });
}

}  // namespace rigor
