#include "rigor/view/page/page_block.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

namespace rigor {

namespace {

template <typename Unsigned>
void append_little_endian(Unsigned bits, std::string& bytes) {
  for (std::size_t i = 0; i < sizeof bits; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xff);
}

const Bytef* bytes_of(std::string_view text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

/// How zlib packs.
struct Packing {
  int level, strategy;
};

/// Small blocks are worth the effort: it takes some milliseconds. Columns of residuals hardly ever repeat but
/// for runs of one byte: looking for those alone takes a seventh of the time and costs a twentieth of the
/// size.
Packing packing_of(std::string_view kind, std::size_t size) {
  constexpr std::size_t small = 1 << 18;
  if (size <= small) return {Z_BEST_COMPRESSION, Z_DEFAULT_STRATEGY};
  const bool has_columns = kind == "frames" || kind == "contacts";
  return {Z_DEFAULT_COMPRESSION, has_columns ? Z_RLE : Z_DEFAULT_STRATEGY};
}

/// The bytes as zlib packs them, piece by piece: a large mesh takes seconds.
std::string deflated(std::string_view bytes, const Packing& packing) {
  constexpr int window_bits = 15, memory_level = 8;  // As deflateInit has them.
  constexpr std::size_t piece = std::size_t{1} << 20;
  z_stream stream{};
  RIGOR_ASSERT(
      deflateInit2(&stream, packing.level, Z_DEFLATED, window_bits, memory_level, packing.strategy) == Z_OK);
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
  std::string packed(compressBound(static_cast<uLong>(bytes.size())), '\0');
  std::size_t size = 0;
  int result = Z_OK;
  for (std::size_t begin = 0; result == Z_OK; begin += piece) {
    poll_interrupt();
    const std::string_view part = bytes.substr(std::min(begin, bytes.size()), piece);
    stream.next_in = const_cast<Bytef*>(bytes_of(part));
    stream.avail_in = static_cast<uInt>(part.size());
    // The room is what zlib asks for; it counts in 32 bits, so that no more than a piece of it is offered.
    do {
      const std::size_t room = std::min(packed.size() - size, 2 * piece);
      stream.next_out = reinterpret_cast<Bytef*>(packed.data() + size);
      stream.avail_out = static_cast<uInt>(room);
      result = deflate(&stream, begin + piece >= bytes.size() ? Z_FINISH : Z_NO_FLUSH);
      size += room - stream.avail_out;
    } while (result == Z_OK && stream.avail_out == 0);
  }
  RIGOR_ASSERT(result == Z_STREAM_END);
  packed.resize(size);
  return packed;
}

}  // namespace

PageBlock make_page_block(std::string kind, std::string_view bytes) {
  std::string packed = deflated(bytes, packing_of(kind, bytes.size()));
  const uLong checksum = crc32_z(0, bytes_of(packed), packed.size());
  return {std::move(kind), bytes.size(), std::move(packed), static_cast<std::uint32_t>(checksum)};
}

std::string block_html(const PageBlock& block, int run) {
  return fmt::format(
      "<script type=\"text/plain\" class=\"rigor-data\" data-run=\"{}\" data-kind=\"{}\" data-raw=\"{}\" "
      "data-size=\"{}\" data-crc=\"{:08x}\">{}</script>\n",
      run, block.kind, block.raw_size, block.deflated.size(), block.checksum, seven_bit_text(block.deflated));
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string seven_bit_text(std::string_view bytes) {
  constexpr std::array<unsigned, 3> left_out = {0, '\r', '<'};
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 6 + 4);
  unsigned bits = 0, first = 0;
  int count = 0;
  bool has_first = false;  // Of a pair of groups that one character stands for.
  const auto add = [&](unsigned group) {
    if (has_first) {
      // Two bytes of UTF-8.
      const unsigned code = 128 + 128 * first + group;
      text += static_cast<char>(0xc0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 63));
      has_first = false;
      return;
    }
    for (unsigned k = 0; k < left_out.size(); ++k) {
      if (group == left_out[k]) first = k, has_first = true;
    }
    if (!has_first) text += static_cast<char>(group);
  };
  for (const char byte : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(byte);
    for (count += 8; count >= 7; count -= 7) add(bits >> (count - 7) & 127);
  }
  if (count > 0) add(bits << (7 - count) & 127);
  if (has_first) add(0);
  return text;
}

void append_u32(std::uint32_t value, std::string& bytes) {
  append_little_endian(value, bytes);
}
void append_f32(float value, std::string& bytes) {
  append_little_endian(std::bit_cast<std::uint32_t>(value), bytes);
}
void append_f64(double value, std::string& bytes) {
  append_little_endian(std::bit_cast<std::uint64_t>(value), bytes);
}

void append_varint(std::int64_t value, std::string& bytes) {
  // Zigzag: the sign moves to the lowest bit, so that small numbers of either sign take few bytes.
  std::uint64_t folded = static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
  for (; folded >= 128; folded >>= 7) bytes += static_cast<char>((folded & 127) | 128);
  bytes += static_cast<char>(folded);
}

void append_column(std::span<const std::int64_t> values, std::string& bytes, ColumnOrder order) {
  for_residuals(values, order, [&](std::int64_t residual) { append_varint(residual, bytes); });
}

void append_exact_column(std::span<const double> values, std::string& bytes) {
  // Linear prediction of the bit patterns as integers, with zigzag folding of the residuals.
  std::vector<std::uint64_t> folded;
  std::uint64_t last = 0, before = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(values[k]);
    // Unsigned arithmetic wraps around here and, in the reader, back again.
    const std::uint64_t step = bits - (k < 2 ? last : 2 * last - before);
    folded.push_back(step << 1 ^ (step >> 63 ? ~std::uint64_t{0} : 0));
    before = last;
    last = bits;
  }
  // Byte planes, the highest bytes first, which are mostly zero and compress well.
  for (int shift = 56; shift >= 0; shift -= 8) {
    for (const std::uint64_t value : folded) bytes += static_cast<char>(value >> shift & 0xff);
  }
}

std::int64_t quantised(double value, double step) {
  constexpr double most = 1125899906842624.0;  // 2⁵⁰
  const double multiple = value / step;
  return std::isfinite(multiple) ? std::llround(std::clamp(multiple, -most, most)) : 0;
}

double power_of_two_below(double value) {
  RIGOR_ASSERT(value >= std::numeric_limits<double>::min() && std::isfinite(value));
  return std::exp2(std::floor(std::log2(value)));
}

}  // namespace rigor
