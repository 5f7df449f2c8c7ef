#include "rigor/bulk/narrow_phase/smooth_core.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr float kEndless = std::numeric_limits<float>::infinity();

/// Where a point is in the half-plane that an axis bounds and the point is in.
struct BesideAxis {
  float z, rho;  ///< Along the axis from the solid's origin, and away from it [m].
  Vec3f away;    ///< Unit, across the axis.
};
BesideAxis beside_axis(const RingCore& ring, const Vec3f& q) {
  const Vec3f to = q - ring.center;
  const float z = ring.axis.dot(to);
  const Vec3f across = to - z * ring.axis;
  const float rho = across.norm();
  return {z, rho, rho > 0 ? Vec3f(across / rho) : ring.x};
}

/// The signed distance of a point from a solid of revolution, in closed form: that from a trapezium in the
/// half-plane of the point.
PartingTouch touch_ring(const RingCore& ring, const Vec3f& q) {
  const RingNumbers& own = ring.numbers;
  const BesideAxis at = beside_axis(ring, q);
  const auto touch_along = [&](float along, float across, float separation) {
    const Vec3f out = along * ring.axis + across * at.away;
    return PartingTouch{-out, q - separation * out, separation};
  };
  // Heights over the lines of both caps and of the side.
  const float below = own.z[0] - at.z, above = at.z - own.z[1];
  const float beside = own.square * (at.rho - own.r[0]) + own.k * (at.z - own.z[0]);
  if (below <= 0 && above <= 0 && beside <= 0) {
    PartingTouch best = touch_along(own.k, own.square, beside);
    if (own.r[0] > 0 && below > best.separation) best = touch_along(-1, 0, below);
    if (own.r[1] > 0 && above > best.separation) best = touch_along(1, 0, above);
    return best;
  }
  // Outside: over a cap, over the side, or nearest to one of its circles.
  if (below > 0 && at.rho <= own.r[0]) return touch_along(-1, 0, below);
  if (above > 0 && at.rho <= own.r[1]) return touch_along(1, 0, above);
  const float slant = own.square * (at.z - own.z[0]) - own.k * (at.rho - own.r[0]);
  const float length = own.square * (own.z[1] - own.z[0]) - own.k * (own.r[1] - own.r[0]);
  if (slant > 0 && slant < length) return touch_along(own.k, own.square, beside);
  const std::size_t i = slant > 0 ? 1 : 0;
  const float up = at.z - own.z[i], out = at.rho - own.r[i], distance = std::sqrt(up * up + out * out);
  if (!(distance > 0)) return touch_along(own.k, own.square, 0);
  return touch_along(up / distance, out / distance, distance);
}

/// The point of a triangle that is nearest to the origin.
Vec3f nearest_to_origin(const std::array<Vec3f, 3>& corners) {
  // Over the face.
  const Vec3f up = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool is_over = up.squaredNorm() > 0;
  for (std::size_t k = 0; k < 3; ++k)
    is_over &= up.cross(corners[(k + 1) % 3] - corners[k]).dot(-corners[k]) >= 0;
  if (is_over) return (up.dot(corners[0]) / up.squaredNorm()) * up;
  // Or on one of the sides.
  Vec3f nearest = corners[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f side = corners[(k + 1) % 3] - corners[k];
    const float square = side.squaredNorm();
    const float t = square > 0 ? std::clamp(-side.dot(corners[k]) / square, 0.0f, 1.0f) : 0;
    const Vec3f p = corners[k] + t * side;
    if (p.squaredNorm() < nearest.squaredNorm()) nearest = p;
  }
  return nearest;
}

/// A direction of an arc, what it parts the core from the edge by, and the derivative of that by the angle.
struct ArcTrial {
  PartingTouch touch;
  float slope;
};

/// The directions of an arc, and what they find.
struct ArcSearch {
  const SmoothCore& core;
  const NormalArc& arc;
  Vec3f about;  ///< Unit, along the edge: about it directions turn from the first to the last.

