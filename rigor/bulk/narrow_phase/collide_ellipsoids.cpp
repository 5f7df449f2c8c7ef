// Ellipsoids: docs/theory/narrow_phase.md, "Ellipsoids".

#include "rigor/bulk/narrow_phase/collide_ellipsoids.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

/// What touches an ellipsoid: another one, or the line through q along `across` (a point if that is 0).
struct Opposite {
  const EllipsoidCore* ellipsoid = nullptr;
  Vec3f q = Vec3f::Zero();
  Vec3f across = Vec3f::Zero();  ///< Unit, or 0.

  bool is_line() const { return !across.isZero(0); }
  /// Its point against -n that is nearest to p.
  Vec3f point(const Vec3f& n, const Vec3f& p) const {
    if (ellipsoid != nullptr) return ellipsoid->farthest(-n);
    return q + across.dot(p - q) * across;
  }
};

/// The second derivative of how far an ellipsoid reaches, along two directions square to n: with y = Mᵀ n it
/// reaches |y|.
struct Curvature {
  float xx, xy, yy;
};
Curvature curvature_of(const EllipsoidCore& core, const Vec3f& n, const Vec3f& t1, const Vec3f& t2) {
  const Vec3f y = core.M.transpose() * n, a = core.M.transpose() * t1, b = core.M.transpose() * t2;
  const float square = y.squaredNorm(), inverse = 1 / std::sqrt(square);
  const float ya = y.dot(a), yb = y.dot(b);
  return {(a.squaredNorm() - ya * ya / square) * inverse, (a.dot(b) - ya * yb / square) * inverse,
          (b.squaredNorm() - yb * yb / square) * inverse};
}

/// A direction, and what it finds.
struct Trial {
  Vec3f n, p, q;
  float separation;

  Trial(const EllipsoidCore& own, const Opposite& other, const Vec3f& direction)
      : n(direction), p(own.farthest(direction)), q(other.point(direction, p)), separation(n.dot(q - p)) {}
};

/// Newton's method for the direction that parts an ellipsoid and what is opposite best, from n on, on the
/// sphere or, against a line, on the circle square to it. Nothing if it does not come to rest.
std::optional<Trial> part_best(const EllipsoidCore& own, const Opposite& other, Vec3f n, float rounding) {
  constexpr int most_steps = 16, most_halvings = 6;
  constexpr float least_step = 3e-7f;  // [rad].
  if (other.is_line()) n -= n.dot(other.across) * other.across;
  Trial now(own, other, n.normalized());
  const float rolls = own.rolls + (other.ellipsoid != nullptr ? other.ellipsoid->rolls : 0);
  for (int k = 0; k < most_steps; ++k) {
    // The gradient is what the two points differ by beside n.
    const Vec3f beside = now.q - now.p - now.separation * now.n;
    const float slope = beside.norm();
    if (slope <= rounding) return now;
    const Vec3f t1 = beside / slope, t2 = now.n.cross(t1);
    // The second derivative, with its sign turned; it is positive where the answer is proven.
    Curvature bend = curvature_of(own, now.n, t1, t2);
    if (other.ellipsoid != nullptr) {
      const Curvature of_other = curvature_of(*other.ellipsoid, now.n, t1, t2);
      bend = {bend.xx + of_other.xx, bend.xy + of_other.xy, bend.yy + of_other.yy};
    }
    const float rest = std::max(now.separation, -0.9f * rolls);
    bend.xx += rest;
    bend.yy += rest;
    // On the circle t1 is the only direction.
    const float determinant = bend.xx * bend.yy - bend.xy * bend.xy;
    Vec3f step = other.is_line() || !(determinant > 0)
                     ? Vec3f(slope / bend.xx * t1)
                     : Vec3f((slope * bend.yy / determinant) * t1 - (slope * bend.xy / determinant) * t2);
    const float length = step.norm();
    if (length <= least_step) return now;
    if (length > 1) step /= length;
    // No step that parts them less.
    Trial next(own, other, (now.n + step).normalized());
    for (int h = 0; h < most_halvings && next.separation < now.separation - rounding; ++h) {
      step *= 0.5f;
      next = Trial(own, other, (now.n + step).normalized());
    }
    now = next;
  }
  return std::nullopt;
}

SmoothTouch touch_of(const Trial& trial) {
  return {trial.n, trial.p, trial.separation};
}

