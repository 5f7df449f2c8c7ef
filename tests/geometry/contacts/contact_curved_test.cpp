#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::contact_curved_test {
namespace {

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].
constexpr double kRounding = 1e-14;
constexpr double kPi = std::numbers::pi;

const HalfSpace kPlane{Vec3::UnitZ(), 0};
const Box kGround{Vec3(1, 1, 0.5)};
const Pose kGroundPose{Mat3::Identity(), Vec3(0, 0, -0.5)};

Pose at(double x, double y, double z) {
  return {Mat3::Identity(), Vec3(x, y, z)};
}

Pose turned(const Vec3& axis, double angle, const Vec3& p) {
  return {rotation_matrix(rotation_exp(angle * axis.normalized())), p};
}

/// The axis z of the shape along x.
Pose lying(const Vec3& p) {
  return turned(Vec3::UnitY(), kPi / 2, p);
}

bool has_point(const std::vector<ContactPoint>& contacts, const Vec3& p, double tolerance = 4 * kRounding) {
  return std::count_if(contacts.begin(), contacts.end(),
                       [&](const ContactPoint& c) { return (c.p_WB - p).norm() <= tolerance; }) == 1;
}

void expect_matrix(const Mat3& found, const Mat3& expected) {
  EXPECT_LE((found - expected).norm(), 1e-13) << found << "\nshould be\n" << expected;
}

Mat3 across(const Vec3& n) {
  return Mat3::Identity() - n * n.transpose();
}

TEST(ContactSetOfRoundShapes, OfABallIsOnePointWithItsRadius) {
  for (const Shape& floor : {Shape(kPlane), Shape(kGround)}) {
    const Pose X_WA = floor.index() == Shape(kPlane).index() ? Pose{} : kGroundPose;
    const std::vector<ContactPoint> contacts =
        contact_set(floor, X_WA, Sphere{0.25}, at(0.1, 0.2, 0.25), kTolerance);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_TRUE(has_point(contacts, Vec3(0.1, 0.2, 0)));
    EXPECT_EQ(contacts[0].n_W, Vec3::UnitZ());
    EXPECT_EQ(contacts[0].curvature_A.flat_count, 2);
    EXPECT_EQ(contacts[0].curvature_B.flat_count, 0);
    expect_matrix(contacts[0].curvature_B.radius_W, 0.25 * across(Vec3::UnitZ()));
  }
  const std::vector<ContactPoint> balls =
      contact_set(Sphere{0.25}, at(0, 0, 0), Sphere{0.5}, at(0.45, 0.6, 0), kTolerance);
  ASSERT_EQ(balls.size(), 1u);
  EXPECT_NEAR((balls[0].n_W - Vec3(0.6, 0.8, 0)).norm(), 0, kRounding);
  EXPECT_FALSE(balls[0].degenerate);
  expect_matrix(balls[0].curvature_A.radius_W, 0.25 * across(Vec3(0.6, 0.8, 0)));
  expect_matrix(balls[0].curvature_B.radius_W, 0.5 * across(Vec3(0.6, 0.8, 0)));
}

TEST(ContactSetOfRoundShapes, OfAnEllipsoidBendsAsItsSupportPointMoves) {
  // radius_W dm is the motion of the support point when the outward normal turns by dm: central differences,
  // O(h²).
  const Ellipsoid ellipsoid{Vec3(0.3, 0.5, 0.9)};
  const Mat3 R = rotation_matrix(rotation_exp(Vec3(0.3, -0.7, 1.1)));
  const Vec3 m_S = -(R.transpose() * Vec3::UnitZ());
  const double height = support_value(ellipsoid, m_S);
  const std::vector<ContactPoint> contacts =
      contact_set(kPlane, Pose{}, ellipsoid, {R, Vec3(0, 0, height)}, kTolerance);
  ASSERT_EQ(contacts.size(), 1u);
  const double h = 1e-5;
  for (const Vec3& t : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    const Vec3 ahead = R * support_point(ellipsoid, R.transpose() * (-Vec3::UnitZ() + h * t));
    const Vec3 back = R * support_point(ellipsoid, R.transpose() * (-Vec3::UnitZ() - h * t));
    EXPECT_NEAR((contacts[0].curvature_B.radius_W * t - (ahead - back) / (2 * h)).norm(), 0, 1e-9);
  }
  EXPECT_NEAR((contacts[0].curvature_B.radius_W * Vec3::UnitZ()).norm(), 0, kRounding);
}

