#pragma once

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/bulk/narrow_phase/face_outlines.hpp"
#include "rigor/bulk/narrow_phase/hull_lanes.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/core/index.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace rigor {

/// A core in a frame O: the centre of body A, axes of W. All its vertices and normals are placed at once,
/// eight in lanes, which takes less time than to place those that are asked for.
struct PlacedPolytope {
  const FloatHull* hull = nullptr;
  CorePlace place;   ///< The shape in O.
  Vec3f center;      ///< Centre of a ball inside the core, in O [m].
  float inner = 0;   ///< Radius of the ball inside [m].
  float radius = 0;  ///< Radius by which the core is grown [m].
  float extent = 0;  ///< No vertex is farther from the shape's origin [m].
  bool is_box = false;
  alignas(32) float box_offsets[kLaneCount];  ///< Offsets of the faces of a box from its middle [m].
  PlacedColumns vertex_columns, normal_columns;

  LaneColumns vertices() const { return vertex_columns.columns(); }
  LaneColumns normals() const { return normal_columns.columns(); }
  Vec3f vertex(int v) const { return vertex_columns[v]; }
  Vec3f normal(int f) const { return normal_columns[f]; }
  /// Offsets of the faces' planes from the shape's origin, in whole lanes [m].
  const float* offsets() const { return is_box ? box_offsets : hull->offset.data(); }
  const FloatHull::Edge& edge(int e) const { return hull->edges[at(e)]; }
  Vec3f edge_vector(int e) const { return vertex(edge(e).v1) - vertex(edge(e).v0); }
  /// The vertex farthest along n (the first of equal ones). It is searched for in the shape's frame, where
  /// the vertices are rounded once.
  int farthest(const Vec3f& n) const {
    return find_support(hull->vertices(), place.M.transpose() * n, best_lane_target()).index;
  }
  /// The face around a vertex that faces against n most; -1 if there are none.
  int face_against(int v, const Vec3f& n) const;
};

/// A direction that may separate two cores best: the normal of a face, or across a pair of edges.
struct SeparatingAxis {
  enum class Kind : std::int8_t { none, face_of_A, face_of_B, edges };
  Kind kind = Kind::none;
  int a = -1, b = -1;  ///< A face and the vertex of the other core that is lowest over it; or two edges.
  Vec3f n = Vec3f::UnitZ();                                    ///< Unit, from A to B.
  float separation = -std::numeric_limits<float>::infinity();  ///< min n · b - max n · a [m].
  bool is_proven = true;  ///< False if only the whole search showed that it is the best.
};

/// Names an axis of two cores, and whether it was proven, in 32 bits, so that it can be tried again in the
/// next step.
using AxisCode = std::uint32_t;
AxisCode code_of(const SeparatingAxis& axis);  ///< 0 for no axis.

/// Two cores, and the lists that the search uses again and again.
struct PlacedPolytopes {
  PlacedPolytope a, b;
  const PlacedShape* shape_A =
      nullptr;            ///< The shape that `a` was placed from: pairs of one body follow each other.
  float rounding = 0;     ///< Of separations: kCollisionRounding of the lengths in the pair [m].
  float thinnest = 0;     ///< Radius of the smaller of the balls inside the shapes [m].
  float equal_depth = 0;  ///< Points whose gaps differ by less are equally deep [m].
  std::vector<float> heights, along_A, along_B, heights_A, heights_B;
  ArcBlocks arcs_A, arcs_B;
  std::vector<int> faces, edges_A, edges_B, nearest;
  std::vector<SegmentLanes> segments;
  OutlineMeeting meeting;
  std::vector<ManifoldCandidate> candidates;
  SeparatingAxis beside;  ///< Where edges touch, the face of a second manifold; or none.
};

/// Places both cores; d is from the centre of body A to that of body B. If placed_A is that of the previous
/// call, it must not have changed since then.
void place_polytopes(const BulkShape& a, const PlacedShape& placed_A, const BulkShape& b,
                     const PlacedShape& placed_B, const Vec3f& d, PlacedPolytopes& pair);

/// The place of a shape's core, p_OB being the centre of its body.
CorePlace place_of(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB);
/// Moves the ball inside a core as near to a point as it can be: the bound by the balls is the better for it.
void move_ball(const BulkShape& shape, const Vec3f& to, PlacedPolytope& core);
/// Places a core.
void place_polytope(const BulkShape& shape, const CorePlace& place, PlacedPolytope& core);
/// The centre of the ball inside a core that is placed.
inline Vec3f middle_of(const PlacedPolytope& core) {
  return core.place.R * core.hull->center + core.place.t;
}
/// Makes the segment from p along u the core A of the pair, whose core B is placed; `hull` is that of a
/// segment.
void place_segment(const FloatHull& hull, const Vec3f& p, const Vec3f& u, PlacedPolytopes& pair);

