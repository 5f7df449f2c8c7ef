#include "rigor/bulk/passing/shape_thickness.hpp"

#include "rigor/geometry/shape/aabb.hpp"

#include <limits>
#include <variant>

namespace rigor {

double shape_thickness(const Shape& shape) {
  if (is_unbounded(shape)) return std::numeric_limits<double>::infinity();
  const Aabb box = axis_aligned_box(shape, Pose{Mat3::Identity(), Vec3::Zero()});
  const double half_width = 0.5 * (box.upper - box.lower).minCoeff();
  // Boxes, balls, capsules, cylinders and ellipsoids are as thick as their boxes; others may be pointed.
  constexpr double pointed_share = 0.25;
  const bool is_full = std::holds_alternative<Sphere>(shape) || std::holds_alternative<Box>(shape) ||
                       std::holds_alternative<Capsule>(shape) || std::holds_alternative<Cylinder>(shape) ||
                       std::holds_alternative<Ellipsoid>(shape);
  return is_full ? half_width : pointed_share * half_width;
}

}  // namespace rigor