TEST(ContactSetOfRoundShapes, OfALyingCapsuleIsTheTwoEndsOfItsSide) {
  const Capsule capsule{0.1, 0.4};
  for (const Shape& floor : {Shape(kPlane), Shape(kGround)}) {
    const Pose X_WA = floor.index() == Shape(kPlane).index() ? Pose{} : kGroundPose;
    const std::vector<ContactPoint> contacts =
        contact_set(floor, X_WA, capsule, lying(Vec3(0.2, 0, 0.1)), kTolerance);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_TRUE(has_point(contacts, Vec3(-0.2, 0, 0)));
    EXPECT_TRUE(has_point(contacts, Vec3(0.6, 0, 0)));
    for (const ContactPoint& contact : contacts) {
      EXPECT_EQ(contact.n_W, Vec3::UnitZ());
      expect_matrix(contact.curvature_B.radius_W, 0.1 * across(Vec3::UnitZ()));
    }
  }
  // Standing, and tilted so that one end is out of reach: one point.
  EXPECT_EQ(contact_set(kPlane, Pose{}, capsule, at(0, 0, 0.5), kTolerance).size(), 1u);
  EXPECT_EQ(
      contact_set(kPlane, Pose{}, capsule,
                  turned(Vec3::UnitY(), kPi / 2 - 1e-3, Vec3(0, 0, 0.1 + 0.4 * std::sin(1e-3))), kTolerance)
          .size(),
      1u);
}

TEST(ContactSetOfRoundShapes, OfACapsuleOverTheEdgeOfABoxEndsAtTheEdge) {
  const std::vector<ContactPoint> contacts =
      contact_set(kGround, kGroundPose, Capsule{0.1, 0.4}, lying(Vec3(0.9, 0.3, 0.1)), kTolerance);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_TRUE(has_point(contacts, Vec3(0.5, 0.3, 0)));
  EXPECT_TRUE(has_point(contacts, Vec3(1, 0.3, 0)));
  // Where the side crosses the edge it bends across the axis only and, as a point on a face, is not flat
  // along it.
  for (const ContactPoint& contact : contacts) {
    EXPECT_EQ(contact.curvature_A.flat_count, 2);
    EXPECT_EQ(contact.curvature_B.flat_count, 0);
    EXPECT_NEAR(contact.curvature_B.radius_W(1, 1), 0.1, kRounding);
    EXPECT_NEAR(contact.curvature_B.radius_W(0, 0), contact.p_WB.x() < 0.75 ? 0.1 : 0, kRounding);
  }
}

TEST(ContactSetOfRoundShapes, OfTwoCapsulesIsOnePointCrossedAndTwoSideBySide) {
  const Capsule capsule{0.1, 0.4};
  const std::vector<ContactPoint> crossed =
      contact_set(capsule, lying(Vec3(0, 0, 0)), capsule, turned(Vec3::UnitX(), kPi / 2, Vec3(0.1, 0.2, 0.2)),
                  kTolerance);
  ASSERT_EQ(crossed.size(), 1u);
  EXPECT_TRUE(has_point(crossed, Vec3(0.1, 0, 0.1)));
  EXPECT_NEAR((crossed[0].n_W - Vec3::UnitZ()).norm(), 0, kRounding);
  EXPECT_FALSE(crossed[0].degenerate);
  EXPECT_EQ(crossed[0].curvature_A.flat_count, 1);
  EXPECT_NEAR(std::abs(crossed[0].curvature_A.flat_W.x()), 1, kRounding);
  expect_matrix(crossed[0].curvature_A.radius_W, 0.1 * Vec3::UnitY() * Vec3::UnitY().transpose());
  EXPECT_NEAR(std::abs(crossed[0].curvature_B.flat_W.y()), 1, kRounding);

  const std::vector<ContactPoint> beside =
      contact_set(capsule, lying(Vec3(0, 0, 0)), capsule, lying(Vec3(0.3, 0.12, 0.16)), kTolerance);
  ASSERT_EQ(beside.size(), 2u);
  EXPECT_TRUE(has_point(beside, Vec3(-0.1, 0.06, 0.08)));
  EXPECT_TRUE(has_point(beside, Vec3(0.4, 0.06, 0.08)));
  for (const ContactPoint& contact : beside) {
    EXPECT_NEAR((contact.n_W - Vec3(0, 0.6, 0.8)).norm(), 0, kRounding);
    EXPECT_FALSE(contact.degenerate);
    EXPECT_EQ(contact.curvature_A.flat_count + contact.curvature_B.flat_count,
              1);  // One ends, the other runs on.
  }
}

