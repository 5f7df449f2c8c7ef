#include "rigor/io/mesh/mesh_bytes.hpp"

#include "rigor/core/input_error.hpp"

#include <bit>

#include <fmt/format.h>

namespace rigor {

MeshBytes::MeshBytes(std::string_view bytes, std::string name, bool is_big_endian)
    : bytes_(bytes), name_(std::move(name)), is_big_endian_(is_big_endian) {}

void MeshBytes::skip(std::size_t count) {
  if (count > bytes_left())
    fail(fmt::format("the file is cut off: {} bytes are missing", count - bytes_left()));
  position_ += count;
}

std::uint64_t MeshBytes::read_bits(std::size_t bytes) {
  const std::size_t start = position_;
  skip(bytes);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t from_high = is_big_endian_ ? i : bytes - 1 - i;
    bits = (bits << 8) | static_cast<unsigned char>(bytes_[start + from_high]);
  }
  return bits;
}

std::uint32_t MeshBytes::read(std::size_t bytes) {
  return static_cast<std::uint32_t>(read_bits(bytes));
}

float MeshBytes::read_float() {
  return std::bit_cast<float>(read(4));
}

double MeshBytes::read_double() {
  return std::bit_cast<double>(read_bits(8));
}

void MeshBytes::fail(const std::string& what) const {
  throw InputError(fmt::format("{}: byte {}: {}", name_, position_, what));
}

}  // namespace rigor
