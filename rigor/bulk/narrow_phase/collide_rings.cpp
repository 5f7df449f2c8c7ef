#include "rigor/bulk/narrow_phase/collide_rings.hpp"

#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

using Outcome = RingContacts::Outcome;

/// Names of a ring's points: four on each circle, and the point of a circle that reaches farthest.
constexpr int kLowestName = 8;
/// Caps and sides are shown to what is less than 45 degrees off.
constexpr float kFacing = 0.70710678f;

/// The lengths that decide in a pair.
struct PairLengths {
  float rounding, thinnest, radii;

  /// What a flat side may part two shapes worse than something else does: it has more points.
  float preference(float gap) const {
    return kFacePreferenceOfOverlap * std::max(-gap, 0.0f) + kFacePreferenceOfSize * thinnest;
  }
  /// Points that are farther beside each other do not touch: such a direction parts no best.
  float most_beside() const { return 2e-3f * thinnest + 4 * rounding; }
};

/// A direction from A to B, and by what it parts the cores.
struct PartingAxis {
  Vec3f n = Vec3f::UnitZ();
  float separation = -std::numeric_limits<float>::infinity();
};

/// Whether no direction parts two cores by more than the axis does: points of the difference of the cores
/// fill a disc of the radius `foot` about the axis, and no direction parts the balls inside by more than
/// their distance (docs/theory/narrow_phase.md, "An axis that proves itself").
bool is_proven(const PartingAxis& axis, float foot, const Vec3f& between, float balls) {
  if (!(foot > 0)) return false;
  const float s = axis.separation;
  if (s >= 0) return true;
  // Beyond the angle θ, tan(θ/2) = foot / |s|, the balls decide.
  const float tangent = foot / -s, scale = 1 / (1 + tangent * tangent);
  const float cosine = (1 - tangent * tangent) * scale, sine = 2 * tangent * scale;
  const float along = axis.n.dot(between), across = (between - along * axis.n).norm();
  const bool is_within = along * sine > across * cosine;
  return is_within && along * cosine + across * sine - balls <= s;
}

/// How far a point is inside the border of a flat side, seen along n.
float inside_of(const ShownSide& side, const Vec3f& n, const Vec3f& p) {
  const auto flat = [&](const Vec3f& q) { return Vec3f(q - n.dot(q) * n); };
  if (side.kind == ShownSide::Kind::disc) return side.r - flat(p - side.center).norm();
  const Vec3f up = side.m.dot(n) > 0 ? n : Vec3f(-n);
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < side.corners.size(); ++k) {
    const Vec3f q = side.corner(k), inward = up.cross(side.corner((k + 1) % side.corners.size()) - q);
    least = std::min(least, inward.dot(p - q) / inward.norm());
  }
  return least;
}

RingPairNumbers numbers_of(const RingCore& a, const RingCore& b) {
  const Vec3f d = b.center - a.center;
  return {a.numbers, b.numbers, {d.x(), d.y(), d.z()}};
}

PartingAxis axis_at(const RingAxes& axes, int group, int lane) {
  return {Vec3f(axes.n[group][0][lane], axes.n[group][1][lane], axes.n[group][2][lane]),
          axes.separation[group][lane]};
}

/// The best cap: of A, unless one of B is better by more than the rounding.
struct BestCap {
  PartingAxis axis;
  bool is_of_A = true;
};
BestCap find_best_cap(const RingAxes& axes, const RingCore& a, const RingCore& b, float rounding) {
  // A direction up the axis of A is the normal of its upper cap; up that of B, of its lower cap.
  const bool has_cap[RingAxes::pole_count] = {a.numbers.r[1] > 0, a.numbers.r[0] > 0, b.numbers.r[0] > 0,
                                              b.numbers.r[1] > 0};
  BestCap best;
  for (int k = 0; k < RingAxes::pole_count; ++k) {
    const float worth = axes.separation[RingAxes::flat][k] - (k < 2 ? 0 : rounding);
    if (has_cap[k] && worth > best.axis.separation) best = {axis_at(axes, RingAxes::flat, k), k < 2};
  }
  return best;
}

