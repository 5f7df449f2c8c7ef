#include "rigor/io/files/scalar_text.hpp"

#include "rigor/core/quoted.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

std::string lower_case(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

std::optional<double> special_number(std::string_view text) {
  if (text.empty() || text.size() > 10) return std::nullopt;
  const bool is_negative = text[0] == '-';
  if (text[0] == '-' || text[0] == '+') text.remove_prefix(1);
  if (text.starts_with('.')) text.remove_prefix(1);
  const std::string word = lower_case(text);
  if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (word != "inf" && word != "infinity") return std::nullopt;
  return is_negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

bool has_only(std::string_view text, std::string_view letters) {
  return text.find_first_not_of(letters) == std::string_view::npos;
}

std::string number_hint(std::string_view text) {
  if (text.size() > 40) return "";
  if (has_only(text, "+-.,0123456789eE") && std::count(text.begin(), text.end(), ',') == 1) {
    std::string with_point(text);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    return "; write " + with_point;
  }
  if (text.starts_with("0x") || text.starts_with("0X")) return "; numbers are decimal";
  return "";
}

}  // namespace

NumberText parse_number(std::string_view text) {
  const auto none = [&text] { return NumberText{std::nullopt, number_hint(text)}; };
  // A sign, then a digit or a point: from_chars alone would accept words such as "inf" and the text "-+1".
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const std::size_t first = digits.starts_with('-') && !text.starts_with('+') ? 1 : 0;
  const std::size_t digit = first < digits.size() && digits[first] == '.' ? first + 1 : first;
  if (digit >= digits.size() || digits[digit] < '0' || digits[digit] > '9') {
    const std::optional<double> special = special_number(text);
    return special ? NumberText{special, ""} : none();
  }

  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size()) return none();
  if (error == std::errc::result_out_of_range) return {std::nullopt, "; it is out of the range of a double"};
  if (error != std::errc()) return none();
  return {value, ""};
}

std::optional<double> parse_angle(std::string_view text) {
  const std::size_t end = text.find_last_not_of(' ');
  if (end == std::string_view::npos || end < 3) return std::nullopt;
  const std::string_view unit = text.substr(end - 2, 3);
  std::string_view number = text.substr(0, end - 2);
  while (number.ends_with(' ')) number.remove_suffix(1);
  const std::optional<double> value = parse_number(number).value;
  if (!value || (unit != "deg" && unit != "rad")) return std::nullopt;
  return unit == "deg" ? *value * std::numbers::pi / 180 : *value;
}

bool is_text(const YamlNode& scalar) {
  const bool is_truth_value = scalar.text == "true" || scalar.text == "false";
  return scalar.is_quoted || (!is_truth_value && !parse_number(scalar.text).value);
}

std::string found_text(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "nothing";
    case YamlNode::Kind::list:
      return "a list of " + std::to_string(node.entries.size());
    case YamlNode::Kind::map:
      return "a mapping";
    case YamlNode::Kind::scalar:
      break;
  }
  if (is_text(node)) return "the text " + quoted_text(node.text);
  return parse_number(node.text).value ? "the number " + quoted_text(node.text) : node.text;
}

}  // namespace rigor
