#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"

#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// One core over a face of another.
struct FaceView {
  const PlacedPolytope& owner;  ///< The core of the face.
  const PlacedPolytope& other;
  int face;
  int lowest;  ///< The vertex of the other core that is lowest over the face.
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

/// Adds the point p of the other core, which is `height` above its foot on the face; returns its gap.
float add_above(const FaceView& view, const Vec3f& p, float height, std::uint32_t feature, float margin,
                PlacedPolytopes& pair) {
  const float gap = height - pair.a.radius - pair.b.radius;
  if (gap > margin) return gap;
  // The point is midway between those of the cores, moved to the middle of the two surfaces.
  const float shift = 0.5f * (pair.a.radius - pair.b.radius);
  const Vec3f middle = p - 0.5f * height * view.m + (view.is_of_A ? shift : -shift) * view.m;
  pair.candidates.push_back({middle, gap, feature});
  return gap;
}

std::uint32_t vertex_feature(bool is_of_A, int vertex) {
  return is_of_A ? vertex_A_feature(vertex) : vertex_B_feature(vertex);
}

/// Adds the corners of the other outline that are over the face; returns the least gap.
float add_corners_over(const FaceView& view, const FaceOutline& outline, float margin,
                       PlacedPolytopes& pair) {
  float least = kInfinity;
  for (const std::size_t k : pair.meeting.over) {
    const Vec3f p = outline.corner(k);
    const std::uint32_t feature = vertex_feature(!view.is_of_A, outline.corners[k]);
    least = std::min(least, add_above(view, p, view.height(p), feature, margin, pair));
  }
  return least;
}

/// The point where the side from p0 to p1 of the other outline crosses the line through two corners of the
/// face.
Vec3f crossing_of(const FaceView& view, const Vec3f& corner, const Vec3f& next, const Vec3f& p0,
                  const Vec3f& p1) {
  const Vec3f side = next - corner;
  const Vec3f inward = view.m.cross(Vec3f(side / side.norm()));
  const float d0 = inward.dot(p0 - corner), d1 = inward.dot(p1 - corner);
  return p0 + d0 / (d0 - d1) * (p1 - p0);
}

/// Adds the points where sides of the other outline, which are these edges, cross the border of the face;
/// returns the least gap.
float add_crossings(const FaceView& view, const FaceOutline& own, const FaceOutline& outline,
                    std::span<const int> edges, float margin, PlacedPolytopes& pair) {
  const std::span<const int> own_edges = view.owner.hull->border_edges(view.face);
  float least = kInfinity;
  for (const auto& [border, side] : pair.meeting.crossings) {
    const Vec3f p = crossing_of(view, own.corner(border), own.corner(own.next(border)), outline.corner(side),
                                outline.corner(outline.next(side)));
    const std::uint32_t feature =
        view.is_of_A ? crossing_feature(own_edges[border], edges[side], view.other.hull->edges.size())
                     : crossing_feature(edges[side], own_edges[border], view.owner.hull->edges.size());
    least = std::min(least, add_above(view, p, view.height(p), feature, margin, pair));
  }
  return least;
}

/// Adds the corners of the view's face that are under the face of the other core; returns the least gap.
float add_corners_under(const FaceView& view, const FaceOutline& own, int face, float margin,
                        PlacedPolytopes& pair) {
  constexpr float least_slope = 0.05f;  // Heights above steeper faces are lost in rounding.
  const Vec3f normal = view.other.normal(face);
  const float slope = -normal.dot(view.m);
  float least = kInfinity;
  if (slope < least_slope) return least;
  const Vec3f p = view.other.vertex(view.other.hull->border_vertices(face).front());
  for (const std::size_t k : pair.meeting.under) {
    const Vec3f corner = own.corner(k);
    const float height = normal.dot(corner - p) / slope;
    least = std::min(least, add_above(view, corner + height * view.m, height,
                                      vertex_feature(view.is_of_A, own.corners[k]), margin, pair));
  }
  return least;
}

/// Adds the lowest point of the other core, wherever it is.
void add_lowest(const SeparatingAxis& axis, float margin, PlacedPolytopes& pair) {
  const FaceView view = view_of(axis, pair);
  add_above(view, view.other.vertex(view.lowest), axis.separation, vertex_feature(!view.is_of_A, view.lowest),
            margin, pair);
}

}  // namespace