PartingAxis find_best_axis(const RingAxes& axes, int groups) {
  int group = 0, lane = 0;
  for (int g = 0; g < groups; ++g)
    for (int k = 0; k < kLaneCount; ++k)
      if (axes.separation[g][k] > axes.separation[group][lane]) group = g, lane = k;
  return axis_at(axes, group, lane);
}

/// Whether the best of the flat directions is the best of all.
bool flat_is_best(const RingCore& a, const RingCore& b, const PartingAxis& best, const BestCap& cap) {
  const Vec3f ball_A = a.ball_near(b.center), ball_B = b.ball_near(ball_A), between = ball_B - ball_A;
  const float balls = a.inner + b.inner;
  if (best.separation <= cap.axis.separation) {
    const ShownSide of_A = a.shown_side(best.n, cap.is_of_A), of_B = b.shown_side(-best.n, !cap.is_of_A);
    const ShownSide &flat = cap.is_of_A ? of_A : of_B, &other = cap.is_of_A ? of_B : of_A;
    return flat.kind == ShownSide::Kind::disc &&
           is_proven(best, inside_of(flat, best.n, other.lowest), between, balls);
  }
  // Two straight lines that cross fill a parallelogram.
  const ShownSide of_A = a.shown_side(best.n, false), of_B = b.shown_side(-best.n, false);
  if (!of_A.is_straight || !of_B.is_straight) return false;
  const Vec3f u = of_A.ends[1] - of_A.ends[0], v = of_B.ends[1] - of_B.ends[0];
  const SegmentPoints at = nearest_on_segments(of_A.ends[0], u, of_B.ends[0] - best.separation * best.n, v);
  const float area = best.n.dot(u.cross(v));
  const float foot = std::min(std::min(at.s, 1 - at.s) * std::abs(area) / v.norm(),
                              std::min(at.t, 1 - at.t) * std::abs(area) / u.norm());
  return is_proven(best, foot, between, balls);
}

/// Whether the best direction is the best of all, where it is of the straight line on one side and a circle:
/// the line and an arc of the circle decide as a foot does (docs/theory/narrow_phase.md, "Rings").
bool side_and_ring_are_best(const RingCore& a, const RingCore& b, const PartingAxis& best, float rounding) {
  const ShownSide of_A = a.shown_side(best.n, false), of_B = b.shown_side(-best.n, false);
  if (of_A.is_straight == of_B.is_straight) return false;
  const bool line_is_of_A = of_A.is_straight;
  const ShownSide &line = line_is_of_A ? of_A : of_B, &other = line_is_of_A ? of_B : of_A;
  const RingCore& ring = line_is_of_A ? b : a;
  const auto flat = [&](const Vec3f& p) { return Vec3f(p - best.n.dot(p) * best.n); };
  // The lowest point of the circle over the line.
  const Vec3f u = line.ends[1] - line.ends[0], w = other.lowest - line.ends[0];
  const float square = u.squaredNorm(), t = u.dot(w) / square;
  if (!(t > 0 && t < 1)) return false;
  const float beside = flat(w - t * u).squaredNorm(), s = best.separation;
  if (s >= 0 && beside <= 2 * rounding * s) return true;
  // The circle's tangent there makes an angle of the sine k with the line.
  const Vec3f out = other.lowest - ring.center, tangent = ring.axis.cross(out);
  const float r = tangent.norm(), kk = u.cross(tangent).squaredNorm() / (square * r * r);
  const float deep = std::max(-s, 0.0f) + 2 * std::sqrt(beside);
  const float arc = r * kk, end = std::min(t, 1 - t) * std::sqrt(square * kk);
  if (!(arc > 10 * deep && end > 4 * deep && beside <= rounding * (0.1f * arc - deep))) return false;
  // They decide up to this angle, beyond it the balls.
  const bool is_shallow = arc > 65 * deep && end > 15 * deep;
  const float cosine = is_shallow ? -0.8660254f : 0.0f, sine = is_shallow ? 0.5f : 1.0f;
  const Vec3f ball_A = a.ball_near(b.center), between = b.ball_near(ball_A) - ball_A;
  const float along = best.n.dot(between), across = (between - along * best.n).norm();
  return along * sine > across * cosine && along * cosine + across * sine - a.inner - b.inner <= s;
}

