#pragma once

#include "rigor/view/page/page_block.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/// Reads back what pages hold, in the way docs/page.md says.
namespace rigor::test {

std::string inflated(const std::string& deflated, std::size_t raw_size);
std::string inflated(const PageBlock& block);

std::string decoded_seven_bit_text(const std::string& text, std::size_t size);

/// Numbers one after the other.
class BytesReader {
 public:
  explicit BytesReader(std::string bytes) : bytes_(std::move(bytes)) {}
  template <typename T>
  T take() {
    T value;
    std::memcpy(&value, bytes_.substr(at_, sizeof value).c_str(), sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::int64_t varint() {
    std::uint64_t folded = 0;
    for (int shift = 0;; shift += 7) {
      const unsigned char byte = static_cast<unsigned char>(bytes_.at(at_++));
      folded |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
    }
    return static_cast<std::int64_t>(folded >> 1) ^ -static_cast<std::int64_t>(folded & 1);
  }
  std::vector<std::int64_t> column(std::size_t count, int order = 2) {
    std::vector<std::int64_t> values;
    for (std::size_t k = 0; k < count; ++k) {
      // Of x_{k-1}, x_{k-2}, x_{k-3}: 1; 2, -1; 3, -3, 1.
      const int known = std::min(order, static_cast<int>(k));
      std::int64_t expected = 0, weight = known;
      for (int i = 1; i <= known; ++i) {
        expected += weight * values[k - static_cast<std::size_t>(i)];
        weight = -weight * (known - i) / (i + 1);
      }
      values.push_back(varint() + expected);
    }
    return values;
  }
  std::vector<double> exact_column(std::size_t count) {
    std::vector<std::uint64_t> bits(count);
    for (int plane = 0; plane < 8; ++plane) {
      for (std::uint64_t& value : bits) value = value << 8 | take<unsigned char>();
    }
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint64_t straight = k == 0 ? 0 : k == 1 ? bits[0] : 2 * bits[k - 1] - bits[k - 2];
      bits[k] = straight + (bits[k] >> 1 ^ (bits[k] & 1 ? ~std::uint64_t{0} : 0));
      std::memcpy(&values[k], &bits[k], sizeof values[k]);
    }
    return values;
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

/// A block as it stands in a page.
struct ReadBlock {
  int run;
  std::string kind;
  std::string bytes;  ///< Inflated.
  bool is_sound;      ///< Size and checksum are those that the page says.
};

std::vector<ReadBlock> blocks_of_page(const std::string& html);

}  // namespace rigor::test
