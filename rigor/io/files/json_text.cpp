#include "rigor/io/files/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

constexpr int one_line = -1;

bool is_scalar_list(const Json& value) {
  return value.is_array() &&
         std::none_of(value.begin(), value.end(), [](const Json& x) { return x.is_structured(); });
}

std::string scalar_text(const Json& value) {
  if (!value.is_number_float()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  const double number = value.get<double>();
  return std::isfinite(number) ? fmt::format("{:.17g}", number) : "null";
}

void append(const Json& value, int level, std::string& text) {
  if (!value.is_structured()) {
    text += scalar_text(value);
    return;
  }
  const bool is_flat = level == one_line || value.empty() || is_scalar_list(value);
  const int inner = is_flat ? one_line : level + 1;
  const std::string gap = is_flat ? "" : fmt::format("\n{:{}}", "", 2 * inner);
  text += value.is_object() ? "{" : "[";
  bool is_first = true;
  for (const auto& item : value.items()) {
    if (!is_first) text += is_flat ? ", " : ",";
    is_first = false;
    text += gap;
    if (value.is_object()) text += scalar_text(Json(item.key())) + ": ";
    append(item.value(), inner, text);
  }
  if (!is_flat) text += fmt::format("\n{:{}}", "", 2 * level);
  text += value.is_object() ? "}" : "]";
}

}  // namespace

std::string json_text(const Json& value) {
  std::string text;
  append(value, 0, text);
  return text;
}

std::string json_line(const Json& value) {
  std::string text;
  append(value, one_line, text);
  return text;
}

}  // namespace rigor