/// The points over a cap, if one is as deep as `most`.
bool add_cap(const RingCore& a, const RingCore& b, const PartingAxis& axis, float most,
             const RegionScale& scale, std::vector<ManifoldCandidate>& candidates) {
  const RegionResult result =
      find_region(a.shown_side(axis.n, true), b.shown_side(-axis.n, true), axis.n, scale, candidates);
  if (result.least <= most) return true;
  candidates.clear();
  return false;
}

}  // namespace

float RingCore::reach(const Vec3f& n) const {
  const float along = n.dot(axis), across = n.cross(axis).norm();
  return n.dot(center) +
         std::max(numbers.z[0] * along + numbers.r[0] * across, numbers.z[1] * along + numbers.r[1] * across);
}

RingCore::Beside RingCore::beside(const Vec3f& n) const {
  const float along = n.dot(axis);
  const Vec3f rough = n - along * axis;
  // Made square twice: of what is nearly along the axis little but rounding is left.
  const Vec3f across = rough - rough.dot(axis) * axis;
  const float length = across.norm();
  return {along, length, length > 1e-6f ? Vec3f(across / length) : x};
}

Vec3f RingCore::farthest(const Vec3f& n) const {
  const auto [along, across, u] = beside(n);
  const bool is_upper =
      numbers.z[1] * along + numbers.r[1] * across > numbers.z[0] * along + numbers.r[0] * across;
  const std::size_t i = is_upper ? 1 : 0;
  return center + numbers.z[i] * axis + numbers.r[i] * u;
}

ShownSide RingCore::shown_side(const Vec3f& m, bool with_cap) const {
  constexpr float straight = 1e-4f;  // Rounding of directions, and some room.
  constexpr float least_tilt = 1e-4f;
  ShownSide side;
  const Beside place = beside(m);
  const float along = place.along, across = place.across;
  const Vec3f& u = place.u;
  const auto on_ring = [&](int i) { return Vec3f(center + numbers.z[i] * axis + numbers.r[i] * u); };
  // The circle that reaches farther has the lowest point.
  const int i = numbers.z[1] * along + numbers.r[1] * across > numbers.z[0] * along + numbers.r[0] * across;
  side.lowest = on_ring(i);
  side.lowest_name = kLowestName + i;
  // A cap, on which the lowest point counts if there is one.
  const bool is_up = along > 0;
  const float cap = numbers.r[is_up ? 1 : 0];
  if (with_cap && std::abs(along) > kFacing && cap > 0) {
    side.kind = ShownSide::Kind::disc;
    side.m = is_up ? axis : Vec3f(-axis);
    side.center = center + numbers.z[is_up ? 1 : 0] * axis;
    side.r = cap;
    side.radii[0] = cap * x;
    side.radii[1] = cap * y;
    side.first_name = is_up ? 4 : 0;
    if (across < least_tilt) side.lowest_name = -1;
    return side;
  }
  // The straight line on the side.
  if (numbers.z[1] > numbers.z[0] && std::abs(along - numbers.k) < kFacing) {
    side.kind = ShownSide::Kind::segment;
    side.is_straight = std::abs(along - numbers.k) < straight;
    for (const int k : {0, 1}) side.ends[k] = on_ring(k), side.end_names[k] = kLowestName + k;
    side.m = axis;
    side.center = center + numbers.z[0] * axis;
  }
  return side;
}

Vec3f RingCore::ball_near(const Vec3f& p) const {
  // The centres of the balls inside fill a cylinder; the nearest of them to p.
  const Vec3f middle = center + ball * axis, to = p - middle;
  const float along = to.dot(axis);
  const Vec3f across = to - along * axis;
  const float length = across.norm();
  const Vec3f moved = length > ball_across ? Vec3f(ball_across / length * across) : across;
  return middle + std::clamp(along, -ball_shift, ball_shift) * axis + moved;
}

