#include "rigor/geometry/distance/thickness.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <variant>

namespace rigor {

namespace {

/// The part of its half width that counts: less than 1 where a shape may be hollow or pointed.
struct ThickShare {
  double operator()(const Sphere&) const { return 1; }
  double operator()(const Box&) const { return 1; }
  double operator()(const Capsule&) const { return 1; }
  double operator()(const Cylinder&) const { return 1; }
  double operator()(const Cone&) const { return 0.25; }
  double operator()(const Ellipsoid&) const { return 1; }
  double operator()(const HalfSpace&) const { return 1; }
  double operator()(const Cavity&) const { return 1; }
  double operator()(const Convex&) const { return 0.25; }
  double operator()(const Mesh&) const { return 0.02; }
  template <class Own>
  double operator()(const Own&) const {
    return Own::thick_share;
  }
};

}  // namespace

double smallest_width(const Shape& shape) {
  if (is_unbounded(shape)) return kInfinity;
  const Aabb box = axis_aligned_box(shape, Pose{Mat3::Identity(), Vec3::Zero()});
  return (box.upper - box.lower).minCoeff();
}

double thickness_of(const Shape& shape) {
  return 0.5 * std::visit(ThickShare{}, convex_solid(shape)) * smallest_width(shape);
}

}  // namespace rigor
