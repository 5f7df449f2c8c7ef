#include "rigor/bulk/collide_polytopes.hpp"

#include "rigor/bulk/collide_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// One core over a face of another; the borders of the face are those of the pair.
struct FaceView {
  const PlacedPolytope& owner;  ///< Of the face.
  const PlacedPolytope& other;
  int face;
  int lowest;  ///< Vertex of the other core.
  bool is_of_A;
  Vec3f m;  ///< Outward normal of the face.
  float offset;

  float height(const Vec3f& p) const { return m.dot(p) - offset; }
};

FaceView view_of(const SeparatingAxis& axis, const PlacedPolytopes& pair) {
  const bool is_of_A = axis.kind == SeparatingAxis::Kind::face_of_A;
  const PlacedPolytope &owner = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  const int face = is_of_A ? axis.a : axis.b, lowest = is_of_A ? axis.b : axis.a;
  const Vec3f m = is_of_A ? axis.n : Vec3f(-axis.n);
  return {owner, other, face, lowest, is_of_A, m, m.dot(other.vertex(lowest)) - axis.separation};
}

void list_borders(const FaceView& view, std::vector<FaceBorder>& borders) {
  borders.clear();
  const std::span<const int> loop = view.owner.hull->border_vertices(view.face);
  const Vec3f first = view.owner.vertex(loop.front());
  Vec3f corner = first;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3f next = k + 1 == loop.size() ? first : view.owner.vertex(loop[k + 1]);
    const Vec3f side = next - corner;
    const float length = side.norm();
    const Vec3f along = side / length;
    borders.push_back({corner, along, view.m.cross(along), length});
    corner = next;
  }
}

/// Adds the point of the other core, which is `height` above its foot on the face.
float add_above(const FaceView& view, const Vec3f& p, float height, std::uint32_t feature, float margin,
                PlacedPolytopes& pair) {
  const float gap = height - pair.a.radius - pair.b.radius;
  if (gap > margin) return gap;
  // The middle of the cores' points, moved to the middle of the surfaces'.
  const float shift = 0.5f * (pair.a.radius - pair.b.radius);
  const Vec3f middle = p - 0.5f * height * view.m + (view.is_of_A ? shift : -shift) * view.m;
  pair.candidates.push_back({middle, gap, feature});
  return gap;
}

/// The face around the vertex that is turned to the view most; -1 if there are none.
int facing_face(const FaceView& view, int vertex) {
  const FloatHull& hull = *view.other.hull;
  int face = -1;
  float least = kInfinity;
  for (int k = hull.fan_begin[at(vertex)]; k < hull.fan_begin[at(vertex + 1)]; ++k) {
    const float along = view.m.dot(view.other.normal(hull.fan[at(k)]));
    if (along < least) least = along, face = hull.fan[at(k)];
  }
  return face;
}

std::uint32_t vertex_feature(bool is_of_A, int vertex) {
  return is_of_A ? vertex_A_feature(vertex) : vertex_B_feature(vertex);
}

bool lies_over_face(const PlacedPolytopes& pair, const Vec3f& p, float slack) {
  for (const FaceBorder& border : pair.borders)
    if (border.inward.dot(p - border.corner) < -slack) return false;
  return true;
}

/// Where the edge of the other core from p0 to p1 crosses the border of the face; grazing does not count.
float add_crossings(const FaceView& view, int edge, const Vec3f& p0, const Vec3f& p1, float margin,
                    PlacedPolytopes& pair) {
  const float slack = 4 * pair.rounding;
  const std::span<const int> own_edges = view.owner.hull->border_edges(view.face);
  float least = kInfinity;
  for (std::size_t k = 0; k < own_edges.size(); ++k) {
    const FaceBorder& border = pair.borders[k];
    const float d0 = border.inward.dot(p0 - border.corner), d1 = border.inward.dot(p1 - border.corner);
    if (std::min(d0, d1) >= -slack || std::max(d0, d1) <= slack) continue;
    const Vec3f p = p0 + d0 / (d0 - d1) * (p1 - p0);
    const float along = border.along.dot(p - border.corner);
    if (along <= slack || along >= border.length - slack) continue;
    const int own = own_edges[k];
    const std::uint32_t feature = view.is_of_A ? crossing_feature(own, edge, view.other.hull->edges.size())
                                               : crossing_feature(edge, own, view.owner.hull->edges.size());
    least = std::min(least, add_above(view, p, view.height(p), feature, margin, pair));
  }
  return least;
}

