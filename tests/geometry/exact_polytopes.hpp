#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <algorithm>
#include <variant>
#include <vector>

namespace rigor::test {

using LongVec3 = Eigen::Matrix<long double, 3, 1>;

/// A box or hull in world coordinates of extended precision.
struct ExactPolytope {
  struct Edge {
    LongVec3 direction;
    LongVec3 normal_0, normal_1;  ///< Of its faces.
  };
  std::vector<LongVec3> vertices;
  std::vector<LongVec3> normals;
  std::vector<LongVec3> face_points;
  std::vector<Edge> edges;

  ExactPolytope(const Shape& shape, const Pose& X_WS) {
    const ConvexHull hull = std::holds_alternative<Box>(shape)
                                ? make_box_hull(std::get<Box>(shape).half_extents)
                                : *std::get<Convex>(shape).hull;
    const auto at = [&](int v) { return vertices[static_cast<std::size_t>(v)]; };
    for (const Vec3& v : hull.vertices) {
      vertices.push_back(X_WS.R.cast<long double>() * v.cast<long double>() + X_WS.p.cast<long double>());
    }
    for (const std::vector<int>& loop : hull.faces) {
      LongVec3 area = LongVec3::Zero();
      for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        area += (at(loop[i]) - at(loop[0])).cross(at(loop[i + 1]) - at(loop[0]));
      normals.push_back(area.normalized());
      face_points.push_back(at(loop[0]));
    }
    for (const ConvexHull::Edge& e : hull.edges) {
      edges.push_back({(at(e.v1) - at(e.v0)).normalized(), normals[static_cast<std::size_t>(e.f0)],
                       normals[static_cast<std::size_t>(e.f1)]});
    }
  }

  /// Largest height of a point over the faces [m]: 0 on the surface, negative inside.
  long double height_of(const Vec3& p_W) const {
    long double height = -1e30L;
    for (std::size_t f = 0; f < normals.size(); ++f) {
      height = std::max(height, normals[f].dot(p_W.cast<long double>() - face_points[f]));
    }
    return height;
  }
};

/// s(n) = min over B of n·b - max over A of n·a [m].
inline long double exact_separation(const ExactPolytope& a, const ExactPolytope& b, const LongVec3& n) {
  long double top = -1e30L, bottom = 1e30L;
  for (const LongVec3& v : a.vertices) top = std::max(top, n.dot(v));
  for (const LongVec3& v : b.vertices) bottom = std::min(bottom, n.dot(v));
  return bottom - top;
}

/// Whether n is between the normals of the edge's faces, or nearly so: to take too many directions is no
/// error.
inline bool is_on_arc(const ExactPolytope::Edge& edge, const LongVec3& n) {
  const long double c = edge.normal_0.dot(edge.normal_1);
  const long double x = n.dot(edge.normal_0), y = n.dot(edge.normal_1);
  const long double slack = -1e-6L * (1 - c * c);
  return x - c * y >= slack && y - c * x >= slack;
}

/// max over n of s(n) where polytopes overlap: all normals of faces, and all products of edges whose arcs on
/// the Gauss maps meet.
inline long double exact_signed_depth(const ExactPolytope& a, const ExactPolytope& b) {
  long double best = -1e30L;
  for (const LongVec3& n : a.normals) best = std::max(best, exact_separation(a, b, n));
  for (const LongVec3& n : b.normals) best = std::max(best, exact_separation(a, b, -n));
  for (const ExactPolytope::Edge& e : a.edges) {
    for (const ExactPolytope::Edge& f : b.edges) {
      const LongVec3 product = e.direction.cross(f.direction);
      const long double sine = product.norm();
      if (sine < 1e-12L) continue;
      for (const long double sign : {1.0L, -1.0L}) {
        const LongVec3 n = sign / sine * product;
        if (is_on_arc(e, n) && is_on_arc(f, -n)) best = std::max(best, exact_separation(a, b, n));
      }
    }
  }
  return best;
}

}  // namespace rigor::test