CorePlace place_of(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB) {
  const Mat3f R = placed.rotation();
  return {R * shape.scale.asDiagonal(), R, p_OB + placed.position()};
}

void move_ball(const BulkShape& shape, const Vec3f& to, PlacedPolytope& core) {
  if (shape.ball_shift.isZero(0)) return;
  const CorePlace& place = core.place;
  const Vec3f local = place.R.transpose() * (to - place.t);
  core.center = place.R * local.cwiseMax(-shape.ball_shift).cwiseMin(shape.ball_shift) + place.t;
}

int PlacedPolytope::face_against(int v, const Vec3f& n) const {
  int face = -1;
  float least = kInfinity;
  for (const int f : hull->faces_around(v)) {
    const float along = n.dot(normal(f));
    if (along < least) least = along, face = f;
  }
  return face;
}

void place_polytope(const BulkShape& shape, const CorePlace& place, PlacedPolytope& core) {
  const FloatHull& hull = *shape.hull;
  core.hull = &hull;
  core.place = place;
  core.inner = shape.inner_radius() - shape.radius;
  core.radius = shape.radius;
  core.extent = shape.extent;
  core.is_box = shape.kind == BulkShape::Kind::box;
  for (int f = 0; core.is_box && f < kLaneCount; ++f)
    core.box_offsets[f] = f < hull.face_count ? hull.normal(f).cwiseAbs().dot(shape.scale) : 0;
  core.vertex_columns.place(hull.vertices(), place.M, place.t, best_lane_target());
  const Vec3f nothing = Vec3f::Constant(-0.0f);  // Adding -0 changes no bit, also of zeros.
  core.normal_columns.place(hull.normals(), place.R, nothing, best_lane_target());
}

void place_segment(const FloatHull& hull, const Vec3f& p, const Vec3f& u, PlacedPolytopes& pair) {
  PlacedPolytope &a = pair.a, &b = pair.b;
  // The hull of a segment runs along z from -1 to 1.
  a.hull = &hull;
  a.place.R = Mat3f::Identity();
  a.place.M = Mat3f::Zero();
  a.place.M.col(2) = 0.5f * u;
  a.place.t = p + 0.5f * u;
  a.inner = a.radius = 0;
  a.extent = 0.5f * u.norm();
  a.is_box = false;
  a.vertex_columns.place(hull.vertices(), a.place.M, a.place.t, best_lane_target());
  a.normal_columns.place(hull.normals(), a.place.R, Vec3f::Zero(), best_lane_target());
  // Lengths and thicknesses of the pair, and the point of the segment that is nearest to the ball inside B.
  pair.shape_A = nullptr;
  pair.rounding = kCollisionRounding * (a.extent + b.extent + a.place.t.norm() + b.place.t.norm());
  pair.thinnest = b.inner + b.radius;
  pair.equal_depth = pair.rounding + kEqualDepthOfSize * pair.thinnest;
  const float square = u.squaredNorm();
  a.center = p + std::clamp((b.center - p).dot(u) / square, 0.0f, 1.0f) * u;
}

void place_polytopes(const BulkShape& a, const PlacedShape& placed_A, const BulkShape& b,
                     const PlacedShape& placed_B, const Vec3f& d, PlacedPolytopes& pair) {
  if (pair.shape_A != &placed_A) place_polytope(a, place_of(a, placed_A, Vec3f::Zero()), pair.a);
  pair.shape_A = &placed_A;
  place_polytope(b, place_of(b, placed_B, d), pair.b);
  // The rounding of separations, 1e-6 of the lengths in the pair, and what depends on the size of the cores.
  pair.rounding = kCollisionRounding * (a.extent + b.extent + d.norm());
  pair.thinnest = std::min(a.inner_radius(), b.inner_radius());
  pair.equal_depth = pair.rounding + kEqualDepthOfSize * pair.thinnest;
  // Balls inside both cores, as near to each other as they can be.
  pair.a.center = middle_of(pair.a);
  pair.b.center = middle_of(pair.b);
  move_ball(a, pair.b.center, pair.a);
  move_ball(b, pair.a.center, pair.b);
}

