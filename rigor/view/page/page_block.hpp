#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A compressed piece of the data of a page, with the numbers that tell whether it arrived intact.
struct PageBlock {
  std::string kind;        ///< "header", "frames", ...: letters only.
  std::size_t raw_size;    ///< Bytes before compression.
  std::string deflated;    ///< zlib format (RFC 1950).
  std::uint32_t checksum;  ///< CRC-32 (RFC 1952) of `deflated`.
};
PageBlock make_page_block(std::string kind, std::string_view bytes);

/// Packs what has been collected; on any thread, since it shares nothing that changes.
using PagePacking = std::function<PageBlock()>;

/// The block as an element of an HTML file that browsers neither run nor show. Attributes: data-run, data-
/// kind, data-raw and data-size [bytes before and after compression] and data-crc (8 hexadecimal digits).
/// Text: seven_bit_text.
std::string block_html(const PageBlock& block, int run);

/// Base64 of the bytes with padding. Source: Josefsson, The Base16, Base32, and Base64 Data Encodings, RFC
/// 4648, 2006, section 4.
std::string base64(std::string_view bytes);

/// The bytes as text in UTF-8 that HTML keeps as it is: each seven bits, the highest first, are one character
/// of ASCII. Of the three that HTML changes (NUL, CR, <) the k-th is not written: the character U+0080 + 128
/// k
/// + the next seven bits (0 at the end) stands for both. An eighth longer than the bytes, where base64 is a
/// third longer.
std::string seven_bit_text(std::string_view bytes);

// Little-endian numbers, appended to bytes.
void append_u32(std::uint32_t value, std::string& bytes);
void append_f32(float value, std::string& bytes);
void append_f64(double value, std::string& bytes);

/// An integer in groups of seven bits, the lowest first, each but the last with its high bit set (a varint);
/// the sign is folded in: 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
void append_varint(std::int64_t value, std::string& bytes);

/// How many values go into the prediction of the next one in a column: the last; a straight line through two;
/// a parabola through three. The first ones of a column have as many as there are.
enum class ColumnOrder { constant = 1, linear = 2, quadratic = 3 };
/// A column of integers as residuals of this prediction, each as a varint: of the linear one x_0, x_1 - x_0,
/// then x_k - (2 x_{k-1} - x_{k-2}). Smooth motion gives small numbers, rest gives zeros.
void append_column(std::span<const std::int64_t> values, std::string& bytes,
                   ColumnOrder order = ColumnOrder::linear);
/// The residuals of a column, passed to `take` one after the other.
template <typename Take>
void for_residuals(std::span<const std::int64_t> values, ColumnOrder order, Take take) {
  std::int64_t last = 0, before = 0, earlier = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::int64_t guess = last;
    if (k > 1 && order != ColumnOrder::constant) guess += last - before;
    if (k > 2 && order == ColumnOrder::quadratic) guess += last - 2 * before + earlier;
    take(values[k] - guess);
    earlier = before, before = last, last = values[k];
  }
}

/// A column of doubles without loss: the residuals of linear extrapolation of their bit patterns as integers
/// (as in append_column), with the sign folded in; the highest bytes of all of them come first, then the next
/// ones, and so on. Numbers that change slowly share their high bytes, which compress well.
void append_exact_column(std::span<const double> values, std::string& bytes);

/// The multiple of the step [same unit] that is nearest to the value, clamped to ±2⁵⁰ so that JavaScript's
/// numbers hold its differences exactly; 0 for what is not finite.
std::int64_t quantised(double value, double step);

/// The largest power of two that is at most the positive value, so that multiples of it are exact.
double power_of_two_below(double value);

}  // namespace rigor