TEST(ContactSetOfRoundShapes, OfAStandingCylinderIsFourPointsOfItsRim) {
  const Cylinder cylinder{0.2, 0.3};
  const Pose X_WB = turned(Vec3::UnitZ(), 0.3, Vec3(0.1, 0, 0.3));
  for (const Shape& floor : {Shape(kPlane), Shape(kGround), Shape(Cylinder{0.9, 0.5})}) {
    const Pose X_WA = floor.index() == Shape(kPlane).index() ? Pose{} : kGroundPose;
    const std::vector<ContactPoint> contacts = contact_set(floor, X_WA, cylinder, X_WB, kTolerance);
    ASSERT_EQ(contacts.size(), 4u);
    for (int k = 0; k < 4; ++k) {
      const double angle = 0.3 + k * kPi / 2;  // The body's own x axis first.
      EXPECT_TRUE(has_point(contacts, Vec3(0.1 + 0.2 * std::cos(angle), 0.2 * std::sin(angle), 0)));
    }
    for (const ContactPoint& contact : contacts) {
      EXPECT_EQ(contact.n_W, Vec3::UnitZ());
      EXPECT_EQ(contact.curvature_A.flat_count, 2);
      EXPECT_TRUE(contact.curvature_B.radius_W.isZero(0));
    }
  }
}

TEST(ContactSetOfRoundShapes, OfATiltedCylinderIsTheLowestPointOfItsRim) {
  // Tilted by θ the rim bends along its tangent with R / sin θ.
  const double angle = 0.1, radius = 0.2, half_length = 0.3;
  const double height = half_length * std::cos(angle) + radius * std::sin(angle);
  const std::vector<ContactPoint> contacts =
      contact_set(kPlane, Pose{}, Cylinder{radius, half_length},
                  turned(Vec3::UnitY(), angle, Vec3(0, 0, height)), kTolerance);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_TRUE(has_point(contacts, Vec3(radius * std::cos(angle) - half_length * std::sin(angle), 0, 0)));
  EXPECT_EQ(contacts[0].curvature_B.flat_count, 0);
  expect_matrix(contacts[0].curvature_B.radius_W,
                radius / std::sin(angle) * Vec3::UnitY() * Vec3::UnitY().transpose());
}

TEST(ContactSetOfRoundShapes, OfALyingCylinderIsTheTwoEndsOfItsSide) {
  const Cylinder cylinder{0.2, 0.3};
  for (const Shape& floor : {Shape(kPlane), Shape(kGround)}) {
    const Pose X_WA = floor.index() == Shape(kPlane).index() ? Pose{} : kGroundPose;
    const std::vector<ContactPoint> contacts =
        contact_set(floor, X_WA, cylinder, lying(Vec3(0.1, 0.2, 0.2)), kTolerance);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_TRUE(has_point(contacts, Vec3(-0.2, 0.2, 0)));
    EXPECT_TRUE(has_point(contacts, Vec3(0.4, 0.2, 0)));
    for (const ContactPoint& contact : contacts) {
      expect_matrix(contact.curvature_B.radius_W, 0.2 * Vec3::UnitY() * Vec3::UnitY().transpose());
    }
  }
  // On the cap of a standing one: where its line crosses the rim of the cap, |x| = √(0.15² - 0.09²) = 0.12 at
  // y = 0.09.
  const std::vector<ContactPoint> on_cap =
      contact_set(Cylinder{0.15, 0.5}, at(0, 0, -0.5), cylinder, lying(Vec3(0.05, 0.09, 0.2)), kTolerance);
  ASSERT_EQ(on_cap.size(), 2u);
  EXPECT_TRUE(has_point(on_cap, Vec3(-0.12, 0.09, 0)));
  EXPECT_TRUE(has_point(on_cap, Vec3(0.12, 0.09, 0)));
}

