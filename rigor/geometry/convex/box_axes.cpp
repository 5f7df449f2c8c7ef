#include "rigor/geometry/convex/box_axes.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// Edges whose angle has a smaller sine give no direction of their own: the face normals are as good.
constexpr double kParallelAxes = 1e-12;

/// The face whose normal is nearest to d.
int face_along(const FeatureGraph& graph, const Vec3& d) {
  int best = 0;
  for (int f = 1; f < graph.face_count(); ++f) {
    if (graph.normal(f).dot(d) > graph.normal(best).dot(d)) best = f;
  }
  return best;
}

/// The edge at a corner that is parallel to the axis.
int edge_along(const FeatureGraph& graph, int corner, int axis) {
  for (int k = graph.first_of_vertex(corner); k < graph.first_of_vertex(corner + 1); ++k) {
    const FeatureGraph::OutgoingEdge& outgoing = graph.outgoing[at(k)];
    if (outgoing.direction[axis] != 0) return outgoing.half_edge;
  }
  return -1;
}

/// The farthest corner along d: its index has a bit for each positive coordinate.
int corner_along(const Vec3& d) {
  return (d.x() >= 0 ? 1 : 0) | (d.y() >= 0 ? 2 : 0) | (d.z() >= 0 ? 4 : 0);
}

}  // namespace

BoxAxis find_box_axis(const PolytopePair& pair, double rounding) {
  RIGOR_ASSERT(pair.side(0).is_box() && pair.side(1).is_box());
  const Mat3& R = pair.X_AB().R;
  const Vec3& t = pair.X_AB().p;
  const Vec3& a = pair.side(0).vertex(7);  // half extents
  const Vec3& b = pair.side(1).vertex(7);
  const Mat3 magnitude = R.cwiseAbs();

  // Separation along a direction n: |n·t| less the half widths of both boxes. The normals of A's faces come
  // first, then B's: a later direction replaces an earlier one only if it is better by more than the
  // rounding, so that the choice does not change while boxes rest on each other.
  double best = -std::numeric_limits<double>::infinity();
  Vec3 n = Vec3::UnitX();
  int axis_a = -1, axis_b = -1;
  const Vec3 of_a = t.cwiseAbs() - a - magnitude * b;
  const Vec3 t_B = R.transpose() * t;
  const Vec3 of_b = t_B.cwiseAbs() - b - magnitude.transpose() * a;
  for (int i = 0; i < 3; ++i) {
    if (of_a[i] <= best + rounding) continue;
    best = of_a[i];
    axis_a = i;
  }
  for (int j = 0; j < 3; ++j) {
    if (of_b[j] <= best + rounding) continue;
    best = of_b[j];
    axis_a = -1;
    axis_b = j;
  }
  // The nine products of an edge of A and an edge of B.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 product = Vec3::Unit(i).cross(R.col(j));
      const double sine = product.norm();
      if (sine < kParallelAxes) continue;
      const Vec3 m = product / sine;
      const double separation =
          std::abs(m.dot(t)) - a.dot(m.cwiseAbs()) - b.dot((R.transpose() * m).cwiseAbs());
      if (separation <= best + rounding) continue;
      best = separation;
      axis_a = i;
      axis_b = j;
      n = m;
    }
  }

  // The direction from A to B, and the features that are farthest along it.
  if (axis_b < 0) n = Vec3::Unit(axis_a);
  if (axis_a < 0) n = R.col(axis_b);
  if (n.dot(t) < 0) n = -n;
  const Vec3 n_B = -(R.transpose() * n);
  const int corner_a = corner_along(n), corner_b = corner_along(n_B);
  using Kind = PolytopeFeature::Kind;
  if (axis_b < 0) return {{{Kind::face, face_along(pair.graph(0), n)}, {Kind::vertex, corner_b}}, best};
  if (axis_a < 0) return {{{Kind::vertex, corner_a}, {Kind::face, face_along(pair.graph(1), n_B)}}, best};
  return {{{Kind::edge, edge_along(pair.graph(0), corner_a, axis_a)},
           {Kind::edge, edge_along(pair.graph(1), corner_b, axis_b)}},
          best};
}

}  // namespace rigor
