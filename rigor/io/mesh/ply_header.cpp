#include "rigor/io/mesh/ply_header.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace rigor {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

PlyType read_type(const MeshText& text, std::string_view word) {
  for (const TypeName& known : kTypeNames) {
    if (known.name == word) return known.type;
  }
  text.fail(quoted_text(word) +
            " is not a type; allowed are char, uchar, short, ushort, int, uint, float, double");
}

PlyFormat read_format(MeshText& text) {
  const std::vector<std::string_view>& words = text.words();
  if (words.size() == 3 && words[0] == "format" && words[2] == "1.0") {
    if (words[1] == "ascii") return PlyFormat::ascii;
    if (words[1] == "binary_little_endian") return PlyFormat::binary_little_endian;
    if (words[1] == "binary_big_endian") return PlyFormat::binary_big_endian;
  }
  text.fail("the second line must be 'format ascii|binary_little_endian|binary_big_endian 1.0'");
}

PlyElement read_element(MeshText& text) {
  const std::vector<std::string_view>& words = text.words();
  if (words.size() != 3) text.fail("an element is written 'element name count'");
  const std::int64_t count = text.whole_number(words[2]);
  if (count < 0 || count > std::numeric_limits<int>::max()) {
    text.fail("element count " + quoted_text(words[2]) + " is out of range; allowed are 0 to 2147483647");
  }
  return {std::string(words[1]), at(count), {}};
}

PlyProperty read_property(MeshText& text) {
  const std::vector<std::string_view>& words = text.words();
  if (words.size() == 3) return {std::string(words[2]), read_type(text, words[1])};
  if (words.size() != 5 || words[1] != "list") {
    text.fail("a property is written 'property type name' or 'property list type type name'");
  }
  PlyProperty property{std::string(words[4]), read_type(text, words[3]), true, read_type(text, words[2])};
  if (is_real(property.count_type)) text.fail("the length of a list must have a whole-number type");
  return property;
}

const PlyElement& element_named(const MeshText& text, const PlyHeader& header, const std::string& name) {
  const auto is_named = [&name](const PlyElement& element) { return element.name == name; };
  const auto count = std::count_if(header.elements.begin(), header.elements.end(), is_named);
  if (count != 1) text.fail("the header must have one element '" + name + "'");
  return *std::find_if(header.elements.begin(), header.elements.end(), is_named);
}

void check_header(const MeshText& text, const PlyHeader& header) {
  std::array<int, 3> axes{};
  for (const PlyProperty& property : element_named(text, header, "vertex").properties) {
    if (!property.is_list && property.axis() >= 0) ++axes[at(property.axis())];
  }
  if (axes != std::array<int, 3>{1, 1, 1})
    text.fail("element 'vertex' must have one property x, one y and one z");

  int lists = 0;
  for (const PlyProperty& property : element_named(text, header, "face").properties) {
    if (!property.is_vertex_list()) continue;
    ++lists;
    if (is_real(property.type)) text.fail("the indices of a face's vertices must have a whole-number type");
  }
  if (lists != 1) text.fail("element 'face' must have one list vertex_indices (or vertex_index)");
}

}  // namespace

bool is_real(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[at(type)];
}

std::pair<double, double> range_of(PlyType type) {
  const double bits = 8.0 * static_cast<double>(size_of(type));
  const bool is_signed = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  const double half = std::exp2(bits - 1);
  return is_signed ? std::pair{-half, half - 1} : std::pair{0.0, 2 * half - 1};
}

PlyHeader parse_ply_header(MeshText& text) {
  if (!text.next_line() || text.words().size() != 1 || text.words()[0] != "ply")
    text.fail("a PLY file starts with the line 'ply'");
  if (!text.next_line()) text.fail("the file is cut off in its header");
  PlyHeader header{read_format(text), {}};
  while (true) {
    if (!text.next_line()) text.fail("the file is cut off in its header: 'end_header' is missing");
    const std::string_view keyword = text.words()[0];
    if (keyword == "end_header") break;
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "element") {
      header.elements.push_back(read_element(text));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(text));
    } else {
      text.fail(quoted_text(keyword) +
                " is not allowed here; allowed are element, property, comment, obj_info and end_header");
    }
  }
  check_header(text, header);
  return header;
}

}  // namespace rigor
