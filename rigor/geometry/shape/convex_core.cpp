#include "rigor/geometry/shape/convex_core.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

struct MakeCore {
  ConvexCore operator()(const Sphere& s) const {
    return {.kind = ConvexCore::Kind::point, .radius = s.radius};
  }
  ConvexCore operator()(const Box& s) const {
    return {.kind = ConvexCore::Kind::box, .size = s.half_extents, .extent = s.half_extents.norm()};
  }
  ConvexCore operator()(const Capsule& s) const {
    if (s.half_length == 0) return {.kind = ConvexCore::Kind::point, .radius = s.radius};
    return {.kind = ConvexCore::Kind::segment,
            .radius = s.radius,
            .size = Vec3(0, 0, s.half_length),
            .extent = s.half_length};
  }
  ConvexCore operator()(const Cylinder& s) const {
    const Vec3 size(s.radius, s.radius, s.half_length);
    return {.kind = ConvexCore::Kind::rings, .size = size, .extent = size.tail<2>().norm()};
  }
  ConvexCore operator()(const Cone& s) const {
    const double extent = Vec2(s.radius, s.half_length).norm();
    return {.kind = ConvexCore::Kind::rings, .size = Vec3(s.radius, 0, s.half_length), .extent = extent};
  }
  ConvexCore operator()(const Ellipsoid& s) const {
    return {.kind = ConvexCore::Kind::ellipsoid, .size = s.radii, .extent = s.radii.maxCoeff()};
  }
  ConvexCore operator()(const Convex& s) const {
    return {.kind = ConvexCore::Kind::points,
            .points = s.hull->vertices,
            .hull = s.hull.get(),
            .extent = s.hull->support_table.extent};
  }
  ConvexCore operator()(const HalfSpace&) const { return {}; }
  ConvexCore operator()(const Cavity&) const { return {}; }
  ConvexCore operator()(const Mesh&) const { return {}; }
  template <class Own>
  ConvexCore operator()(const Own& s) const {
    return s.core();
  }
};

int farthest_by_scan(std::span<const Vec3> points, const Vec3& d) {
  int best = 0;
  double best_height = d.dot(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double height = d.dot(points[i]);
    if (height > best_height) {
      best_height = height;
      best = static_cast<int>(i);
    }
  }
  return best;
}

Vec3 ring_point(const Ring& ring, const Vec3& d) {
  if (ring.radius == 0) return {0, 0, ring.z};
  const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
  if (length == 0) return {ring.radius, 0, ring.z};
  const double scale = ring.radius / length;
  return {scale * d.x(), scale * d.y(), ring.z};
}

Vec3 ellipsoid_point(const Vec3& radii, const Vec3& d) {
  // The ellipsoid is the unit ball stretched by D = diag(radii): its farthest point along d is D² d / |D d|.
  const Vec3 stretched = radii.cwiseProduct(d);
  return radii.cwiseProduct(stretched) / stretched.norm();
}

Vec3 box_corner(const Vec3& half_extents, int signs) {
  return {(signs & 1) ? half_extents.x() : -half_extents.x(),
          (signs & 2) ? half_extents.y() : -half_extents.y(),
          (signs & 4) ? half_extents.z() : -half_extents.z()};
}

/// Whether of two rings the upper one reaches at least as far along d: it rises by its height and falls back
/// by what its radius is smaller.
bool upper_ring_is_farther(const Ring& lower, const Ring& upper, const Vec3& d) {
  const double narrowing = lower.radius - upper.radius;
  if (narrowing == 0) return d.z() >= 0;
  return (upper.z - lower.z) * d.z() >= narrowing * std::sqrt(d.x() * d.x() + d.y() * d.y());
}

/// Along a convex profile the rings first come nearer to the farthest and then leave it: bisection.
int farthest_ring(const ConvexCore& core, const Vec3& d) {
  int lower = 0, upper = ring_count(core) - 1;
  while (lower < upper) {
    const int middle = (lower + upper) / 2;
    if (upper_ring_is_farther(ring_of(core, middle), ring_of(core, middle + 1), d)) {
      lower = middle + 1;
    } else {
      upper = middle;
    }
  }
  return lower;
}

}  // namespace

ConvexCore make_core(const Shape& shape) {
  RIGOR_ASSERT(!is_unbounded(shape) && !std::holds_alternative<Mesh>(shape));
  return std::visit(MakeCore{}, shape);
}

ConvexCore make_points_core(std::span<const Vec3> points) {
  RIGOR_ASSERT(!points.empty());
  double squared = 0;
  for (const Vec3& p : points) squared = std::max(squared, p.squaredNorm());
  return {.kind = ConvexCore::Kind::points, .points = points, .extent = std::sqrt(squared)};
}

