#pragma once

#include "rigor/math/types.hpp"

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace rigor {

struct Aabb;        // rigor/geometry/shape/aabb.hpp
struct ConvexCore;  // rigor/geometry/shape/convex_core.hpp
struct Pose;        // rigor/math/pose.hpp
struct ShapeData;   // rigor/geometry/shape/shape_data.hpp

/// A circle about the z axis.
struct Ring {
  double radius;  ///< ≥ 0; 0 is a point of the axis [m].
  double z;       ///< [m].
};

/// Convex solid of revolution about z: the hull of its rings. Between two neighbouring rings it is a frustum
/// of a cone; a first or last ring of positive radius bounds a flat cap. Made by make_revolution.
///
/// The members are the answers that a shape in a file of its own gives to the visitors of this layer and of
/// those above it (docs/extending.md); each is named after the public function that asks.
struct Revolution {
  std::shared_ptr<const std::vector<Ring>> rings;  ///< At least two, z ascending, strictly convex.

  static constexpr const char* type_name = "revolution";
  static constexpr bool is_unbounded = false;
  static constexpr bool has_corner_balls = false;
  /// A rim may be as sharp as that of a cone: the time-stepping schemes let it move this part of its half
  /// width.
  static constexpr double thick_share = 0.25;

  ConvexCore core() const;
  ShapeData data() const;
  Aabb box(const Pose& X_WS) const;
  bool contains(const Vec3& p_S) const;
  Vec3 farthest_point(const Vec3& c_S) const;
};

/// The solid of the profile's points (radius, z) [m], in any order, or in words why there is none: fewer than
/// two points, a number that is not finite, a negative radius, no volume, or a point that lies inside the
/// hull of the others' circles (a dent) by more than a millionth of the size. Shallower dents are filled:
/// written numbers are rounded.
std::variant<Revolution, std::string> make_revolution(const std::vector<Vec2>& profile);

}  // namespace rigor
