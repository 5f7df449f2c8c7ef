#include "rigor/geometry/convex/tilted_penetration.hpp"

#include "rigor/geometry/convex/level_face.hpp"
#include "rigor/geometry/convex/revolution_profile.hpp"
#include "rigor/math/roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace rigor {
namespace {

/// Largest gap of the bounds, relative to the smaller extent: as for other curved shapes.
constexpr double kGap = 1e-6;
/// Axes that differ by more are left to the polytope: what planes through the axis of A leave out of B's
/// circles grows with the square of the tilt [rad].
constexpr double kMostTilt = 5e-3;
/// Axes that differ by less are parallel to rounding.
constexpr double kLeastTilt = 1e-12;

constexpr double kPi = std::numbers::pi;

/// The difference D = B - A of two solids of revolution in the frame of A, whose axis is z. For a unit vector
/// m its support value h(m) is the depth along -m.
class TiltedPair {
 public:
  explicit TiltedPair(const CorePair& pair)
      : pair_(pair),
        sign_(pair.X_AB.R(2, 2) > 0 ? 1 : -1),
        axis_(sign_ * pair.X_AB.R.col(2)),
        sine_(axis_.head<2>().norm()),
        towards_(sine_ > 0 ? Vec2(axis_.head<2>() / sine_) : Vec2(Vec2::UnitX())),
        p_(pair.X_AB.p),
        of_A_(profile(pair.a, -1)),
        of_B_(profile(pair.b, sign_)) {
    const double all = pair.a.extent + pair.b.extent + p_.norm();
    by_tilt_ = 2 * all * sine_;
    by_shortening_ = all * sine_ * sine_;
    add_side_normals(of_A_, sides_of_A_);
    add_side_normals(of_B_, sides_of_B_);
  }

  double sine() const { return sine_; }
  const Vec3& axis() const { return axis_; }

  double height(const Vec3& m) const { return m.dot(pair_.lowest(-m).w); }

  /// The lowest that h is within `reach` [rad] of one end of the axis of A (end = ±1), or lower. With the
  /// rings (r, z) that carry there, v = z_A a + z_B b + p, and θ, θ' the angles of m from both axes,
  ///   h ≥ r_A sin θ + r_B sin θ' + v·m ≥ r sin α + v·c cos θ_c + (R - r - |v × c|) sin θ_c,
  /// R the larger radius, c its axis and r the smaller one, since sin θ + sin θ' ≥ sin α. With v·c ≥ 0 this
  /// is concave or falls all the way, so it is least at 0 or at the reach. With v·c < 0 it may be least
  /// between them: such solids hardly overlap along c, and nothing is proved here.
  double lowest_about_end(double end, double reach) const {
    const Vec3 a = end * Vec3::UnitZ(), b = end * axis_;
    const ProfilePoint A = end_ring(of_A_, end), B = end_ring(of_B_, end);
    const Vec3 v = A.axial * Vec3::UnitZ() + B.axial * axis_ + p_;
    const bool is_of_A = A.radial >= B.radial;
    const Vec3& c = is_of_A ? a : b;
    const double least = std::min(A.radial, B.radial), more = std::abs(A.radial - B.radial);
    const double along = v.dot(c), across = v.cross(c).norm();
    if (!(along >= 0)) return -std::numeric_limits<double>::infinity();
    const double farthest = is_of_A ? reach : reach + 2 * sine_;
    const double there = least * sine_ + along * std::cos(farthest) + (more - across) * std::sin(farthest);
    return std::min(least * sine_ + along, there);
  }