/// Whether directions are the best of all whose two points differ along them alone: those of cores that
/// overlap by no more than the balls that roll inside have for a radius. With s < 0 the separation along n,
/// ρ that radius and m at the angle θ from n, s(m) <= s cos θ - ρ (1 - cos θ) <= s.
bool is_shallow(float separation, float rolls) {
  return separation >= -rolls;
}

/// The polytope's vertex that is lowest along n, among equal ones the first.
int lowest_vertex(const PlacedPolytope& core, const Vec3f& n) {
  return core.farthest(-n);
}

/// The face of the polytope that parts it best from the ellipsoid, or the best direction across it.
struct FaceOverEllipsoid {
  int face = -1;
  float separation = -std::numeric_limits<float>::infinity();
};
FaceOverEllipsoid find_best_face(const EllipsoidCore& own, const PlacedPolytope& other) {
  FaceOverEllipsoid best;
  for (int f = 0; f < other.hull->face_count; ++f) {
    const Vec3f m = other.normal(f);
    const float s = -own.reach(-m) - m.dot(other.place.t) - other.offsets()[f];
    if (s > best.separation) best = {f, s};
  }
  return best;
}

/// Some vertices of a polytope.
struct Corners {
  std::array<int, 3> v;
  std::size_t count;
};

/// Whether p is over the triangle of these corners, seen along its normal m.
bool is_over(const Vec3f& p, const Vec3f& m, std::span<const Vec3f> corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f &c = corners[k], &next = corners[(k + 1) % 3];
    if (m.cross(next - c).dot(p - c) < 0) return false;
  }
  return true;
}

/// The touch over a face, if the ellipsoid's point is over it.
std::optional<SmoothTouch> touch_face(const EllipsoidCore& own, const PlacedPolytope& other, int face) {
  const Vec3f m = other.normal(face), p = own.farthest(-m);
  const std::span<const int> border = other.hull->border_vertices(face);
  const Vec3f first = other.vertex(border[0]);
  for (std::size_t k = 0; k < border.size(); ++k) {
    const Vec3f c = other.vertex(border[k]), next = other.vertex(border[(k + 1) % border.size()]);
    if (m.cross(next - c).dot(p - c) < 0) return std::nullopt;
  }
  return SmoothTouch{-m, p, m.dot(p - first)};
}

/// The triangle, line or point of the corners parts best where the ellipsoid's point is over it.
std::optional<Trial> touch_simplex(const EllipsoidCore& own, std::span<const Vec3f> corners, const Vec3f& n,
                                   float rounding) {
  if (corners.size() == 1) return part_best(own, {nullptr, corners[0]}, n, rounding);
  const Vec3f along = corners[1] - corners[0];
  if (corners.size() == 2) {
    const float length = along.norm();
    if (!(length > 0)) return std::nullopt;
    const std::optional<Trial> best = part_best(own, {nullptr, corners[0], along / length}, n, rounding);
    if (!best) return std::nullopt;
    const float t = along.dot(best->q - corners[0]);
    return t >= 0 && t <= length * length ? best : std::nullopt;
  }
  // The normal of the triangle that goes on from the ellipsoid.
  const Vec3f up = along.cross(corners[2] - corners[0]);
  if (!(up.squaredNorm() > 0)) return std::nullopt;
  const Vec3f m = up.normalized(), out = m.dot(n) > 0 ? m : Vec3f(-m);
  Trial flat(own, {nullptr, corners[0]}, out);
  if (!is_over(flat.p, m, corners)) return std::nullopt;
  flat.q = flat.p + flat.separation * out;
  return flat;
}

/// The best direction against the hull of some corners: that of a part of it along which no other corner is
/// lower. The corners become those of that part.
std::optional<Trial> touch_corners(const EllipsoidCore& own, const PlacedPolytope& other, const Vec3f& n,
                                   float rounding, Corners& corners) {
  // Subsets as bits, the largest ones first.
  constexpr std::array<unsigned, 7> subsets = {7, 3, 5, 6, 1, 2, 4};
  for (const unsigned subset : subsets) {
    if (subset >> corners.count != 0) continue;
    Corners part{{}, 0};
    std::array<Vec3f, 3> points;
    for (std::size_t k = 0; k < corners.count; ++k) {
      if ((subset >> k & 1) == 0) continue;
      points[part.count] = other.vertex(corners.v[k]);
      part.v[part.count++] = corners.v[k];
    }
    std::optional<Trial> trial = touch_simplex(own, std::span(points).first(part.count), n, rounding);
    if (!trial) continue;
    bool is_lowest = true;
    for (std::size_t k = 0; k < corners.count; ++k)
      is_lowest &= trial->n.dot(other.vertex(corners.v[k]) - trial->q) >= -4 * rounding;
    if (!is_lowest) continue;
    corners = part;
    return trial;
  }
  return std::nullopt;
}

