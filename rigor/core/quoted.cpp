#include "rigor/core/quoted.hpp"

#include "rigor/core/index.hpp"

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

std::string quoted_text(std::string_view text) {
  std::string result = "'";
  std::size_t i = 0;
  while (i < text.size()) {
    if (i >= longest_quoted) return result + "...'";
    const std::size_t length = at(utf8_length(text.substr(i)));
    // C0 and C1 control characters and DEL control terminals.
    const std::uint32_t first = byte_at(text, i);
    const bool is_control =
        first < 0x20 || first == 0x7F || (first == 0xC2 && length == 2 && byte_at(text, i + 1) < 0xA0);
    if (length == 0 || is_control) {
      for (std::size_t k = 0; k < (length == 0 ? 1 : length); ++k)
        result += escaped_byte(byte_at(text, i + k));
      i += length == 0 ? 1 : length;
      continue;
    }
    result += text.substr(i, length);
    i += length;
  }
  return result + "'";
}

}  // namespace rigor
