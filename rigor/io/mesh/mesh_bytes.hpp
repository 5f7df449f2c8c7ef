#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

/// The bytes of a binary mesh file, read from front to back. Every error message names the file and the byte.
class MeshBytes {
 public:
  MeshBytes(std::string_view bytes, std::string name, bool is_big_endian);

  void skip(std::size_t count);
  /// The next unsigned integer of 1, 2 or 4 bytes.
  std::uint32_t read(std::size_t bytes);
  float read_float();
  double read_double();

  std::size_t bytes_left() const { return bytes_.size() - position_; }
  std::size_t position() const { return position_; }

  /// Throws InputError; the message begins with the file and the current byte (counted from 0).
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::uint64_t read_bits(std::size_t bytes);

  std::string_view bytes_;
  std::string name_;
  bool is_big_endian_;
  std::size_t position_ = 0;
};

}  // namespace rigor