  /// A direction and a lower bound of h, with how steep it is by φ, at one of the angles θ between which the
  /// bound is concave in the half-plane at φ about the axis of A.
  enum class Kind { side_of_A, side_of_B, end };
  struct Place {
    Kind kind;
    Vec3 m;
    double lowest;
    double steepness;  ///< Bound of the size of the first derivative by φ, there.
    double curvature;  ///< Bound of the second derivative by φ, all around.
  };
  /// In the half-plane at φ the axis of B appears at the angle δ, tan δ = tan α cos ψ, and shorter by the
  /// factor R, R² = 1 - sin² α sin² ψ, ψ the angle from towards_. A circle of B reaches at least as far as
  /// its two points in that plane: h ≥ the support value of a polygon.
  template <class Visit>
  void for_each_place(double phi, double reach, Visit visit) const {
    const Vec2 u(std::cos(phi), std::sin(phi)), u_rate(-u.y(), u.x());
    const double cosine = u.dot(towards_), cosine_rate = u_rate.dot(towards_);
    const double tangent = sine_ / std::sqrt(1 - sine_ * sine_) * cosine;
    const ProfilePoint delta{tangent / std::sqrt(1 + tangent * tangent),
                             1 / std::sqrt(1 + tangent * tangent)};
    const double delta_rate = sine_ / std::sqrt(1 - sine_ * sine_) * cosine_rate * delta.axial * delta.axial;
    const double R = std::sqrt(1 - sine_ * sine_ * (1 - cosine * cosine));
    const double R_rate = sine_ * sine_ * cosine * cosine_rate / R;
    const double aside = p_.head<2>().dot(u), aside_rate = p_.head<2>().dot(u_rate);
    const auto place = [&](Kind kind, const ProfilePoint& in_A, const ProfilePoint& in_B, const Vec3& m) {
      if (in_A.radial < std::sin(reach)) return;
      const ProfilePoint A = support_point(of_A_, in_A),
                         B = support_point(of_B_, {in_B.radial, R * in_B.axial});
      const double value = dot(A, in_A) + B.radial * in_B.radial + R * B.axial * in_B.axial +
                           aside * in_A.radial + p_.z() * in_A.axial;
      // θ stays, or moves with δ. A direction square to a side of B moves with R, too, as far as that side is
      // aslant: tan θ_B = R tan θ_side gives |dθ_B/dφ| ≤ sin² α / (4 R²), R near 1, and h changes with θ_B by
      // no more than all sizes together. So much is left out of the slope here, and put on its size.
      const double slope =
          aside_rate * in_A.radial + R_rate * B.axial * in_B.axial +
          delta_rate * (kind == Kind::side_of_B ? A.radial * in_A.axial - A.axial * in_A.radial +
                                                      aside * in_A.axial - p_.z() * in_A.radial
                                                : -B.radial * in_B.axial + R * B.axial * in_B.radial);
      const double left_out = kind == Kind::side_of_B ? by_shortening_ : 0;
      visit(Place{kind, m, value, std::abs(slope) + left_out, p_.head<2>().norm() * in_A.radial + by_tilt_});
    };
    const auto in_space = [&u](const ProfilePoint& m) -> Vec3 {
      return {m.radial * u.x(), m.radial * u.y(), m.axial};
    };
    // The angle θ - δ.
    const auto fixed = [&](Kind kind, const ProfilePoint& m) {
      place(
          kind, m,
          {m.radial * delta.axial - m.axial * delta.radial, m.axial * delta.axial + m.radial * delta.radial},
          in_space(m));
    };
    for (const ProfilePoint& side : sides_of_A_) fixed(Kind::side_of_A, side);
    for (const ProfilePoint& side : sides_of_B_) {
      const double length = std::hypot(R * side.radial, side.axial);
      const ProfilePoint in_B{R * side.radial / length, side.axial / length};
      const ProfilePoint in_A{in_B.radial * delta.axial + in_B.axial * delta.radial,
                              in_B.axial * delta.axial - in_B.radial * delta.radial};
      // Square to the side of B itself, which the plane shows tilted.
      const Vec3 m = in_space(in_A), out = (m - m.dot(axis_) * axis_).normalized();
      place(Kind::side_of_B, in_A, in_B, side.axial * axis_ + side.radial * out);
    }
    for (const double end : {1.0, -1.0}) fixed(Kind::end, {std::sin(reach), end * std::cos(reach)});
  }

 private:
  /// The ring that carries along the axis.
  static ProfilePoint end_ring(const std::vector<ProfilePoint>& points, double end) {
    ProfilePoint best = points.front();
    for (const ProfilePoint& p : points) {
      if (end * p.axial > end * best.axial || (p.axial == best.axial && p.radial > best.radial)) best = p;
    }
    return best;
  }

  const CorePair& pair_;
  double sign_;
  Vec3 axis_;     ///< Of B, at most a right angle from z.
  double sine_;   ///< Of the angle α of the axes.
  Vec2 towards_;  ///< Where the axis of B leans.
  Vec3 p_;
  std::vector<ProfilePoint> of_A_, of_B_, sides_of_A_, sides_of_B_;
  double by_tilt_ = 0;        ///< How far the tilt bends heights as functions of φ, at most.
  double by_shortening_ = 0;  ///< How far what R turns of directions inclines them, at most.
};

/// The lowest of h on the circle of m about an axis: where the slope w·(axis × m) changes its sign, w the
/// point that carries.
Vec3 lowest_on_circle(const CorePair& pair, const Vec3& axis, const Vec3& m) {
  constexpr int samples = 8;
  constexpr double apart = 2 * kPi / samples, tolerance = 1e-15;
  const Vec3 along = m.dot(axis) * axis, out = m - along, across = axis.cross(m);
  const auto at_angle = [&](double angle) -> Vec3 {
    return along + std::cos(angle) * out + std::sin(angle) * across;
  };
  const auto point = [&](const Vec3& there) { return pair.lowest(-there).w; };
  double lowest = std::numeric_limits<double>::infinity(), near = 0;
  for (int k = 0; k < samples; ++k) {
    const Vec3 there = at_angle(apart * k);
    if (const double h = point(there).dot(there); h < lowest) {
      lowest = h;
      near = apart * k;
    }
  }
  const auto slope = [&](double angle) {
    const Vec3 there = at_angle(angle);
    return point(there).dot(axis.cross(there));
  };
  if (!(slope(near - apart) < 0 && slope(near + apart) > 0)) return m;
  const RootBracket root = find_root_itp(slope, near - apart, near + apart, tolerance);
  return at_angle(0.5 * (root.lo + root.hi)).normalized();
}

}  // namespace