/// Whether the face with the corners of the pair covers p, seen along the normal of the view.
bool is_covered(const FaceView& view, const PlacedPolytopes& pair, const Vec3f& p, float slack) {
  for (std::size_t k = 0; k < pair.corners.size(); ++k) {
    const Vec3f &corner = pair.corners[k], &next = pair.corners[k + 1 == pair.corners.size() ? 0 : k + 1];
    const Vec3f outward = view.m.cross(next - corner);
    const float beyond = outward.dot(p - corner);
    if (beyond > 0 && beyond * beyond > slack * slack * outward.squaredNorm()) return false;
  }
  return true;
}

/// Corners of the face of the view that the face of the other core covers.
float add_corners(const FaceView& view, int face, float margin, PlacedPolytopes& pair) {
  constexpr float least_slope = 0.05f;  // Heights above steeper faces are lost in rounding.
  const Vec3f normal = view.other.normal(face);
  const float slope = -normal.dot(view.m), slack = 4 * pair.rounding;
  float least = kInfinity;
  if (slope < least_slope) return least;
  const std::span<const int> loop = view.owner.hull->border_vertices(view.face);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3f corner = pair.borders[k].corner;
    if (!is_covered(view, pair, corner, slack)) continue;
    const float height = normal.dot(corner - pair.corners[0]) / slope;
    least = std::min(least, add_above(view, corner + height * view.m, height,
                                      vertex_feature(view.is_of_A, loop[k]), margin, pair));
  }
  return least;
}

/// The lowest point of the other core, wherever it is.
void add_lowest(const SeparatingAxis& axis, float margin, PlacedPolytopes& pair) {
  const FaceView view = view_of(axis, pair);
  add_above(view, view.other.vertex(view.lowest), axis.separation, vertex_feature(!view.is_of_A, view.lowest),
            margin, pair);
}

PlacedPolytope place_polytope(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB) {
  const FloatHull& hull = *shape.hull;
  const Mat3f R = placed.rotation();
  const Vec3f p = p_OB + placed.position();
  return {&hull,
          R,
          R * shape.scale.asDiagonal(),
          p,
          R * hull.center + p,
          shape.inner_radius() - shape.radius,
          shape.radius,
          shape.extent,
          shape.kind == BulkShape::Kind::box ? shape.scale : Vec3f(Vec3f::Zero())};
}

/// Moves the ball inside a core as near to a point as it goes.
void move_ball(const BulkShape& shape, const Vec3f& to, PlacedPolytope& core) {
  if (shape.ball_way.isZero(0)) return;
  const Vec3f local = core.R.transpose() * (to - core.p);
  core.center = core.R * local.cwiseMax(-shape.ball_way).cwiseMin(shape.ball_way) + core.p;
}

}  // namespace

int PlacedPolytope::farthest(const Vec3f& n) const {
  return find_support(hull->vertices(), M.transpose() * n, best_lane_target()).index;
}

void place_polytopes(const BulkShape& a, const PlacedShape& placed_A, const BulkShape& b,
                     const PlacedShape& placed_B, const Vec3f& d, PlacedPolytopes& pair) {
  pair.a = place_polytope(a, placed_A, Vec3f::Zero());
  pair.b = place_polytope(b, placed_B, d);
  pair.rounding = kCollisionRounding * (a.extent + b.extent + d.norm());
  pair.thinnest = std::min(a.inner_radius(), b.inner_radius());
  pair.equal_depth = pair.rounding + kEqualDepthOfSize * pair.thinnest;
  move_ball(a, pair.b.center, pair.a);
  move_ball(b, pair.a.center, pair.b);
}