TEST(ContactSetOfRoundShapes, OfACylinderCapOnABoxFaceIsTheClippedDisk) {
  // A disk of radius 1/2 about (0.7, 0) over the edge x = 1: crossings at y = ±0.4, rim points at (0.2, 0),
  // (0.7, ±0.5).
  const std::vector<ContactPoint> edge =
      contact_set(kGround, kGroundPose, Cylinder{0.5, 0.2}, at(0.7, 0, 0.2), kTolerance);
  ASSERT_EQ(edge.size(), 5u);
  for (const Vec3& p :
       {Vec3(1, 0.4, 0), Vec3(1, -0.4, 0), Vec3(0.2, 0, 0), Vec3(0.7, 0.5, 0), Vec3(0.7, -0.5, 0)}) {
    EXPECT_TRUE(has_point(edge, p));
  }
  // About (0.8, 0.8) the corner (1, 1) lies inside: it, two crossings and two rim points.
  const std::vector<ContactPoint> corner =
      contact_set(kGround, kGroundPose, Cylinder{0.5, 0.2}, at(0.8, 0.8, 0.2), kTolerance);
  const double cut = 0.8 - std::sqrt(0.25 - 0.04);
  ASSERT_EQ(corner.size(), 5u);
  for (const Vec3& p :
       {Vec3(1, 1, 0), Vec3(1, cut, 0), Vec3(cut, 1, 0), Vec3(0.3, 0.8, 0), Vec3(0.8, 0.3, 0)}) {
    EXPECT_TRUE(has_point(corner, p));
  }
  // A small box on a large cap: its corners. A box over the rim of a cap: as seen from the other side.
  EXPECT_EQ(
      contact_set(Cylinder{0.5, 0.2}, at(0, 0, -0.2), Box{Vec3(0.1, 0.1, 0.1)}, at(0, 0, 0.1), kTolerance)
          .size(),
      4u);
  const std::vector<ContactPoint> turned_round =
      contact_set(Cylinder{0.5, 0.2}, at(0.7, 0, -0.2), kGround, at(0, 0, 0.5), kTolerance);
  EXPECT_EQ(turned_round.size(), 5u);
}

TEST(ContactSetOfRoundShapes, OfTwoCapsIsTheLensOfTheirDisks) {
  // Radii 0.5 and 0.3, centres 0.4 apart: the rims cross at x = 0.4 exactly, y = ±0.3; of the rim points
  // (0.5, 0) of A lies in B, and of B (0.1, 0) in A besides the crossings, which are the rim points (0.4,
  // ±0.3) of B.
  const std::vector<ContactPoint> contacts =
      contact_set(Cylinder{0.5, 0.2}, at(0, 0, -0.2), Cylinder{0.3, 0.2}, at(0.4, 0, 0.2), kTolerance);
  ASSERT_EQ(contacts.size(), 4u);
  for (const Vec3& p : {Vec3(0.5, 0, 0), Vec3(0.1, 0, 0), Vec3(0.4, 0.3, 0), Vec3(0.4, -0.3, 0)}) {
    EXPECT_TRUE(has_point(contacts, p));
  }
}

TEST(ContactSetOfRoundShapes, OfTiltedCapsLiesOnBothCylindersAtAnyTolerance) {
  std::mt19937 engine(7);
  const auto draw = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(engine()) / static_cast<double>(std::mt19937::max());
  };
  // How far a point lies outside of a cylinder, less than 0 within it, 0 on its surface [m].
  const auto outside = [](const Cylinder& cylinder, const Pose& X, const Vec3& p_W) {
    const Vec3 p = X.R.transpose() * (p_W - X.p);
    return std::max(p.head<2>().norm() - cylinder.radius, std::abs(p.z()) - cylinder.half_length);
  };
  int crossings = 0;
  for (int k = 0; k < 2000; ++k) {
    // A tilted cylinder whose lowest point is over the cap of another.
    const Cylinder a{draw(0.2, 1), 0.5}, b{draw(0.2, 1), draw(0.3, 1)};
    const double tilt = draw(0, 0.75), turn = draw(0, 6), gap = 1e-3, place = draw(0, 1) * a.radius;
    const Pose X_WA{Mat3::Identity(), Vec3(0, 0, -a.half_length)};
    const Mat3 R = rotation_matrix(rotation_exp(turn * Vec3::UnitZ())) *
                   rotation_matrix(rotation_exp(tilt * Vec3::UnitY()));
    const Vec3 lowest = R * Vec3(b.radius, 0, -b.half_length);
    const Pose X_WB{R, Vec3(place, 0, gap) - lowest};
    for (const ContactPoint& point : contact_set(a, X_WA, b, X_WB, 1)) {
      EXPECT_GT(point.gap, gap - 1e-9) << k;
      EXPECT_NEAR(outside(b, X_WB, point.p_WB), 0, 1e-9) << k;
      crossings += std::abs(point.p_WA.head<2>().norm() - a.radius) < 1e-9;
    }
  }
  EXPECT_GT(crossings, 1000);
}

