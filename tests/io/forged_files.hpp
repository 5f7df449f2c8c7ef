#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>

/// Checkpoints whose values are changed and whose checksums are right again. What it knows of the layout is
/// the end: length and bytes of the State, which ends with a checksum of its own, and the checksum of all.
namespace rigor::test {

inline std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

inline void put_word(std::uint64_t value, std::size_t place, std::string& bytes) {
  for (std::size_t i = 0; i < 8; ++i) bytes[place + i] = static_cast<char>(value >> (8 * i));
}

/// Makes both checksums right, of the State where it is found and of the whole.
inline void sign_checkpoint(std::string& bytes) {
  if (bytes.size() < 24) return;
  const std::size_t end = bytes.size() - 8;
  const std::size_t state = bytes.rfind("RIGORST\x1A");
  if (state != std::string::npos && end - state > 8)
    put_word(fnv1a(std::string_view(bytes).substr(state, end - 8 - state)), end - 8, bytes);
  put_word(fnv1a(std::string_view(bytes).substr(0, end)), end, bytes);
}

/// A number that is wrong at most places: no number, too large, negative, one off, or any bits.
inline std::uint64_t hostile_word(std::uint64_t old, std::mt19937_64& engine) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr std::array reals = {nan,    -nan,  infinite, -infinite, -9e16, 1e300,
                                -1e300, 1e160, 5e-324,   -1.0,      0.0};
  constexpr std::array<std::uint64_t, 7> integers = {0,          1,         1000, 0x7fffffff, 0xffffffffull,
                                                     1ull << 40, ~0ull >> 1};
  switch (engine() % 6) {
    case 0:
      return engine();
    case 1:
      return std::bit_cast<std::uint64_t>(reals[engine() % reals.size()]);
    case 2:
      return integers[engine() % integers.size()];
    case 3:
      return old ^ std::uint64_t{1} << (engine() % 64);
    case 4:
      return old + (engine() % 2 ? 1 : ~0ull);
    default:
      return ~integers[engine() % integers.size()];
  }
}

/// One to three words of the file after its magic number are replaced, and the checksums made right.
inline std::string forged_checkpoint(const std::string& bytes, std::mt19937_64& engine) {
  std::string forged = bytes;
  const std::size_t words = (bytes.size() - 16) / 8;
  for (std::uint64_t k = 1 + engine() % 3; k > 0; --k) {
    const std::size_t place = 8 + 8 * (engine() % words);
    std::uint64_t old = 0;
    for (std::size_t i = 0; i < 8; ++i)
      old |= std::uint64_t{static_cast<unsigned char>(forged[place + i])} << (8 * i);
    put_word(hostile_word(old, engine), place, forged);
  }
  sign_checkpoint(forged);
  return forged;
}

}  // namespace rigor::test