float clip_on_face(const SeparatingAxis& axis, float margin, PlacedPolytopes& pair) {
  const FaceView view = view_of(axis, pair);
  const float slack = 4 * pair.rounding;
  list_borders(view, pair.borders);
  // The points of the other core that count: of its face that is turned to this one, or of the segment.
  const FloatHull& hull = *view.other.hull;
  const int face = facing_face(view, view.lowest);
  constexpr int segment_edges[] = {0};
  const int segment_ends[] = {hull.edges[0].v0, hull.edges[0].v1};
  const std::span<const int> loop = face < 0
                                        ? std::span<const int>(segment_ends, hull.vertex_count == 1 ? 1u : 2u)
                                        : hull.border_vertices(face);
  const std::span<const int> edges = face < 0 ? std::span<const int>(segment_edges) : hull.border_edges(face);
  pair.corners.clear();
  for (const int v : loop) pair.corners.push_back(view.other.vertex(v));
  float least = kInfinity;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3f p = pair.corners[k];
    if (lies_over_face(pair, p, slack))
      least = std::min(
          least, add_above(view, p, view.height(p), vertex_feature(!view.is_of_A, loop[k]), margin, pair));
    if (k >= edges.size() || loop.size() == 1) continue;
    least = std::min(least, add_crossings(view, edges[k], p, pair.corners[k + 1 == loop.size() ? 0 : k + 1],
                                          margin, pair));
  }
  return face < 0 ? least : std::min(least, add_corners(view, face, margin, pair));
}

namespace {

/// The face at one of two edges that parts the cores best (of A, unless that of B is better by more than the
/// rounding), if it does by more than `least`; else none. Cores that turn about a point of two edges come to
/// lie on one of these.
SeparatingAxis find_face_at(const SeparatingAxis& edges, float least, const PlacedPolytopes& pair) {
  SeparatingAxis best;
  for (const bool is_of_A : {true, false}) {
    const FloatHull::Edge& edge = is_of_A ? pair.a.edge(edges.a) : pair.b.edge(edges.b);
    for (const int f : {edge.f0, edge.f1}) {
      if (f < 0) continue;  // Of a segment.
      const SeparatingAxis face = face_axis(pair, is_of_A, f);
      if (face.separation > std::max(least, best.separation + (is_of_A ? 0 : pair.rounding))) best = face;
    }
  }
  return best;
}

/// Contacts over a face that parts the cores nearly as well as two edges do, if they are nearly as deep; or
/// nothing, and what may take their place within the step is pair.beside.
std::optional<Vec3f> prefer_face(const SeparatingAxis& edges, float margin, PlacedPolytopes& pair) {
  const float gap = edges.separation - pair.a.radius - pair.b.radius;
  const float preference =
      kFacePreferenceOfOverlap * std::max(-gap, 0.0f) + kFacePreferenceOfSize * pair.thinnest;
  const SeparatingAxis face = find_face_at(edges, edges.separation - std::max(preference, margin), pair);
  if (face.kind == SeparatingAxis::Kind::none) return std::nullopt;
  if (face.separation >= edges.separation - preference) {
    if (clip_on_face(face, margin, pair) <= gap + preference) return face.n;
    pair.candidates.clear();
  }
  pair.beside = face;
  return std::nullopt;
}

}  // namespace

std::optional<Vec3f> find_contacts_beside(PlacedPolytopes& pair, float margin) {
  pair.candidates.clear();
  if (pair.beside.kind == SeparatingAxis::Kind::none) return std::nullopt;
  clip_on_face(pair.beside, margin, pair);
  return pair.beside.n;
}

std::optional<Vec3f> find_polytope_candidates(PlacedPolytopes& pair, float margin, const AxisGuess& guess,
                                              SeparatingAxis& axis) {
  pair.candidates.clear();
  pair.beside = {};
  const float radii = pair.a.radius + pair.b.radius;
  axis = find_separating_axis(pair, margin + radii, guess);
  if (!(axis.separation <= margin + radii)) return std::nullopt;
  const bool is_apart = axis.separation > 0;
  if (axis.kind == SeparatingAxis::Kind::edges) {
    if (const std::optional<Vec3f> n = prefer_face(axis, margin, pair)) return n;
    if (cross_edges(axis, pair)) return axis.n;
    return join_nearest_edges(axis.n, axis.separation, margin, pair);
  }
  const float least = clip_on_face(axis, margin, pair);
  if (least <= axis.separation - radii + 4 * pair.rounding) return axis.n;
  if (is_apart) {
    pair.candidates.clear();
    return join_nearest_edges(axis.n, axis.separation, margin, pair);
  }
  add_lowest(axis, margin, pair);
  return axis.n;
}

}  // namespace rigor
