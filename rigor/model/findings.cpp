#include "rigor/model/findings.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace rigor {

bool Findings::require(bool condition, std::string_view message) {
  if (!condition) add(message);
  return condition;
}

bool Findings::check(std::string_view quantity, double value, const Range& range, std::string_view unit) {
  const std::string message = range_error(quantity, value, range, unit);
  return require(message.empty(), message);
}

bool Findings::check(std::string_view quantity, const Vec3& value, const Range& range,
                     std::string_view unit) {
  for (const double component : value) {
    if (range.contains(component)) continue;
    add(fmt::format("{} is {}{}{}, each number must be {}", quantity, vector_text(value),
                    unit.empty() ? "" : " ", unit, range_text(range, unit)));
    return false;
  }
  return true;
}

bool Findings::check(std::string_view quantity, const Quat& q) {
  const double norm = q.coeffs().stableNorm();
  if (std::abs(norm - 1) <= limits::quaternion_error) return true;
  add(fmt::format("{} has norm {}, must be 1 (off by at most {})", quantity, norm, limits::quaternion_error));
  return false;
}

bool Findings::check_name(std::string_view name) {
  const std::string error = name_error(name);
  return require(error.empty(), error);
}

std::string vector_text(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string name_error(std::string_view name) {
  if (name.empty()) return "the name is empty";
  if (name.size() > limits::name_length) {
    return fmt::format("the name has {} bytes, must be at most {}", name.size(), limits::name_length);
  }
  for (std::size_t i = 0; i < name.size();) {
    const int length = utf8_length(name.substr(i));
    const unsigned char first = static_cast<unsigned char>(name[i]);
    if (length == 0) return "the name is not UTF-8";
    if (first < 0x20 || first == 0x7F) return "the name has a control character";
    i += at(length);
  }
  return {};
}

bool is_color(std::string_view text) {
  if ((text.size() != 4 && text.size() != 7) || text[0] != '#') return false;
  return std::all_of(text.begin() + 1, text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  });
}

}  // namespace rigor