RingCore place_ring(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB) {
  const Mat3f R = placed.rotation();
  RingCore core;
  core.x = R.col(0);
  core.y = R.col(1);
  core.axis = R.col(2);
  core.center = p_OB + placed.position();
  core.radius = shape.radius;
  core.extent = shape.extent;
  core.inner = shape.rings.inner;
  core.ball = shape.rings.ball;
  core.ball_shift = shape.rings.ball_shift;
  core.ball_across = shape.rings.ball_across;
  RingNumbers& numbers = core.numbers;
  for (int k = 0; k < 3; ++k) numbers.axis[k] = core.axis[k];
  for (int k = 0; k < 2; ++k) numbers.z[k] = shape.rings.z[k], numbers.r[k] = shape.rings.r[k];
  numbers.k = shape.rings.k;
  numbers.square = shape.rings.square;
  return core;
}

Outcome collide_rings(const RingCore& a, const RingCore& b, float margin, RingContacts& contacts) {
  contacts.candidates.clear();
  contacts.beside.clear();
  const Vec3f d = b.center - a.center;
  const PairLengths lengths{kCollisionRounding * (a.extent + b.extent + d.norm()),
                            std::min(a.inner + a.radius, b.inner + b.radius), a.radius + b.radius};
  const RegionScale scale{4 * lengths.rounding, margin, a.radius, b.radius};
  contacts.equal_depth = lengths.rounding + kEqualDepthOfSize * lengths.thinnest;

  // The axis of largest separation.
  const RingPairNumbers pair = numbers_of(a, b);
  RingAxes axes;
  find_flat_ring_axes(pair, best_lane_target(), axes);
  PartingAxis best = find_best_axis(axes, 1);
  const BestCap cap = find_best_cap(axes, a, b, lengths.rounding);
  const float limit = margin + lengths.radii;
  if (!(best.separation > limit) && !flat_is_best(a, b, best, cap)) {
    find_side_ring_axes(pair, best_lane_target(), axes);
    best = find_best_axis(axes, RingAxes::side_and_ring + 1);
    if (!(best.separation > limit) && !side_and_ring_are_best(a, b, best, lengths.rounding)) {
      find_two_ring_axes(pair, best_lane_target(), axes);
      best = find_best_axis(axes, RingAxes::group_count);
    }
  }
  contacts.n = best.n;
  const float gap = best.separation - lengths.radii;
  if (gap > margin) return Outcome::apart;

  // A cap that parts them nearly as well.
  const float preference = lengths.preference(gap);
  if (cap.axis.separation >= best.separation - preference &&
      add_cap(a, b, cap.axis, gap + preference + 4 * lengths.rounding, scale, contacts.candidates)) {
    contacts.n = cap.axis.n;
    return Outcome::touching;
  }
  // Else one or two points; and the cap beside them, onto which they may rotate within the step.
  const RegionResult result = find_region(a.shown_side(best.n, false), b.shown_side(-best.n, false), best.n,
                                          scale, contacts.candidates);
  if (result.beside > lengths.most_beside()) return Outcome::unclear;
  if (cap.axis.separation >= best.separation - margin) {
    contacts.beside_n = cap.axis.n;
    find_region(a.shown_side(cap.axis.n, true), b.shown_side(-cap.axis.n, true), cap.axis.n, scale,
                contacts.beside);
  }
  return Outcome::touching;
}