/// Slack beyond which the rounding of a separation does not matter, however it is measured: cores that some
/// direction separates by a limit and so much more are farther apart than the limit by every computation [m].
inline float parting_slack(float rounding) {
  return 64 * rounding;
}

/// Whether a few steps of a search from n, not 0, find a direction along which the cores are farther apart
/// than `limit`. False is no proof of the contrary. n becomes the last direction.
///
/// Source: Chung and Wang, Quick Collision Detection of Polytopes in Virtual Environments, ACM VRST 1996: a
/// direction that does not separate the support vertices is reflected at the plane across their difference.
bool find_parting_direction(const PlacedPolytopes& pair, float limit, Vec3f& n);

/// Where to look first.
struct AxisGuess {
  Vec3f n;            ///< A direction, not 0.
  AxisCode axis = 0;  ///< An axis of these cores; 0 if there is none.
};

/// The axis of the whole search, whatever the guess: the best face (of A, unless that of B is better by more
/// than the rounding), or the best edge pair if that is better than it by more than the rounding. Where the
/// cores are farther apart than `limit`, it is any axis that shows this. The axis of the guess is tried
/// first, then those around it: where one of them proves itself, no other is tried. An axis that could not be
/// proven in the step before is seldom proven in this one: it is only tried, and the whole search follows.
SeparatingAxis find_separating_axis(PlacedPolytopes& pair, float limit, const AxisGuess& guess);

/// Contacts of two cores with their balls, in pair.candidates; nothing beyond the margin. Returns their
/// normal. `axis` becomes the axis found. Where that is of edges, but a face separates the cores nearly as
/// well (kFacePreferenceOfOverlap), contacts are those over the face; where a face may do so within the step,
/// pair.beside is that face (find_contacts_beside()).
///
/// Source: Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013: faces, and the edges whose
/// arcs cross on the Gauss map. Ours: only directions are tried for which the balls inside the cores leave
/// more separation than there is already, and none besides an axis that proves itself
/// (docs/theory/narrow_phase.md); where cores are apart and the axis joins no two points of them, the nearest
/// points of their edges take its place, so that gaps are distances.
std::optional<Vec3f> find_polytope_candidates(PlacedPolytopes& pair, float margin, const AxisGuess& guess,
                                              SeparatingAxis& axis);

/// After find_polytope_candidates(): the contacts over pair.beside, or nothing if there is none.
std::optional<Vec3f> find_contacts_beside(PlacedPolytopes& pair, float margin);

// The parts of find_polytope_candidates().

/// The axis of a face of one core and the vertex of the other that is lowest over it.
SeparatingAxis face_axis(const PlacedPolytopes& pair, bool is_of_A, int face);
/// The axis of two edges; none if they are parallel.
SeparatingAxis edge_axis(const PlacedPolytopes& pair, int i, int j);
/// Finds the region in which the cores lie over the face of the axis; returns its least gap (infinite if it
/// is empty).
float clip_on_face(const SeparatingAxis& axis, float margin, PlacedPolytopes& pair);
/// Finds the point where two edges cross; false if the cores are apart and it is beyond their ends.
bool cross_edges(const SeparatingAxis& axis, PlacedPolytopes& pair);
/// Finds the nearest points of two cores that n separates, both of them on edges. Returns the normal, or
/// nothing if they are beyond the margin. The answer does not depend on n, unless the cores touch to
/// rounding.
std::optional<Vec3f> join_nearest_edges(const Vec3f& n, float separation, float margin,
                                        PlacedPolytopes& pair);

/// The bound by the balls inside: no direction n separates the cores by more than n · between - balls.
struct BallBound {
  Vec3f between;  ///< From the ball inside A to that inside B [m].
  float balls;    ///< Sum of their radii [m].
};
BallBound ball_bound(const PlacedPolytopes& pair);

/// Whether rounding changes the separation of the axis by no more than pair.rounding; it may do so for edges
/// that are nearly parallel.
bool is_well_conditioned(const PlacedPolytopes& pair, const SeparatingAxis& axis);
/// Whether it is proven that no direction separates the cores by more than the axis does, up to the rounding.
/// False proves nothing.
bool is_best(const PlacedPolytopes& pair, const BallBound& bound, const SeparatingAxis& axis);
/// The axis that the whole search would find, if the given one proves it: by a proof as in is_best(), with
/// some room, and without any other feature that is as good.
std::optional<SeparatingAxis> settle(const PlacedPolytopes& pair, const BallBound& bound,
                                     const SeparatingAxis& axis);

/// Nearest points of two segments, as parameters in [0, 1] from their first ends; those of parallel segments
/// are at an end.
struct SegmentPoints {
  float s, t;
};
SegmentPoints nearest_on_segments(const Vec3f& p0, const Vec3f& u, const Vec3f& q0, const Vec3f& v);

}  // namespace rigor
