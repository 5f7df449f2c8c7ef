#include "rigor/geometry/contacts/contact_set.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::contact_set_test {
namespace {

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].
constexpr double kRounding = 1e-14;  ///< A few rounding errors of coordinates near 1 m.

Pose at(double x, double y, double z) {
  return {Mat3::Identity(), Vec3(x, y, z)};
}

Pose turned(const Vec3& axis, double angle, const Vec3& p) {
  return {rotation_matrix(rotation_exp(angle * axis.normalized())), p};
}

/// Is there exactly one contact whose point on B is p?
bool has_point(const std::vector<ContactPoint>& contacts, const Vec3& p, double tolerance = kRounding) {
  return std::count_if(contacts.begin(), contacts.end(),
                       [&](const ContactPoint& c) { return (c.p_WB - p).norm() <= tolerance; }) == 1;
}

const Box kUnitCube{Vec3::Constant(0.5)};

TEST(ContactSet, OfTwoCubesFaceToFaceIsTheSquareOfTheirOverlap) {
  // T07: cubes [0, 1]³, the upper one moved by (1/4, 1/4): the square [1/4, 1]².
  const std::vector<ContactPoint> contacts =
      contact_set(kUnitCube, at(0.5, 0.5, 0.5), kUnitCube, at(0.75, 0.75, 1.5), kTolerance);
  ASSERT_EQ(contacts.size(), 4u);
  for (const double x : {0.25, 1.0}) {
    for (const double y : {0.25, 1.0}) EXPECT_TRUE(has_point(contacts, Vec3(x, y, 1)));
  }
  for (const ContactPoint& contact : contacts) {
    EXPECT_EQ(contact.n_W, Vec3::UnitZ());
    EXPECT_NEAR(contact.gap, 0, kRounding);
    EXPECT_FALSE(contact.degenerate);
    EXPECT_EQ(contact.curvature_A.flat_count + contact.curvature_B.flat_count, 2);
  }
}

TEST(ContactSet, OfCrossedEdgesIsOnePointWithTheCrossProductAsNormal) {
  // T07: A with an edge along y on top, B with one along x at its bottom, turned by 30° about z besides.
  const double height = std::sqrt(0.5);
  const Pose X_WA = turned(Vec3::UnitY(), std::numbers::pi / 4, Vec3(0, 0, -height));
  Pose X_WB = turned(Vec3::UnitX(), std::numbers::pi / 4, Vec3(0.1, 0.2, height));
  const Mat3 R = rotation_matrix(rotation_exp(Vec3(0, 0, std::numbers::pi / 6)));
  X_WB.R = R * X_WB.R;
  const std::vector<ContactPoint> contacts = contact_set(kUnitCube, X_WA, kUnitCube, X_WB, kTolerance);
  ASSERT_EQ(contacts.size(), 1u);
  const Vec3 e_A = Vec3::UnitY(), e_B = R * Vec3::UnitX();
  const Vec3 n = -e_A.cross(e_B).normalized();  // y × x = -z.
  EXPECT_NEAR((contacts[0].n_W - n).norm(), 0, kRounding);
  // The lines x = 0 and (0.1, 0.2) + s (cos 30°, sin 30°) cross at y = 0.2 - 0.1 tan 30°.
  const Vec3 p(0, 0.2 - 0.1 * std::tan(std::numbers::pi / 6), 0);
  EXPECT_NEAR((contacts[0].p_WA - p).norm(), 0, 10 * kRounding);
  EXPECT_FALSE(contacts[0].degenerate);
  for (const SurfaceCurvature& curvature : {contacts[0].curvature_A, contacts[0].curvature_B}) {
    EXPECT_EQ(curvature.flat_count, 1);
    EXPECT_TRUE(curvature.radius_W.isZero(0));
  }
  EXPECT_NEAR(std::abs(contacts[0].curvature_A.flat_W.dot(e_A)), 1, kRounding);
  EXPECT_NEAR(std::abs(contacts[0].curvature_B.flat_W.dot(e_B)), 1, kRounding);
}