namespace {

/// The best face of a polytope over a ring.
struct FaceOverRing {
  PartingAxis axis;  ///< Outward of the polytope.
  int face = -1;
};
FaceOverRing find_best_face(const RingCore& ring, const PlacedPolytope& polytope) {
  FaceOverRing best;
  // The ring's farthest point against the face decides, in closed form.
  for (int f = 0; f < polytope.hull->face_count; ++f) {
    const Vec3f m = polytope.normal(f);
    const float s = -ring.reach(-m) - m.dot(polytope.place.t) - polytope.offsets()[f];
    if (s > best.axis.separation) best = {{m, s}, f};
  }
  return best;
}

ShownSide face_side(const PlacedPolytope& polytope, int face) {
  ShownSide side;
  side.kind = ShownSide::Kind::polygon;
  side.m = polytope.normal(face);
  side.points = polytope.vertices();
  side.corners = polytope.hull->border_vertices(face);
  side.edges = polytope.hull->border_edges(face);
  return side;
}

/// The best cap of a ring under a polytope; the vertex that is lowest over it.
struct CapUnderPolytope {
  PartingAxis axis;  ///< Outward of the ring.
  int lowest = -1;
};
CapUnderPolytope find_best_cap(const RingCore& ring, const PlacedPolytope& polytope) {
  CapUnderPolytope best;
  for (const int end : {0, 1}) {
    if (!(ring.numbers.r[end] > 0)) continue;
    const Vec3f o = end == 1 ? ring.axis : Vec3f(-ring.axis);
    const int lowest = polytope.farthest(-o);
    const float s = o.dot(polytope.vertex(lowest)) - ring.reach(o);
    if (s > best.axis.separation) best = {{o, s}, lowest};
  }
  return best;
}

}  // namespace

Outcome collide_ring_with_polytope(const RingCore& ring, const PlacedPolytope& polytope, bool ring_is_A,
                                   float margin, RingContacts& contacts) {
  contacts.candidates.clear();
  contacts.beside.clear();
  const float rounding =
      kCollisionRounding * (ring.extent + polytope.extent + (ring.center - polytope.place.t).norm());
  const PairLengths lengths{rounding, std::min(ring.inner, polytope.inner), 0};
  const RegionScale scale{4 * rounding, margin, 0, 0};
  contacts.equal_depth = rounding + kEqualDepthOfSize * lengths.thinnest;

  // The best face of the polytope, and the best cap of the ring; all from the ring to the polytope.
  const FaceOverRing face = find_best_face(ring, polytope);
  const CapUnderPolytope cap = find_best_cap(ring, polytope);
  const bool is_cap = cap.axis.separation > face.axis.separation + rounding;
  const PartingAxis best = is_cap ? cap.axis : PartingAxis{-face.axis.n, face.axis.separation};
  const Vec3f n = ring_is_A ? best.n : Vec3f(-best.n);
  contacts.n = n;
  if (best.separation > margin) return Outcome::apart;

  // It is the best of all if it proves itself.
  const int facing = is_cap ? polytope.face_against(cap.lowest, best.n) : face.face;
  const ShownSide of_ring = ring.shown_side(best.n, true), of_polytope = face_side(polytope, facing);
  const Vec3f foot = is_cap ? polytope.vertex(cap.lowest) : of_ring.lowest;
  const ShownSide& flat = is_cap ? of_ring : of_polytope;
  if (flat.kind == ShownSide::Kind::segment || flat.kind == ShownSide::Kind::point) return Outcome::unclear;
  const Vec3f ball = ring.ball_near(polytope.center);
  if (!is_proven(best, inside_of(flat, best.n, foot), polytope.center - ball, ring.inner + polytope.inner))
    return Outcome::unclear;
  const RegionResult result = find_region(ring_is_A ? of_ring : of_polytope,
                                          ring_is_A ? of_polytope : of_ring, n, scale, contacts.candidates);
  const float most = best.separation + lengths.preference(best.separation);
  return result.least <= most ? Outcome::touching : Outcome::unclear;
}

void find_ring_on_plane(const RingCore& ring, const Vec3f& n, float height, float margin,
                        std::vector<ManifoldCandidate>& candidates) {
  const ShownSide side = ring.shown_side(-n, true);
  const auto add = [&](const Vec3f& p, int name) {
    const float gap = n.dot(p) + height - ring.radius;
    if (gap > margin) return;
    candidates.push_back({p - (0.5f * gap + ring.radius) * n, gap, static_cast<std::uint32_t>(name)});
  };
  for (std::size_t k = 0; k < side.corner_count(); ++k) add(side.corner(k), side.corner_name(k));
}

}  // namespace rigor