TEST(ContactSetOfRoundShapes, OfAConeIsItsBaseItsApexOrItsSide) {
  const Cone cone{0.3, 0.4};
  for (const Shape& floor : {Shape(kPlane), Shape(kGround)}) {
    const Pose X_WA = floor.index() == Shape(kPlane).index() ? Pose{} : kGroundPose;
    EXPECT_EQ(contact_set(floor, X_WA, cone, at(0, 0, 0.4), kTolerance).size(), 4u);

    const std::vector<ContactPoint> apex =
        contact_set(floor, X_WA, cone, turned(Vec3::UnitX(), kPi, Vec3(0, 0, 0.4)), kTolerance);
    ASSERT_EQ(apex.size(), 1u);
    EXPECT_TRUE(apex[0].curvature_B.radius_W.isZero(0));

    // On its side: the half-angle is α = atan(0.3 / 0.8), the axis rises by α, and the centre, half way up
    // the axis from the apex, is at the height 0.4 sin α.
    const double alpha = std::atan2(0.3, 0.8);
    const Pose X_WB = turned(Vec3::UnitY(), kPi / 2 + alpha, Vec3(0, 0, 0.4 * std::sin(alpha)));
    const std::vector<ContactPoint> side = contact_set(floor, X_WA, cone, X_WB, kTolerance);
    ASSERT_EQ(side.size(), 2u);
    const double slant = std::hypot(0.3, 0.8), x_apex = 0.4 * std::cos(alpha);
    EXPECT_TRUE(has_point(side, Vec3(x_apex, 0, 0)));
    EXPECT_TRUE(has_point(side, Vec3(x_apex - slant, 0, 0)));
    for (const ContactPoint& contact : side) {
      const double bend = contact.p_WB.x() > 0 ? 0 : 0.3 / std::cos(alpha);
      expect_matrix(contact.curvature_B.radius_W, bend * Vec3::UnitY() * Vec3::UnitY().transpose());
    }
  }
}

TEST(ContactSetOfRoundShapes, OfAnEdgeAcrossACylinderIsOnePointOnBothLines) {
  // An edge of a cube along y, 45° to both faces, over a cylinder along x.
  const Cylinder cylinder{0.2, 1};
  const Pose X_WB = turned(Vec3::UnitY(), kPi / 4, Vec3(0.3, 0.1, 0.2 + std::sqrt(0.5)));
  const std::vector<ContactPoint> contacts =
      contact_set(cylinder, lying(Vec3::Zero()), Box{Vec3::Constant(0.5)}, X_WB, kTolerance);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_TRUE(has_point(contacts, Vec3(0.3, 0, 0.2)));
  EXPECT_EQ(contacts[0].curvature_A.flat_count, 1);
  EXPECT_EQ(contacts[0].curvature_B.flat_count, 1);
  expect_matrix(contacts[0].curvature_A.radius_W, 0.2 * Vec3::UnitY() * Vec3::UnitY().transpose());
  EXPECT_FALSE(contacts[0].degenerate);
  // Along the axis: the two ends of the edge.
  const Pose along = turned(Vec3::UnitX(), kPi / 4, Vec3(0.3, 0, 0.2 + std::sqrt(0.5)));
  EXPECT_EQ(contact_set(cylinder, lying(Vec3::Zero()), Box{Vec3::Constant(0.5)}, along, kTolerance).size(),
            2u);
}

TEST(ContactSetOfRoundShapes, GivesPenetrationAsNegativeGaps) {
  const std::vector<ContactPoint> contacts =
      contact_set(kGround, kGroundPose, Cylinder{0.2, 0.3}, at(0, 0, 0.3 - 1e-3), kTolerance);
  ASSERT_EQ(contacts.size(), 4u);
  for (const ContactPoint& contact : contacts) {
    EXPECT_NEAR(contact.gap, -1e-3, kRounding);
    EXPECT_NEAR((contact.p_WB - contact.p_WA - contact.gap * contact.n_W).norm(), 0, kRounding);
  }
}

}  // namespace
}  // namespace rigor::contact_curved_test
