#include "rigor/model/body_shapes.hpp"

#include "rigor/geometry/shape/shape_data.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <variant>

namespace rigor {

namespace {

/// Whether the shapes are the same one: shared data are not compared number by number.
bool are_equal(const Shape& a, const Shape& b) {
  if (a.index() != b.index()) return false;
  if (const Mesh* const mesh = std::get_if<Mesh>(&a)) {
    const Mesh& other = std::get<Mesh>(b);
    return mesh->mesh == other.mesh && mesh->tree == other.tree && mesh->solid == other.solid;
  }
  const ShapeData of_a = shape_data(a), of_b = shape_data(b);
  return of_a.shared == of_b.shared && std::ranges::equal(of_a.numbers(), of_b.numbers());
}

bool are_same(const BodyShape& a, const BodyShape& b) {
  // Poses are compared bit by bit, so that they keep the signs of their zeros.
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  return are_equal(a.shape, b.shape) && std::memcmp(&a.X_BS, &b.X_BS, sizeof(Pose)) == 0 &&
         a.material == b.material && a.radius == b.radius && a.color == b.color;
}

/// Equal for equal shapes.
std::size_t hash_of(const BodyShape& shape) {
  const void* const form = shape_data(shape.shape).shared;
  std::size_t hash = shape.shape.index();
  for (const std::size_t part : {std::hash<double>()(shape.radius), std::hash<const void*>()(form),
                                 std::hash<double>()(shape.X_BS.p.x()),
                                 std::hash<double>()(shape.X_BS.R(0, 1)), std::hash<int>()(shape.material)})
    hash = hash * 31 + part;
  return hash;
}

}  // namespace

const std::vector<BodyShape>& BodyShapes::all() const {
  static const std::vector<BodyShape> none;
  return shapes_ ? *shapes_ : none;
}

void SharedShapes::share(BodyShapes& shapes) {
  if (shapes.empty()) return;
  std::size_t hash = shapes.size();
  for (const BodyShape& shape : shapes) hash = hash * 31 + hash_of(shape);
  const auto [begin, end] = known_.equal_range(hash);
  const auto known = std::find_if(begin, end, [&](const auto& entry) {
    return std::equal(shapes.begin(), shapes.end(), entry.second.begin(), entry.second.end(), are_same);
  });
  if (known != end) {
    shapes = known->second;
  } else {
    known_.emplace(hash, shapes);
  }
}

}  // namespace rigor
