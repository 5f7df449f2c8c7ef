#include "rigor/geometry/convex/parallel_penetration.hpp"

#include "rigor/geometry/convex/level_face.hpp"
#include "rigor/geometry/convex/revolution_profile.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigor {
namespace {

/// Largest gap of the bounds that unequal axes may make, relative to the smaller extent: as for other curved
/// shapes.
constexpr double kAxesGap = 1e-6;

double support(const std::vector<ProfilePoint>& points, const ProfilePoint& m) {
  return dot(support_point(points, m), m);
}

}  // namespace

std::optional<Penetration> find_parallel_penetration(const CorePair& pair, const Vec3& start) {
  if (!has_profile(pair.a) || !has_profile(pair.b)) return std::nullopt;
  const Vec3 axis_B = pair.X_AB.R.col(2);
  const double tilt = axis_B.head<2>().norm() * pair.b.extent;
  if (tilt > 0.5 * kAxesGap * std::min(pair.a.extent, pair.b.extent)) return std::nullopt;

  // The profile of B - A in directions m = -n: that of B with that of A upside down, at the offset of the
  // axes.
  const std::vector<ProfilePoint> of_B = profile(pair.b, axis_B.z() > 0 ? 1 : -1), of_A = profile(pair.a, -1);
  const Vec2 aside = pair.X_AB.p.head<2>();
  const ProfilePoint offset{-aside.norm(), pair.X_AB.p.z()};
  std::vector<ProfilePoint> directions = {{0, 1}, {0, -1}};
  add_side_normals(of_A, directions);
  add_side_normals(of_B, directions);
  const auto height = [&](const ProfilePoint& m) {
    return support(of_A, m) + support(of_B, m) + dot(offset, m);
  };
  const ProfilePoint m = *std::ranges::min_element(directions, {}, height);
  const double depth = height(m);
  if (!(depth > pair.rounding)) return std::nullopt;

  // Back in space: against the offset or, on one axis, on the side where the search has come to.
  const Vec2 side = aside.norm() > 0 ? aside.normalized() : Vec2(start.head<2>()).stableNormalized();
  const Vec2 out = side.norm() > 0.5 ? side : Vec2(Vec2::UnitX());
  const Vec3 n(m.radial * out.x(), m.radial * out.y(), -m.axial);
  const DifferencePoint lowest = pair.lowest(n);
  // The witnesses lie on sides and caps that are level but for the difference of the axes.
  const double level = pair.rounding + 2 * tilt;
  const Separation best = with_level_witnesses(pair, {n, n.dot(lowest.w), lowest.a, lowest.b}, level);
  if ((best.b - best.a - best.value * n).norm() > 2 * level) return std::nullopt;
  return Penetration{best, std::max(best.value, -depth + tilt + pair.rounding)};
}

}  // namespace rigor
