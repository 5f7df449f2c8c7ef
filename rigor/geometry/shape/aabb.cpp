#include "rigor/geometry/shape/aabb.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <cmath>

namespace rigor {
namespace {

Aabb box_around(const Vec3& p, const Vec3& reach) {
  return {p - reach, p + reach};
}

/// Half sizes in W of a disk of radius 1 in the plane of the first two axes of S: √(R₀² + R₁²) of each row.
Vec3 disk_reach(const Mat3& R_WS) {
  return (R_WS.col(0).cwiseAbs2() + R_WS.col(1).cwiseAbs2()).cwiseSqrt();
}

Aabb box_of_points(const std::vector<Vec3>& points_S, const Pose& X_WS) {
  Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const Vec3& p_S : points_S) {
    const Vec3 p_W = X_WS * p_S;
    box = box.united({p_W, p_W});
  }
  return box;
}

struct BoxInWorld {
  const Pose& X_WS;

  Aabb operator()(const Sphere& s) const { return box_around(X_WS.p, Vec3::Constant(s.radius)); }
  Aabb operator()(const Box& s) const { return box_around(X_WS.p, X_WS.R.cwiseAbs() * s.half_extents); }
  Aabb operator()(const Capsule& s) const {
    return box_around(X_WS.p, s.half_length * X_WS.R.col(2).cwiseAbs() + Vec3::Constant(s.radius));
  }
  Aabb operator()(const Cylinder& s) const {
    return box_around(X_WS.p, s.half_length * X_WS.R.col(2).cwiseAbs() + s.radius * disk_reach(X_WS.R));
  }
  Aabb operator()(const Cone& s) const {
    const Vec3 to_apex = s.half_length * X_WS.R.col(2);
    const Vec3 p_apex = X_WS.p + to_apex;
    return box_around(X_WS.p - to_apex, s.radius * disk_reach(X_WS.R)).united({p_apex, p_apex});
  }
  Aabb operator()(const Ellipsoid& s) const {
    const Mat3 axes_W = X_WS.R * s.radii.asDiagonal();
    return box_around(X_WS.p, axes_W.rowwise().norm());
  }
  Aabb operator()(const HalfSpace& s) const {
    const Vec3 n_W = X_WS.R * s.normal;
    const double offset_W = s.offset + n_W.dot(X_WS.p);
    Aabb box = box_around(Vec3::Zero(), Vec3::Constant(kInfinity));
    for (int i = 0; i < 3; ++i) {
      if (n_W((i + 1) % 3) != 0 || n_W((i + 2) % 3) != 0) continue;
      if (n_W(i) > 0) box.upper(i) = offset_W;
      if (n_W(i) < 0) box.lower(i) = -offset_W;
    }
    return box;
  }
  Aabb operator()(const Cavity&) const { return box_around(Vec3::Zero(), Vec3::Constant(kInfinity)); }
  Aabb operator()(const Convex& s) const { return box_of_points(s.hull->vertices, X_WS); }
  Aabb operator()(const Mesh& s) const { return box_of_points(s.mesh->vertices, X_WS); }
  template <class Own>
  Aabb operator()(const Own& s) const {
    return s.box(X_WS);
  }
};

}  // namespace

Aabb axis_aligned_box(const Shape& shape, const Pose& X_WS) {
  return std::visit(BoxInWorld{X_WS}, shape);
}

}  // namespace rigor