TEST(ContactSet, OfParallelEdgesIsTheTwoEndsOfTheirOverlap) {
  // T07: both cubes stand on an edge along y; B is moved by 0.3 along it.
  const double height = std::sqrt(0.5);
  const double quarter = std::numbers::pi / 4;
  const Pose X_WA = turned(Vec3::UnitY(), quarter, Vec3(0, 0, -height));
  const Pose X_WB = turned(Vec3::UnitY(), quarter, Vec3(0, 0.3, height + 1e-7));
  const std::vector<ContactPoint> contacts = contact_set(kUnitCube, X_WA, kUnitCube, X_WB, kTolerance);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_TRUE(has_point(contacts, Vec3(0, -0.2, 1e-7)));
  EXPECT_TRUE(has_point(contacts, Vec3(0, 0.5, 1e-7)));
  for (const ContactPoint& contact : contacts) {
    EXPECT_NEAR((contact.n_W - Vec3::UnitZ()).norm(), 0,
                1e-8);  // The direction of a gap of 1e-7 has 9 digits.
    EXPECT_NEAR(contact.gap, 1e-7, kRounding);
    EXPECT_TRUE(contact.degenerate);
  }
}

TEST(ContactSet, OfABoxOnAFourLegTableKeepsItsFeaturesOverAHundredSteps) {
  // T07: four legs, a board with its underside at z = 1 that drifts and turns a little each step.
  const Box leg{Vec3(0.05, 0.05, 0.5)};
  const Box board{Vec3(0.8, 0.5, 0.02)};
  const std::vector<Vec3> feet = {{0.6, 0.3, 0.5}, {-0.6, 0.3, 0.5}, {-0.6, -0.3, 0.5}, {0.6, -0.3, 0.5}};
  for (const Vec3& foot : feet) {
    std::vector<std::uint64_t> features;
    for (int step = 0; step < 100; ++step) {
      const Pose X_WB = turned(Vec3::UnitZ(), 1e-3 * step, Vec3(1e-4 * step, -5e-5 * step, 1.02));
      const std::vector<ContactPoint> contacts =
          contact_set(leg, at(foot.x(), foot.y(), foot.z()), board, X_WB, kTolerance);
      ASSERT_EQ(contacts.size(), 4u);
      std::vector<std::uint64_t> now;
      for (const ContactPoint& contact : contacts) now.push_back(contact.feature);
      EXPECT_TRUE(std::is_sorted(now.begin(), now.end()));
      if (step == 0) features = now;
      EXPECT_EQ(now, features);
    }
  }
  // A table of point feet, one box a foot, on a large floor: the four contacts of the course's example.
  const Box foot_tip{Vec3(0.02, 0.02, 0.02)};
  const double standing_on_corner = 0.02 * std::sqrt(3.0);
  const Mat3 on_corner = frame_with_z(Vec3(1, 1, 1).normalized()).transpose();
  int count = 0;
  for (const Vec3& foot : feet) {
    const std::vector<ContactPoint> contacts =
        contact_set(Box{Vec3(5, 5, 1)}, at(0, 0, -1), foot_tip,
                    {on_corner, Vec3(foot.x(), foot.y(), standing_on_corner)}, kTolerance);
    count += static_cast<int>(contacts.size());
  }
  EXPECT_EQ(count, 4);
}

TEST(ContactSet, OfACubeTurnedBy45DegreesOnACubeHasEightCorners) {
  const Pose X_WB = turned(Vec3::UnitZ(), std::numbers::pi / 4, Vec3(0, 0, 1));
  const std::vector<ContactPoint> contacts = contact_set(kUnitCube, at(0, 0, 0), kUnitCube, X_WB, kTolerance);
  // The diamond |x| + |y| ≤ √½ cut by the square |x|, |y| ≤ ½.
  const double a = std::sqrt(0.5) - 0.5;
  ASSERT_EQ(contacts.size(), 8u);
  for (const double s : {-1.0, 1.0}) {
    for (const double t : {-1.0, 1.0}) {
      EXPECT_TRUE(has_point(contacts, Vec3(s * 0.5, t * a, 0.5)));
      EXPECT_TRUE(has_point(contacts, Vec3(s * a, t * 0.5, 0.5)));
    }
  }
  for (const ContactPoint& contact : contacts) {
    EXPECT_EQ(contact.n_W, Vec3::UnitZ());
    EXPECT_EQ(contact.curvature_A.flat_count, 2);  // Each crossing is a point of B on the face of A.
    EXPECT_EQ(contact.curvature_B.flat_count, 0);
  }
}

