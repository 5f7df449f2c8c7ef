#include "rigor/geometry/shape/revolution.hpp"

#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/shape_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace rigor {
namespace {

/// Dents up to this part of the size of the profile are filled, as the rounding of written numbers makes
/// them.
constexpr double kFilledDent = 1e-6;
/// A ring that stands out from the straight line between its neighbours by less, in parts of the size, is
/// none.
constexpr double kFlatRing = 1e-12;

/// Why the points are no profile, or nothing.
std::string defect_of_points(const std::vector<Vec2>& profile) {
  if (profile.size() < 2)
    return fmt::format("the profile has {} points, must have at least 2", profile.size());
  double largest = 0;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const Vec2& p = profile[k];
    if (!p.allFinite()) return fmt::format("point {} of the profile is not finite", k);
    if (p.x() < 0) return fmt::format("point {} of the profile has radius {:.6g} m, must be >= 0", k, p.x());
    largest = std::max(largest, p.x());
  }
  const auto [lowest, highest] = std::ranges::minmax(profile, {}, [](const Vec2& p) { return p.y(); });
  if (!(largest > 0)) return "the profile lies on the axis: the solid has no volume";
  if (!(highest.y() > lowest.y())) return "the profile has no height: the solid has no volume";
  return "";
}

/// Twice the signed area of the triangle a b c in the (radius, z) half plane.
double doubled_area(const Ring& a, const Ring& b, const Ring& c) {
  return (b.radius - a.radius) * (c.z - a.z) - (b.z - a.z) * (c.radius - a.radius);
}

double distance(const Ring& a, const Ring& b) {
  return std::hypot(b.radius - a.radius, b.z - a.z);
}

double size_of(const std::vector<Ring>& rings) {
  double size = rings.back().z - rings.front().z;
  for (const Ring& ring : rings) size = std::max(size, ring.radius);
  return size;
}

/// The outer side of the hull of the points and their mirror images, from its lowest to its highest corner.
///
/// Source: Andrew, Another Efficient Algorithm for Convex Hulls in Two Dimensions, Inf. Proc. Letters 9(5),
/// 1979.
std::vector<Ring> outer_chain(const std::vector<Vec2>& profile) {
  std::vector<Ring> sorted;
  sorted.reserve(profile.size());
  for (const Vec2& p : profile) sorted.push_back({p.x(), p.y()});
  std::ranges::sort(
      sorted, [](const Ring& a, const Ring& b) { return a.z != b.z ? a.z < b.z : a.radius > b.radius; });
  const double flat = kFlatRing * size_of(sorted);

  std::vector<Ring> chain;
  for (const Ring& next : sorted) {
    // Of several points at one height only the outermost, which comes first, is on the chain.
    if (!chain.empty() && next.z == chain.back().z) continue;
    // The chain turns to the left everywhere: a point that does not stand out to the right of the line past
    // it goes.
    while (chain.size() >= 2) {
      const Ring &before = chain[chain.size() - 2], &last = chain.back();
      if (doubled_area(before, last, next) > flat * distance(before, next)) break;
      chain.pop_back();
    }
    chain.push_back(next);
  }
  return chain;
}

/// Depth of a point below the surface [m], ≤ 0 for points on it.
double depth(const std::vector<Ring>& chain, const Ring& p) {
  double least = std::min(p.z - chain.front().z, chain.back().z - p.z);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    least = std::min(least, doubled_area(chain[i], chain[i + 1], p) / distance(chain[i], chain[i + 1]));
  }
  return least;
}

/// Half sizes in W of a disk of radius 1 across the z axis of S.
Vec3 disk_reach(const Mat3& R_WS) {
  return (R_WS.col(0).cwiseAbs2() + R_WS.col(1).cwiseAbs2()).cwiseSqrt();
}

}  // namespace

std::variant<Revolution, std::string> make_revolution(const std::vector<Vec2>& profile) {
  std::string defect = defect_of_points(profile);
  if (!defect.empty()) return defect;
  std::vector<Ring> chain = outer_chain(profile);
  const double filled = kFilledDent * size_of(chain);
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const double dent = depth(chain, {profile[k].x(), profile[k].y()});
    if (dent <= filled) continue;
    return fmt::format(
        "the profile is not convex: point {} [{:.6g}, {:.6g}] lies {:.3g} m inside the hull of the others; "
        "give the "
        "body one convex shape for each part of the profile between two necks, or a mesh",
        k, profile[k].x(), profile[k].y(), dent);
  }
  return Revolution{std::make_shared<const std::vector<Ring>>(std::move(chain))};
}

ConvexCore Revolution::core() const {
  double extent = 0;
  for (const Ring& ring : *rings) extent = std::max(extent, std::hypot(ring.radius, ring.z));
  return {.kind = ConvexCore::Kind::rings, .rings = *rings, .extent = extent};
}

ShapeData Revolution::data() const {
  static_assert(sizeof(Ring) == 2 * sizeof(double));
  return {.shared = rings.get(), .shared_numbers = {&rings->front().radius, 2 * rings->size()}};
}

Aabb Revolution::box(const Pose& X_WS) const {
  // The box of a hull is that of its pieces.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vec3 reach = disk_reach(X_WS.R);
  Aabb box{Vec3::Constant(infinity), Vec3::Constant(-infinity)};
  for (const Ring& ring : *rings) {
    const Vec3 center = X_WS.p + ring.z * X_WS.R.col(2);
    box = box.united({center - ring.radius * reach, center + ring.radius * reach});
  }
  return box;
}

bool Revolution::contains(const Vec3& p_S) const {
  if (p_S.z() < rings->front().z || p_S.z() > rings->back().z) return false;
  // The frustum at this height, and its radius there.
  const auto upper = std::ranges::lower_bound(*rings, p_S.z(), {}, &Ring::z);
  if (upper == rings->begin()) return p_S.head<2>().squaredNorm() <= upper->radius * upper->radius;
  const Ring &below = *(upper - 1), &above = *upper;
  const double share = (p_S.z() - below.z) / (above.z - below.z);
  const double radius = below.radius + share * (above.radius - below.radius);
  return p_S.head<2>().squaredNorm() <= radius * radius;
}

Vec3 Revolution::farthest_point(const Vec3& c_S) const {
  // Of each ring the point across the axis from c; the distance is convex, so one of them is farthest.
  const double from_axis = c_S.head<2>().norm();
  const Vec2 across = from_axis > 0 ? Vec2(-c_S.head<2>() / from_axis) : Vec2(Vec2::UnitX());
  const Ring& ring = *std::ranges::max_element(
      *rings, {}, [&](const Ring& r) { return std::hypot(from_axis + r.radius, r.z - c_S.z()); });
  return {ring.radius * across.x(), ring.radius * across.y(), ring.z};
}

}  // namespace rigor
