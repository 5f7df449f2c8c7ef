#include "rigor/model/body_shapes.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <type_traits>
#include <variant>

namespace rigor {

namespace {

bool are_equal(const Sphere& a, const Sphere& b) {
  return a.radius == b.radius;
}
bool are_equal(const Box& a, const Box& b) {
  return a.half_extents == b.half_extents;
}
bool are_equal(const Capsule& a, const Capsule& b) {
  return a.radius == b.radius && a.half_length == b.half_length;
}
bool are_equal(const Cylinder& a, const Cylinder& b) {
  return a.radius == b.radius && a.half_length == b.half_length;
}
bool are_equal(const Cone& a, const Cone& b) {
  return a.radius == b.radius && a.half_length == b.half_length;
}
bool are_equal(const Ellipsoid& a, const Ellipsoid& b) {
  return a.radii == b.radii;
}
bool are_equal(const HalfSpace& a, const HalfSpace& b) {
  return a.normal == b.normal && a.offset == b.offset;
}
bool are_equal(const Convex& a, const Convex& b) {
  return a.hull == b.hull;
}
bool are_equal(const Mesh& a, const Mesh& b) {
  return a.mesh == b.mesh && a.tree == b.tree && a.solid == b.solid;
}
bool are_equal(const Cavity& a, const Cavity& b) {
  return a.radius == b.radius;
}

bool are_same(const BodyShape& a, const BodyShape& b) {
  const bool has_same_form =
      a.shape.index() == b.shape.index() &&
      std::visit(
          [&](const auto& form) {
            return are_equal(form, std::get<std::remove_cvref_t<decltype(form)>>(b.shape));
          },
          a.shape);
  // Poses are compared bit by bit, so that they keep the signs of their zeros.
  return has_same_form && std::memcmp(&a.X_BS, &b.X_BS, sizeof(Pose)) == 0 && a.material == b.material &&
         a.radius == b.radius && a.color == b.color;
}

/// Equal for equal shapes.
std::size_t hash_of(const BodyShape& shape) {
  const Convex* const convex = std::get_if<Convex>(&shape.shape);
  const Mesh* const mesh = std::get_if<Mesh>(&shape.shape);
  const void* const form = convex ? static_cast<const void*>(convex->hull.get())
                           : mesh ? mesh->mesh.get()
                                  : nullptr;
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