  ArcTrial with_point(const Vec3f& n, const Vec3f& p) const {
    const Vec3f w = p - arc.from;
    return {{n, p, n.dot(w)}, about.cross(n).dot(w)};
  }
  ArcTrial at(const Vec3f& n) const { return with_point(n, core.farthest(-n)); }
  bool is_between(const Vec3f& a, const Vec3f& n, const Vec3f& b) const {
    return about.dot(a.cross(n)) > 0 && about.dot(n.cross(b)) > 0;
  }
};

/// Directions along an arc, none of them farther from the next than 0.4 rad, the ends included.
struct ArcDirections {
  std::array<Vec3f, 17> n;
  std::size_t count;

  explicit ArcDirections(const NormalArc& arc) {
    constexpr float most_chord = 0.4f;
    n[0] = arc.first;
    count = 1;
    // More than a right angle goes by the direction outward of the first face.
    const auto add_way = [&](const Vec3f& to) {
      const Vec3f start = n[count - 1];
      std::size_t parts = 1;
      for (float chord = (to - start).norm(); chord > most_chord && parts < 8; chord *= 0.5f) parts *= 2;
      for (std::size_t k = 1; k < parts; ++k) {
        const float w = static_cast<float>(k) / static_cast<float>(parts);
        n[count++] = ((1 - w) * start + w * to).normalized();
      }
      n[count++] = to;
    };
    if (arc.first.dot(arc.last) < 0) add_way(arc.outward);
    add_way(arc.last);
  }
};

/// Between two directions: the straight side of a solid of revolution lies along the plane across some
/// direction, where its point jumps from one circle to the other. If the best direction is that, its touch;
/// else the part of the arc beyond is cut off.
std::optional<PartingTouch> touch_with_side(const ArcSearch& search, const RingCore& ring, ArcTrial& low,
                                            ArcTrial& high) {
  const RingNumbers& own = ring.numbers;
  const Vec3f across = ring.axis - search.about.dot(ring.axis) * search.about;
  const float square = across.squaredNorm(), rest = square - own.k * own.k;
  if (!(own.z[1] > own.z[0]) || !(rest > 0)) return std::nullopt;
  for (const float sign : {1.0f, -1.0f}) {
    // n · axis = -k.
    const Vec3f n = ((-own.k) * across + sign * std::sqrt(rest) * search.about.cross(across)).normalized();
    if (!search.is_between(low.touch.n, n, high.touch.n)) continue;
    const Vec3f beside = -n - (-n).dot(ring.axis) * ring.axis;
    const Vec3f away = beside.normalized();
    std::array<ArcTrial, 2> ends;
    for (std::size_t i = 0; i < 2; ++i)
      ends[i] = search.with_point(n, ring.center + own.z[i] * ring.axis + own.r[i] * away);
    // The line crosses the edge where the derivative is 0.
    if (ends[0].slope * ends[1].slope <= 0) {
      const float sum = std::abs(ends[0].slope) + std::abs(ends[1].slope);
      const float t = sum > 0 ? std::abs(ends[0].slope) / sum : 0.5f;
      return search.with_point(n, ends[0].touch.p + t * (ends[1].touch.p - ends[0].touch.p)).touch;
    }
    (ends[0].slope > 0 ? low : high) = ends[0];
  }
  return std::nullopt;
}

}  // namespace

void SmoothCore::place(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_O) {
  if (shape.kind == BulkShape::Kind::rings) {
    core_ = place_ring(shape, placed, p_O);
  } else {
    core_ = place_ellipsoid(shape, placed, p_O);
  }
}

Vec3f SmoothCore::middle() const {
  const RingCore* const own = ring();
  return own != nullptr ? Vec3f(own->center + own->ball * own->axis) : std::get<EllipsoidCore>(core_).center;
}

float SmoothCore::inner_radius() const {
  const RingCore* const own = ring();
  return own != nullptr ? own->inner : std::get<EllipsoidCore>(core_).inner;
}

Vec3f SmoothCore::farthest(const Vec3f& n) const {
  const RingCore* const own = ring();
  return own != nullptr ? own->farthest(n) : std::get<EllipsoidCore>(core_).farthest(n);
}

