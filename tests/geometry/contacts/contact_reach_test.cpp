// What touches is in the set however far the reach is: a scheme of long steps asks for gaps of centimetres,
// and its contacts must not change with that.

#include "geometry/random_pairs.hpp"
#include "geometry/solid_shapes.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rigor::contact_reach_test {
namespace {

using test::Draw;

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].
constexpr double kReaches[] = {kTolerance, 1e-4, 1e-3, 1e-2, 3e-2, 0.1};

double least_gap(const std::vector<ContactPoint>& contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : contacts) least = std::min(least, contact.gap);
  return least;
}

/// Pose of b on a along a random direction, deeper than the first touch by `depth`; the distances of solids
/// with hollows need not fall steadily on the way, so that it is found from outside by advancement.
Pose pressed(const Shape& a, const Shape& b, Draw& draw, double depth) {
  const Mat3 R = draw.rotation();
  const Vec3 away = draw.direction();
  double height = 6;
  for (int i = 0; i < 400; ++i) {
    const double gap = signed_distance(a, Pose{}, b, {R, height * away}).distance;
    if (gap <= 1e-9) break;
    height -= gap;
  }
  return {R, (height - depth) * away};
}

TEST(ContactReach, OfMeshesWithHollowsKeepsTheDeepestContact) {
  const Shape shapes[] = {
      test::as_scaled_mesh(test::l_solid(), 0.2), test::as_scaled_mesh(test::torus_solid(0.35, 16, 10), 0.25),
      test::as_scaled_mesh(test::gear_solid(9), 0.3), test::as_scaled_mesh(test::cube_with_hole(), 0.2)};
  Draw draw(181);
  int count = 0;
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE(trial);
    const Shape &a = shapes[trial % 4], &b = shapes[trial / 4 % 4];
    const double depth = std::pow(10, draw.uniform(-5, -3.5));
    const Pose X_WB = pressed(a, b, draw, depth);
    const double distance = signed_distance(a, Pose{}, b, X_WB).distance;
    if (distance > -1e-7) continue;  // One went past the other, or through its hole.
    ++count;
    const double deepest = least_gap(contact_set(a, Pose{}, b, X_WB, kTolerance));
    EXPECT_LT(deepest, 0);
    for (const double reach : kReaches)
      EXPECT_NEAR(least_gap(contact_set(a, Pose{}, b, X_WB, {kTolerance, reach})), deepest, 1e-9) << reach;
  }
  EXPECT_GE(count, 100);
}

TEST(ContactReach, OfConvexShapesKeepsTheDistance) {
  const Shape shapes[] = {Box{Vec3(0.2, 0.3, 0.05)}, Box{Vec3(0.1, 0.1, 0.1)}, Cylinder{0.25, 0.3},
                          Cone{0.2, 0.2}, Capsule{0.1, 0.2}};
  Draw draw(182);
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE(trial);
    const Shape &a = shapes[trial % 5], &b = shapes[trial / 5 % 5];
    const Pose X_WB = pressed(a, b, draw, std::pow(10, draw.uniform(-6, -3)));
    const double distance = signed_distance(a, Pose{}, b, X_WB).distance;
    // The set merges what is closer than 1e-9 of the size, and knows a shorter way out at times.
    for (const double reach : kReaches) {
      const double least = least_gap(contact_set(a, Pose{}, b, X_WB, {kTolerance, reach}));
      EXPECT_LE(least, distance + 1e-6 * std::abs(distance) + 1e-9) << reach;
    }
  }
}

}  // namespace
}  // namespace rigor::contact_reach_test
