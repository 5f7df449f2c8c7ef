#include "rigor/core/quoted.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rigor {

namespace {

constexpr std::size_t longest_quoted = 60;

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

std::string escaped_byte(std::uint32_t byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  return {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
}

/// The code point of a text that is one character in UTF-8.
std::uint32_t code_point(std::string_view character) {
  if (character.size() == 1) return byte_at(character, 0);
  std::uint32_t code = byte_at(character, 0) & (0x7Fu >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (byte_at(character, i) & 0x3F);
  return code;
}

/// What drives a terminal or changes how its neighbours look: C0 and C1 control characters and DEL, marks of
/// the direction of writing, separators of lines and paragraphs.
bool is_deceptive(std::uint32_t code) {
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool is_direction = code == 0x061C || code == 0x200E || code == 0x200F ||
                            (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return is_control || is_direction || code == 0x2028 || code == 0x2029;
}

}  // namespace

int utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const std::uint32_t first = byte_at(text, 0);
  if (first < 0x80) return 1;
  const int length = (first & 0xE0) == 0xC0 ? 2 : (first & 0xF0) == 0xE0 ? 3 : (first & 0xF8) == 0xF0 ? 4 : 0;
  if (length == 0 || text.size() < at(length)) return 0;

  std::uint32_t code = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < at(length); ++i) {
    if ((byte_at(text, i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte_at(text, i) & 0x3F);
  }
  constexpr std::array<std::uint32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < smallest[at(length)] || is_surrogate || code > 0x10FFFF) return 0;
  return length;
}

std::string escaped_text(std::string_view text) {
  // Nearly all texts are plain: names are quoted wherever a message might be about them.
  const bool is_plain = std::ranges::all_of(text, [](char c) { return c >= 0x20 && c < 0x7F; });
  if (is_plain) return std::string(text);
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = at(utf8_length(text.substr(i)));
    const std::size_t taken = length == 0 ? 1 : length;
    if (length == 0 || is_deceptive(code_point(text.substr(i, length)))) {
      for (std::size_t k = 0; k < taken; ++k) result += escaped_byte(byte_at(text, i + k));
    } else {
      result += text.substr(i, length);
    }
    i += taken;
  }
  return result;
}

std::string quoted_text(std::string_view text) {
  // The cut comes before a character that begins beyond the limit.
  std::size_t end = text.size() <= longest_quoted ? text.size() : 0;
  while (end < text.size() && end < longest_quoted) end += at(std::max(1, utf8_length(text.substr(end))));
  const char* const rest = end < text.size() ? "...'" : "'";
  return "'" + escaped_text(text.substr(0, end)) + rest;
}

}  // namespace rigor