/// The search among faces, edges and vertices, as that of Gilbert, Johnson and Keerthi: the best direction
/// against some corners is the best of all if no other vertex is lower along it; else that one joins them.
std::optional<SmoothTouch> search_corners(const EllipsoidCore& own, const PlacedPolytope& other, Vec3f n,
                                          float limit, float rounding) {
  constexpr int most_rounds = 12;
  Corners corners{{lowest_vertex(other, n)}, 1};
  for (int k = 0; k < most_rounds; ++k) {
    const std::optional<Trial> trial = touch_corners(own, other, n, rounding, corners);
    if (!trial) return std::nullopt;
    n = trial->n;
    const int lowest = lowest_vertex(other, n);
    const Vec3f w = other.vertex(lowest);
    if (n.dot(trial->q - w) <= 4 * rounding) return touch_of(*trial);
    const float parted = n.dot(w) - own.reach(n);
    if (parted > limit + parting_slack(rounding)) return SmoothTouch{n, own.center, parted};
    if (corners.count == 3) return std::nullopt;
    corners.v[corners.count++] = lowest;
  }
  return std::nullopt;
}

}  // namespace

Vec3f EllipsoidCore::farthest(const Vec3f& n) const {
  const Vec3f y = M.transpose() * n;
  return center + M * (y / y.norm());
}

EllipsoidCore place_ellipsoid(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB) {
  const float least = shape.scale.minCoeff(), most = shape.scale.maxCoeff();
  return {placed.rotation() * shape.scale.asDiagonal(), p_OB + placed.position(), most, least,
          least * least / most};
}

std::optional<SmoothTouch> touch_ellipsoids(const EllipsoidCore& a, const EllipsoidCore& b, float limit) {
  const Vec3f d = b.center - a.center;
  const float rounding = kCollisionRounding * (a.extent + b.extent + d.norm());
  // Where two balls are scaled alike the normal is (A + B)⁻¹ d, A and B being M Mᵀ: a first guess.
  const Mat3f both = a.M * a.M.transpose() + b.M * b.M.transpose();
  const Vec3f guess = both.inverse() * d;
  if (!(guess.squaredNorm() > 0)) return std::nullopt;
  const std::optional<Trial> best = part_best(a, {&b}, guess.normalized(), rounding);
  if (!best || !(best->separation > limit || is_shallow(best->separation, a.rolls + b.rolls)))
    return std::nullopt;
  return touch_of(*best);
}

std::optional<SmoothTouch> touch_point_near(const EllipsoidCore& own, const Vec3f& q, const Vec3f& guess) {
  const float rounding = kCollisionRounding * (own.extent + (q - own.center).norm());
  const std::optional<Trial> best = part_best(own, {nullptr, q}, guess, rounding);
  if (!best) return std::nullopt;
  return touch_of(*best);
}

std::optional<SmoothTouch> touch_polytope(const EllipsoidCore& own, const PlacedPolytope& other,
                                          float limit) {
  const float rounding =
      kCollisionRounding * (own.extent + other.extent + (own.center - other.place.t).norm());
  const FaceOverEllipsoid face = find_best_face(own, other);
  std::optional<SmoothTouch> touch;
  Vec3f n;
  if (face.face >= 0) {
    n = -other.normal(face.face);
    if (face.separation > limit + parting_slack(rounding)) return SmoothTouch{n, own.center, face.separation};
    touch = touch_face(own, other, face.face);
  } else {
    // Against a point the first guess is the normal of the ellipsoid through it that is like this one.
    const Mat3f square = own.M * own.M.transpose();
    n = square.inverse() * (other.place.t - own.center);
    if (!(n.squaredNorm() > 0)) return std::nullopt;
    n.normalize();
  }
  if (!touch) touch = search_corners(own, other, n, limit, rounding);
  if (!touch || !(touch->separation > limit || is_shallow(touch->separation, own.rolls))) return std::nullopt;
  return touch;
}

}  // namespace rigor