float clip_on_face(const SeparatingAxis& axis, float margin, PlacedPolytopes& pair) {
  const FaceView view = view_of(axis, pair);
  const std::span<const int> border = view.owner.hull->border_vertices(view.face);
  // The outline of the other core that may touch the face: of its face that faces this one, or of the
  // segment.
  const FloatHull& hull = *view.other.hull;
  const int face = view.other.face_against(view.lowest, view.m);
  constexpr int segment_edges[] = {0};
  const int segment_ends[] = {hull.edges[0].v0, hull.edges[0].v1};
  const std::span<const int> loop = face < 0
                                        ? std::span<const int>(segment_ends, hull.vertex_count == 1 ? 1u : 2u)
                                        : hull.border_vertices(face);
  const std::span<const int> edges = face < 0 ? std::span<const int>(segment_edges) : hull.border_edges(face);
  // Which corners are over the other outline and which sides cross is decided in the plane of the face; the
  // points and their heights are those in space.
  const FaceOutline own{view.owner.vertices(), border, border.size()},
      other{view.other.vertices(), loop, face < 0 ? loop.size() - 1 : loop.size()};
  meet_outlines(own, view.m, other, 4 * pair.rounding, pair.meeting);
  const float least = std::min(add_corners_over(view, other, margin, pair),
                               add_crossings(view, own, other, edges, margin, pair));
  return face < 0 ? least : std::min(least, add_corners_under(view, own, face, margin, pair));
}

namespace {

/// The face at one of two edges that separates the cores best (of A, unless that of B is better by more than
/// the rounding), if it does so by more than `least`; else none. Cores that rotate about a point of two edges
/// come to lie on one of these.
SeparatingAxis find_face_at(const SeparatingAxis& edges, float least, const PlacedPolytopes& pair) {
  SeparatingAxis best;
  for (const bool is_of_A : {true, false}) {
    const PlacedPolytope &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
    const FloatHull::Edge &edge = own.edge(is_of_A ? edges.a : edges.b),
                          &other_edge = other.edge(is_of_A ? edges.b : edges.a);
    const Vec3f corner = own.vertex(edge.v0);
    const Vec3f first = other.vertex(other_edge.v0) - corner, second = other.vertex(other_edge.v1) - corner;
    for (const int f : {edge.f0, edge.f1}) {
      if (f < 0) continue;  // The edge of a segment has no faces.
      const float needed = std::max(least, best.separation + (is_of_A ? 0 : pair.rounding));
      // No face separates the cores by more than the heights of the other edge's ends over it.
      const Vec3f m = own.normal(f);
      if (std::min(m.dot(first), m.dot(second)) < needed - 4 * pair.rounding) continue;
      const SeparatingAxis face = face_axis(pair, is_of_A, f);
      if (face.separation > needed) best = face;
    }
  }
  return best;
}

/// Contacts over a face that separates the cores nearly as well as two edges do, if they are nearly as deep;
/// returns the normal. Otherwise nothing; the face that may replace the edges within the step is then
/// pair.beside.
std::optional<Vec3f> prefer_face(const SeparatingAxis& edges, float margin, PlacedPolytopes& pair) {
  // A face gives up to four points, edges give one: the face is preferred up to a tenth of the overlap and a
  // fiftieth of the smaller ball inside.
  const float gap = edges.separation - pair.a.radius - pair.b.radius;
  const float preference =
      kFacePreferenceOfOverlap * std::max(-gap, 0.0f) + kFacePreferenceOfSize * pair.thinnest;
  const SeparatingAxis face = find_face_at(edges, edges.separation - std::max(preference, margin), pair);
  if (face.kind == SeparatingAxis::Kind::none) return std::nullopt;
  // The region over the face has to explain the overlap; it does not if the cores overlap beside the face.
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
  // The axis of largest separation.
  axis = find_separating_axis(pair, margin + radii, guess);
  if (!(axis.separation <= margin + radii)) return std::nullopt;
  const bool is_apart = axis.separation > 0;
  // Two edges: a face nearly as good, or the point where they cross, or the nearest edges.
  if (axis.kind == SeparatingAxis::Kind::edges) {
    if (std::optional<Vec3f> n = prefer_face(axis, margin, pair)) return n;
    if (cross_edges(axis, pair)) return axis.n;
    return join_nearest_edges(axis.n, axis.separation, margin, pair);
  }
  // A face: the region over it, if a point of it has the separation. If none has, cores that are apart are
  // nearest at an edge or a vertex, and of cores that overlap the lowest vertex is a point.
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