Convex hexagonal_prism(double radius, double half_length) {
  std::vector<Vec3> points;
  for (int k = 0; k < 6; ++k) {
    const double angle = std::numbers::pi / 3 * k;
    for (const double z : {-half_length, half_length}) {
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  return {std::make_shared<ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

TEST(ContactSet, OfAHexagonalPrismOnABoxIsTheClippedHexagon) {
  const Convex prism = hexagonal_prism(1, 0.5);
  const std::vector<ContactPoint> whole =
      contact_set(Box{Vec3(2, 2, 0.5)}, at(0, 0, -0.5), prism, at(0, 0, 0.5), kTolerance);
  EXPECT_EQ(whole.size(), 6u);

  // A plate |y| ≤ 1/2 cuts two corners off on each side: (±1, 0) stay and four crossings at x = ±(1 -
  // 1/(2√3)) come.
  const std::vector<ContactPoint> cut =
      contact_set(Box{Vec3(2, 0.5, 0.5)}, at(0, 0, -0.5), prism, at(0, 0, 0.5), kTolerance);
  ASSERT_EQ(cut.size(), 6u);
  const double x = 1 - 0.5 / std::sqrt(3.0);
  for (const double s : {-1.0, 1.0}) {
    EXPECT_TRUE(has_point(cut, Vec3(s, 0, 0)));
    for (const double t : {-0.5, 0.5}) EXPECT_TRUE(has_point(cut, Vec3(s * x, t, 0)));
  }

  // A smaller cube under the prism: its four corners.
  const std::vector<ContactPoint> inner =
      contact_set(Box{Vec3(0.5, 0.5, 0.5)}, at(0, 0, -0.5), prism, at(0, 0, 0.5), kTolerance);
  EXPECT_EQ(inner.size(), 4u);
}

TEST(ContactSet, OfABoxPartlyOverAnEdgeEndsAtTheEdge) {
  const std::vector<ContactPoint> contacts = contact_set(
      Box{Vec3(1, 1, 0.5)}, at(-1, 0, -0.5), Box{Vec3(0.3, 0.2, 0.1)}, at(0.1, 0, 0.1), kTolerance);
  ASSERT_EQ(contacts.size(), 4u);
  for (const double x : {-0.2, 0.0}) {
    for (const double y : {-0.2, 0.2}) EXPECT_TRUE(has_point(contacts, Vec3(x, y, 0)));
  }
}

TEST(ContactSet, OfATiltedBoxHoldsOnlyTheCornersWithinTheTolerance) {
  // Tilted by 1e-4 about y the far edge is 1e-4 higher; by 1e-7 it is within the tolerance, each corner with
  // its own gap.
  for (const bool on_plane : {true, false}) {
    const Shape floor = on_plane ? Shape(HalfSpace{Vec3::UnitZ(), 0}) : Shape(Box{Vec3(5, 5, 1)});
    const Pose X_WA = on_plane ? Pose{} : at(0, 0, -1);
    const auto tilted = [&](double angle) {
      const double height = 0.5 * (std::cos(angle) + std::sin(angle));
      return contact_set(floor, X_WA, kUnitCube, turned(Vec3::UnitY(), angle, Vec3(0, 0, height)),
                         kTolerance);
    };
    EXPECT_EQ(tilted(0).size(), 4u);
    EXPECT_EQ(tilted(1e-4).size(), 2u);
    const std::vector<ContactPoint> all = tilted(1e-7);
    ASSERT_EQ(all.size(), 4u);
    for (const ContactPoint& contact : all) {
      EXPECT_EQ(contact.n_W, Vec3::UnitZ());
      // Turning about y by +angle lowers the corners at +x.
      EXPECT_NEAR(contact.gap, contact.p_WB.x() > 0 ? 0 : std::sin(1e-7), 4 * kRounding);
    }
  }
}

TEST(ContactSet, OfAPolyhedronAndAPlaneIsItsLowestFeature) {
  const HalfSpace plane{Vec3::UnitZ(), 0};
  const double edge_height = std::sqrt(0.5), corner_height = std::sqrt(0.75);
  const Mat3 on_corner = frame_with_z(Vec3(1, 1, 1).normalized()).transpose();
  EXPECT_EQ(contact_set(plane, Pose{}, kUnitCube, at(3, 4, 0.5), kTolerance).size(), 4u);
  EXPECT_EQ(contact_set(plane, Pose{}, kUnitCube,
                        turned(Vec3::UnitX(), std::numbers::pi / 4, Vec3(3, 4, edge_height)), kTolerance)
                .size(),
            2u);
  const std::vector<ContactPoint> corner =
      contact_set(plane, Pose{}, kUnitCube, {on_corner, Vec3(3, 4, corner_height - 1e-3)}, kTolerance);
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_NEAR(corner[0].gap, -1e-3, kRounding);
  EXPECT_EQ(corner[0].curvature_A.flat_count, 2);
  EXPECT_EQ(corner[0].curvature_B.flat_count, 0);
  EXPECT_TRUE(contact_set(plane, Pose{}, kUnitCube, at(0, 0, 0.5 + 2e-6), kTolerance).empty());
}

TEST(ContactSet, OfTwoCornersIsOneDegeneratePoint) {
  const Mat3 R = frame_with_z(Vec3(1, 1, 1).normalized()).transpose();
  const double height = std::sqrt(0.75);
  const std::vector<ContactPoint> contacts =
      contact_set(kUnitCube, {R, Vec3(0, 0, -height)}, kUnitCube, {R, Vec3(0, 0, height + 5e-7)}, kTolerance);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_TRUE(contacts[0].degenerate);
  EXPECT_NEAR(contacts[0].gap, 5e-7, kRounding);
}

TEST(ContactSet, OfAFlatPyramidHoldsItsTipAndTheRimThatIsNearEnough) {
  // The underside rises by 1e-7 from the tip in the middle to its square border.
  const std::vector<Vec3> points = {{1, 1, 1e-7},  {-1, 1, 1e-7}, {-1, -1, 1e-7},
                                    {1, -1, 1e-7}, {0, 0, 0},     {0, 0, 1}};
  const Convex pyramid{std::make_shared<ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
  const std::vector<ContactPoint> contacts =
      contact_set(HalfSpace{Vec3::UnitZ(), 0}, Pose{}, pyramid, Pose{}, kTolerance);
  EXPECT_EQ(contacts.size(), 5u);
  EXPECT_TRUE(has_point(contacts, Vec3::Zero()));
}

TEST(ContactSet, KeepsItsNormalWhileABoxSlidesAndTurnsOnABox) {
  const Box ground{Vec3(10, 10, 1)};
  for (int step = 0; step < 50; ++step) {
    const Pose X_WB = turned(Vec3::UnitZ(), 0.1 * step, Vec3(0.01 * step, 0, 0.5));
    const std::vector<ContactPoint> contacts = contact_set(ground, at(0, 0, -1), kUnitCube, X_WB, kTolerance);
    ASSERT_EQ(contacts.size(), 4u);
    for (const ContactPoint& contact : contacts) EXPECT_EQ(contact.n_W, Vec3::UnitZ());
    for (const ContactPoint& contact : contact_set(kUnitCube, X_WB, ground, at(0, 0, -1), kTolerance)) {
      EXPECT_EQ(contact.n_W, -Vec3::UnitZ());
    }
  }
}

TEST(ContactSet, IsExactFarFromTheOriginToo) {
  // Two cubes at 2^20 m with a gap of 2^-24 m: all coordinates are representable.
  const double far = 1048576, gap = std::ldexp(1.0, -24);
  const std::vector<ContactPoint> contacts = contact_set(
      kUnitCube, at(far, far, far), kUnitCube, at(far + 0.25, far + 0.25, far + 1 + gap), kTolerance);
  ASSERT_EQ(contacts.size(), 4u);
  for (const ContactPoint& contact : contacts) EXPECT_EQ(contact.gap, gap);
}

}  // namespace
}  // namespace rigor::contact_set_test
