#pragma once

#include "rigor/bulk/bulk_shape.hpp"
#include "rigor/bulk/collide_points.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace rigor {

/// A core placed in a frame O: the centre of body A, axes of W. Columns as in FloatHull.
struct PlacedPolytope {
  const FloatHull* hull = nullptr;
  std::vector<float> x, y, z;
  std::vector<float> nx, ny, nz, offset;
  Vec3f center;      ///< Of a ball inside.
  float inner = 0;   ///< Its radius [m].
  float radius = 0;  ///< Of the ball added to the core [m].
  float reach = 0;   ///< Coordinates are not larger [m]: their rounding is in proportion.

  Vec3f vertex(int v) const {
    const std::size_t k = static_cast<std::size_t>(v);
    return Vec3f(x[k], y[k], z[k]);
  }
  Vec3f normal(int f) const {
    const std::size_t k = static_cast<std::size_t>(f);
    return Vec3f(nx[k], ny[k], nz[k]);
  }
  const FloatHull::Edge& edge(int e) const { return hull->edges[static_cast<std::size_t>(e)]; }
  Vec3f edge_vector(int e) const { return vertex(edge(e).v1) - vertex(edge(e).v0); }
};

/// p_OB: the centre of the shape's body.
void place_polytope(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB,
                    PlacedPolytope& polytope);

/// The direction that parts two cores best, of the normals of faces and of pairs of edges.
struct SeparatingAxis {
  enum class Kind { none, face_of_A, face_of_B, edges };
  Kind kind = Kind::none;
  int a = -1, b = -1;                                          ///< Face, or edges.
  Vec3f n = Vec3f::UnitZ();                                    ///< Unit, from A to B.
  float separation = -std::numeric_limits<float>::infinity();  ///< min n · b - max n · a [m].
};

/// Where the search keeps its lists, to be used again.
struct PolytopeScratch {
  PlacedPolytope a, b;
  std::vector<int> edges_A, edges_B;
  std::vector<ManifoldCandidate> candidates;
};

/// The axis, or one beyond `limit` as soon as one is found. A face is taken where an edge pair is better by
/// less than `rounding`.
SeparatingAxis find_separating_axis(PolytopeScratch& pair, float limit, float rounding);

/// Contacts of two cores with their balls, in pair.candidates; nothing beyond the margin. Returns the normal.
///
/// Source: Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013: faces, and the edges whose
/// arcs cross on the Gauss map. Ours: only directions are tried for which the balls inside the cores leave
/// more separation than there is already; where cores are apart and the axis joins no two points of them,
/// the nearest points of their edges take its place, so that gaps are distances.
std::optional<Vec3f> find_polytope_candidates(PolytopeScratch& pair, float margin, float rounding);

// The parts of this, each of which fills pair.candidates.

/// The region in which the cores lie over the face of the axis; returns its least gap (infinite: empty).
float clip_on_face(const SeparatingAxis& axis, float margin, float slack, PolytopeScratch& pair);
/// Where two edges cross; false if the cores are apart and it is beyond their ends.
bool cross_edges(const SeparatingAxis& axis, float slack, PolytopeScratch& pair);
/// The nearest points of two cores that are apart, both of them on edges. Returns the normal, or nothing
/// beyond the margin.
std::optional<Vec3f> join_nearest_edges(const SeparatingAxis& axis, float margin, float slack,
                                        PolytopeScratch& pair);

/// Nearest points of two segments: parameters in [0, 1] from their first ends; of parallel ones at an end.
struct SegmentPoints {
  float s, t;
};
SegmentPoints nearest_on_segments(const Vec3f& p0, const Vec3f& u, const Vec3f& q0, const Vec3f& v);

}  // namespace rigor