CorePoint core_support(const ConvexCore& core, const Vec3& d, int start) {
  int piece = 0;
  switch (core.kind) {
    case ConvexCore::Kind::box:
      piece = (d.x() >= 0 ? 1 : 0) | (d.y() >= 0 ? 2 : 0) | (d.z() >= 0 ? 4 : 0);
      return {box_corner(core.size, piece), piece};
    case ConvexCore::Kind::points:
      piece =
          core.hull ? farthest_vertex(core.hull->support_table, d, start) : farthest_by_scan(core.points, d);
      return {core.points[at(piece)], piece};
    case ConvexCore::Kind::point:
    case ConvexCore::Kind::ellipsoid:
      break;
    case ConvexCore::Kind::segment:
      piece = d.z() >= 0 ? 1 : 0;
      break;
    case ConvexCore::Kind::rings:
      piece = farthest_ring(core, d);
      break;
  }
  return {piece_point(core, piece, d), piece};
}

Vec3 piece_point(const ConvexCore& core, int piece, const Vec3& d) {
  switch (core.kind) {
    case ConvexCore::Kind::point:
      return Vec3::Zero();
    case ConvexCore::Kind::segment:
      return {0, 0, piece ? core.size.z() : -core.size.z()};
    case ConvexCore::Kind::points:
      return core.points[at(piece)];
    case ConvexCore::Kind::box:
      return box_corner(core.size, piece);
    case ConvexCore::Kind::rings:
      return ring_point(ring_of(core, piece), d);
    case ConvexCore::Kind::ellipsoid:
      return ellipsoid_point(core.size, d);
  }
  return Vec3::Zero();
}

Mat3 piece_curvature(const ConvexCore& core, int piece, const Vec3& d) {
  if (core.kind == ConvexCore::Kind::rings) {
    // d(r e)/dn = r/|n_xy| t tᵀ with e = n_xy/|n_xy| and t = z × e.
    const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
    if (length == 0) return Mat3::Zero();
    const Vec3 t(-d.y() / length, d.x() / length, 0);
    return ring_of(core, piece).radius / length * t * t.transpose();
  }
  if (core.kind == ConvexCore::Kind::ellipsoid) {
    // p = D² n / h with h = |D n|, so dp/dn = (D² - p pᵀ) / h.
    const Vec3 p = ellipsoid_point(core.size, d);
    const Mat3 squares = core.size.cwiseAbs2().asDiagonal();
    return (squares - p * p.transpose()) / core.size.cwiseProduct(d).norm();
  }
  return Mat3::Zero();
}

namespace {

Vec3 nearest_hull_face_normal(const ConvexHull& hull, const Vec3& d) {
  const SupportTable& table = hull.support_table;
  // The face whose normal is nearest to d is one of those about the farthest vertex.
  const std::size_t vertex = at(farthest_vertex(table, d, 0));
  Vec3 best = Vec3::Zero();
  double best_cosine = 0;
  for (int k = table.first_face[vertex]; k < table.first_face[vertex + 1]; ++k) {
    const Vec3& normal = hull.face_normals[at(table.faces[at(k)])];
    const double cosine = normal.dot(d);
    if (cosine > best_cosine) {
      best_cosine = cosine;
      best = normal;
    }
  }
  return best;
}

Vec3 triangle_normal(std::span<const Vec3> points, const Vec3& d) {
  const Vec3 area = (points[1] - points[0]).cross(points[2] - points[0]);
  const double length = area.norm();
  if (length == 0) return Vec3::Zero();
  return (area.dot(d) >= 0 ? 1 : -1) / length * area;
}

}  // namespace

Vec3 nearest_face_normal(const ConvexCore& core, const Vec3& d) {
  switch (core.kind) {
    case ConvexCore::Kind::box: {
      Eigen::Index axis = 0;
      d.cwiseAbs().maxCoeff(&axis);
      return Vec3::Unit(axis) * (d[axis] >= 0 ? 1 : -1);
    }
    case ConvexCore::Kind::points:
      if (core.hull) return nearest_hull_face_normal(*core.hull, d);
      return core.points.size() == 3 ? triangle_normal(core.points, d) : Vec3::Zero();
    case ConvexCore::Kind::rings: {
      const bool is_up = d.z() >= 0;
      const bool has_cap = ring_of(core, is_up ? ring_count(core) - 1 : 0).radius > 0;
      return {0, 0, !has_cap ? 0.0 : is_up ? 1.0 : -1.0};
    }
    case ConvexCore::Kind::point:
    case ConvexCore::Kind::segment:
    case ConvexCore::Kind::ellipsoid:
      break;
  }
  return Vec3::Zero();
}

}  // namespace rigor