std::optional<PartingTouch> SmoothCore::touch_point(const Vec3f& q, const Vec3f& guess) const {
  if (const RingCore* const own = ring()) return touch_ring(*own, q);
  const std::optional<SmoothTouch> touch = touch_point_near(std::get<EllipsoidCore>(core_), q, Vec3f(-guess));
  if (!touch) return std::nullopt;
  return PartingTouch{-touch->n, touch->p, touch->separation};
}

float SmoothCore::separation_from(const Vec3f (&corners)[3], const Vec3f& q) const {
  if (const RingCore* const own = ring()) {
    const auto separation = [&](const Vec3f& m) {
      return std::min({m.dot(corners[0]), m.dot(corners[1]), m.dot(corners[2])}) - own->reach(m);
    };
    const BesideAxis at = beside_axis(*own, q);
    const Vec3f side = own->numbers.k * own->axis + own->numbers.square * at.away;
    return std::max({separation(own->axis), separation(-own->axis), separation(side)});
  }
  // In coordinates in which the ellipsoid is a ball of radius 1 the plane across the nearest point decides.
  const EllipsoidCore& own = std::get<EllipsoidCore>(core_);
  const Mat3f inverse = own.M.inverse();
  std::array<Vec3f, 3> scaled;
  for (std::size_t k = 0; k < 3; ++k) scaled[k] = inverse * (corners[k] - own.center);
  const Vec3f nearest = nearest_to_origin(scaled);
  const float distance = nearest.norm();
  if (!(distance > 0)) return -kEndless;
  return (distance - 1) * distance / (inverse.transpose() * nearest).norm();
}

std::optional<PartingTouch> part_best_about_edge(const SmoothCore& core, const NormalArc& arc,
                                                 float rounding) {
  constexpr int most_steps = 30;
  constexpr float least_arc = 1e-7f;  // [rad].
  const ArcSearch search{core, arc, arc.first.cross(arc.outward)};
  // The best of a few directions, and the part of the arc around it in which a better one is.
  const ArcDirections directions(arc);
  std::array<ArcTrial, 17> trials;
  std::size_t best = 0;
  for (std::size_t k = 0; k < directions.count; ++k) {
    trials[k] = search.at(directions.n[k]);
    if (trials[k].touch.separation > trials[best].touch.separation) best = k;
  }
  const bool is_after = trials[best].slope > 0;
  if (is_after ? best + 1 == directions.count : best == 0) return std::nullopt;
  ArcTrial low = trials[is_after ? best : best - 1], high = trials[is_after ? best + 1 : best];
  if (const RingCore* const ring = core.ring()) {
    if (const std::optional<PartingTouch> touch = touch_with_side(search, *ring, low, high)) return touch;
  }
  // Where the derivative falls from positive to negative: regula falsi in the form of Illinois, which halves
  // the slope at an end that stays twice, so that both ends move. Deep ones may have several such places;
  // then the arc is halved until it falls.
  float slope_low = low.slope, slope_high = high.slope;
  int moved = 0;
  ArcTrial now = is_after ? low : high;
  for (int step = 0; step < most_steps && (high.touch.n - low.touch.n).norm() > least_arc; ++step) {
    const bool is_falling = low.slope > 0 && high.slope < 0;
    const float w = is_falling ? std::clamp(slope_low / (slope_low - slope_high), 0.02f, 0.98f) : 0.5f;
    now = search.at(((1 - w) * low.touch.n + w * high.touch.n).normalized());
    if (std::abs(now.slope) <= rounding) break;
    const bool is_low = now.slope > 0 && (is_falling || now.touch.separation >= low.touch.separation);
    (is_low ? low : high) = now;
    (is_low ? slope_low : slope_high) = now.slope;
    if (moved == (is_low ? 1 : -1)) (is_low ? slope_high : slope_low) *= 0.5f;
    moved = is_low ? 1 : -1;
  }
  return now.touch;
}

}  // namespace rigor
