#include "rigor/io/mesh/ply_file.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/mesh/mesh_bytes.hpp"
#include "rigor/io/mesh/mesh_text.hpp"
#include "rigor/io/mesh/ply_header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

namespace rigor {

namespace {

/// The values after the header, in their order. Each fits exactly in a double.
class PlyValues {
 public:
  virtual ~PlyValues() = default;
  virtual void begin_row() = 0;
  virtual double next(PlyType type) = 0;
  virtual void end_row() = 0;
  virtual std::size_t bytes_left() const = 0;
  /// Smallest number of bytes that a value of the type takes.
  virtual std::size_t smallest(PlyType type) const = 0;
  /// Largest number of values of the type that the row can still have.
  virtual std::size_t values_left(PlyType type) const = 0;
  virtual bool is_at_end() = 0;
  [[noreturn]] virtual void fail(const std::string& what) const = 0;
};

/// Values in text, with one row per line.
class AsciiValues : public PlyValues {
 public:
  explicit AsciiValues(MeshText& text) : text_(text) {}
  void begin_row() override {
    if (!text_.next_line()) fail("the file is cut off: rows are missing");
    next_ = 0;
  }
  double next(PlyType type) override {
    if (next_ >= text_.words().size()) fail("the row is cut off: values are missing");
    const std::string_view word = text_.words()[next_++];
    if (is_real(type)) return text_.number(word);
    const double value = static_cast<double>(text_.whole_number(word));
    const auto [low, high] = range_of(type);
    if (value < low || value > high)
      fail(quoted_text(word) + fmt::format(" is out of range; allowed are {} to {}", low, high));
    return value;
  }
  void end_row() override {
    if (next_ < text_.words().size())
      fail(fmt::format("{} values too many in this row", text_.words().size() - next_));
  }
  std::size_t bytes_left() const override { return text_.bytes_left() + 1; }
  std::size_t smallest(PlyType) const override { return 2; }  // a digit, and a space or the end of the line
  std::size_t values_left(PlyType) const override { return text_.words().size() - next_; }
  bool is_at_end() override { return !text_.next_line(); }
  [[noreturn]] void fail(const std::string& what) const override { text_.fail(what); }

 private:
  MeshText& text_;
  std::size_t next_ = 0;
};

class BinaryValues : public PlyValues {
 public:
  explicit BinaryValues(MeshBytes& bytes) : bytes_(bytes) {}
  void begin_row() override {}
  double next(PlyType type) override {
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(bytes_.read(1));
      case PlyType::uint8:
        return static_cast<std::uint8_t>(bytes_.read(1));
      case PlyType::int16:
        return static_cast<std::int16_t>(bytes_.read(2));
      case PlyType::uint16:
        return static_cast<std::uint16_t>(bytes_.read(2));
      case PlyType::int32:
        return static_cast<std::int32_t>(bytes_.read(4));
      case PlyType::uint32:
        return bytes_.read(4);
      case PlyType::float32:
        return bytes_.read_float();
      case PlyType::float64:
        break;
    }
    return bytes_.read_double();
  }
  void end_row() override {}
  std::size_t bytes_left() const override { return bytes_.bytes_left(); }
  std::size_t smallest(PlyType type) const override { return size_of(type); }
  std::size_t values_left(PlyType type) const override { return bytes_.bytes_left() / size_of(type); }
  bool is_at_end() override { return bytes_.bytes_left() == 0; }
  [[noreturn]] void fail(const std::string& what) const override { bytes_.fail(what); }

 private:
  MeshBytes& bytes_;
};

/// Reads the elements into a mesh.
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, PlyValues& values) : header_(header), values_(values) {}

  PolygonMesh read() {
    for (const PlyElement& element : header_.elements) {
      check_size(element);
      if (element.name == "vertex") mesh_.vertices.reserve(element.count);
      for (std::size_t row = 0; row < element.count; ++row) read_row(element, row);
    }
    // Nothing may follow, and the faces must refer to vertices of the file.
    if (!values_.is_at_end()) values_.fail("the file continues after the last element");
    if (mesh_.faces.empty()) values_.fail("the file has no faces");
    check_indices();
    return std::move(mesh_);
  }

 private:
  /// Checks that the file is long enough for the rows before memory is reserved for them.
  void check_size(const PlyElement& element) const {
    std::size_t row = 0;
    for (const PlyProperty& p : element.properties)
      row += values_.smallest(p.is_list ? p.count_type : p.type);
    if (element.count > 0 && (row == 0 || element.count > values_.bytes_left() / row)) {
      values_.fail(fmt::format(
          "the header promises {} rows of '{}', of at least {} bytes each; only {} bytes are left",
          element.count, element.name, row, values_.bytes_left()));
    }
  }

  void read_row(const PlyElement& element, std::size_t row) {
    values_.begin_row();
    Vec3 p = Vec3::Zero();
    for (const PlyProperty& property : element.properties) {
      if (property.is_list) {
        read_list(property, element.name == "face" && property.is_vertex_list(), row);
        continue;
      }
      const double value = values_.next(property.type);
      if (element.name == "vertex" && property.axis() >= 0) p[property.axis()] = value;
    }
    values_.end_row();
    if (element.name != "vertex") return;
    if (!p.allFinite()) {
      values_.fail(
          fmt::format("vertex {} is ({}, {}, {}); coordinates must be finite", row, p.x(), p.y(), p.z()));
    }
    mesh_.vertices.push_back(p);
  }

  void read_list(const PlyProperty& property, bool is_face, std::size_t row) {
    // The length of the list must fit into the file, and a face needs three vertices.
    const double length = values_.next(property.count_type);
    if (length < 0 || length > static_cast<double>(values_.values_left(property.type))) {
      values_.fail(fmt::format("a list of {:.0f} values in row {}; only {} are left", length, row,
                               values_.values_left(property.type)));
    }
    if (is_face && length < 3)
      values_.fail(fmt::format("face {} has {} vertices; at least 3 are needed", row, length));
    // Values of lists other than faces are read and dropped.
    std::vector<int> loop;
    for (std::size_t i = 0; i < static_cast<std::size_t>(length); ++i) {
      const double value = values_.next(property.type);
      if (!is_face) continue;
      if (value < 0 || value > std::numeric_limits<int>::max()) {
        values_.fail(fmt::format("vertex index {} of face {} is out of range", value, row));
      }
      loop.push_back(static_cast<int>(value));
    }
    if (is_face) mesh_.faces.push_back(std::move(loop));
  }

  void check_indices() const {
    const std::size_t count = mesh_.vertices.size();
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      for (const int v : mesh_.faces[f]) {
        if (at(v) < count) continue;
        values_.fail(fmt::format(
            "vertex index {} of face {} is out of range; the file has {} vertices, counted from 0", v, f,
            count));
      }
    }
  }

  const PlyHeader& header_;
  PlyValues& values_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh parse_ply(std::string_view bytes, const std::string& name) {
  MeshText text(bytes, name, 0);
  const PlyHeader header = parse_ply_header(text);
  if (header.format == PlyFormat::ascii) {
    AsciiValues values(text);
    return PlyReader(header, values).read();
  }
  MeshBytes body(bytes, name, header.format == PlyFormat::binary_big_endian);
  body.skip(bytes.size() - text.bytes_left());
  BinaryValues values(body);
  return PlyReader(header, values).read();
}

}  // namespace rigor