std::optional<Penetration> find_tilted_penetration(const CorePair& pair) {
  if (!has_profile(pair.a) || !has_profile(pair.b)) return std::nullopt;
  const TiltedPair tilted(pair);
  if (!(tilted.sine() > kLeastTilt && tilted.sine() < kMostTilt)) return std::nullopt;
  const double size = std::min(pair.a.extent, pair.b.extent), gap = 0.9 * kGap * size;

  // The ends of both axes, where h has corners; the best of the directions square to a side of A and of B.
  struct Direction {
    Vec3 m = Vec3::UnitZ();
    double height = std::numeric_limits<double>::infinity();
  };
  Direction best, of_side[2];
  const auto offer = [&](const Vec3& m, Direction& to) {
    if (const double h = tilted.height(m); h < to.height) to = {m, h};
    if (to.height < best.height) best = to;
  };
  for (const double end : {1.0, -1.0}) {
    offer(end * Vec3::UnitZ(), best);
    offer(end * tilted.axis(), best);
  }

  // Between them, half-plane by half-plane: parts of the circle whose lowest bound is too low are halved.
  constexpr int first_parts = 8, most_parts = 300;
  const double reach = 8 * tilted.sine();
  struct Part {
    double phi, half;
  };
  std::vector<Part> parts;
  parts.reserve(4 * first_parts);
  for (int k = 0; k < first_parts; ++k) parts.push_back({2 * kPi * k / first_parts, kPi / first_parts});
  double lowest = std::numeric_limits<double>::infinity();
  for (int count = 0; !parts.empty(); ++count) {
    if (count == most_parts) return std::nullopt;
    const Part part = parts.back();
    parts.pop_back();
    double bound = std::numeric_limits<double>::infinity();
    std::array<std::optional<TiltedPair::Place>, 2> sides;
    tilted.for_each_place(part.phi, reach, [&](const TiltedPair::Place& place) {
      bound = std::min(
          bound, place.lowest - place.steepness * part.half - 0.5 * place.curvature * part.half * part.half);
      if (place.kind == TiltedPair::Kind::end) return;
      std::optional<TiltedPair::Place>& side = sides[place.kind == TiltedPair::Kind::side_of_A ? 0 : 1];
      if (!side || place.lowest < side->lowest) side = place;
    });
    for (std::size_t k = 0; k < 2; ++k)
      if (sides[k]) offer(sides[k]->m, of_side[k]);
    if (bound >= best.height - gap) {
      lowest = std::min(lowest, bound);
    } else {
      parts.push_back({part.phi - 0.5 * part.half, 0.5 * part.half});
      parts.push_back({part.phi + 0.5 * part.half, 0.5 * part.half});
    }
  }
  for (const double end : {1.0, -1.0}) lowest = std::min(lowest, tilted.lowest_about_end(end, reach));

  // The best direction exactly: on the circles about the axes.
  const Vec3 axes[2] = {Vec3::UnitZ(), tilted.axis()};
  for (std::size_t k = 0; k < 2; ++k) {
    if (of_side[k].height < best.height + 2 * gap)
      offer(lowest_on_circle(pair, axes[k], of_side[k].m), of_side[k]);
  }
  if (!(best.height > -pair.rounding) || lowest < best.height - kGap * size) return std::nullopt;
  const Vec3 n = -best.m;
  const DifferencePoint point = pair.lowest(n);
  // Faces that the tilt takes from level by as much as the tolerance may or may not count as level.
  constexpr double kLevel = 1e-8, kWitnesses = 1e-7;
  const Separation found = with_level_witnesses(pair, {n, n.dot(point.w), point.a, point.b}, kLevel * size);
  if ((found.b - found.a - found.value * n).norm() > kWitnesses * size) return std::nullopt;
  return Penetration{found, std::max(found.value, -lowest + pair.rounding)};
}

}  // namespace rigor
