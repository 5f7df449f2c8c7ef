#include "rigor/geometry/contacts/cavity_contacts.hpp"
#include "rigor/geometry/distance/cavity_distance.hpp"
#include "rigor/geometry/motion/cavity_step.hpp"
#include "rigor/geometry/shape/corner_balls.hpp"

#include "random_vectors.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/rays/ray_span.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace rigor::cavity_test {
namespace {

const Pose at_origin{Mat3::Identity(), Vec3::Zero()};

const std::array<Shape, 6> shapes = {Sphere{0.3},       Box{Vec3(0.2, 0.3, 0.1)},
                                     Capsule{0.1, 0.4}, Cylinder{0.2, 0.3},
                                     Cone{0.25, 0.3},   Ellipsoid{Vec3(0.1, 0.4, 0.25)}};

Mat3 random_rotation(test::Random& random) {
  const double w = random.number();
  const Vec3 v = random.vector();
  return rotation_matrix(Quat(w, v.x(), v.y(), v.z()).normalized());
}

/// Largest distance from c of points on the boundary, by support points in many directions.
double sampled_radius(const Shape& shape, const Vec3& c) {
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < 200; ++k) {
      const double z = 1 - (2 * i + 1) / 200.0, turn = 2 * M_PI * k / 200, r = std::sqrt(1 - z * z);
      largest = std::max(largest,
                         (support_point(shape, Vec3(r * std::cos(turn), r * std::sin(turn), z)) - c).norm());
    }
  }
  return largest;
}

TEST(Cavity, FarthestPointsLieOnTheSmallestBallAndNoSampleIsFarther) {
  test::Random random(11);
  for (const Shape& shape : shapes) {
    for (int k = 0; k < 10; ++k) {
      Vec3 c = 0.5 * random.vector();
      if (k > 6) c(k - 7) = 0;  // On planes of symmetry the ellipsoid's is found by another rule.
      const Vec3 p = farthest_point(shape, c);
      EXPECT_NEAR((p - c).norm(), radius_about(shape, c), 1e-12) << shape_type_name(shape);
      EXPECT_LE(sampled_radius(shape, c), (p - c).norm() + 1e-14) << shape_type_name(shape);
      // It is a point of the shape: no direction separates it.
      for (int d = 0; d < 20; ++d) {
        const Vec3 n = random.vector().normalized();
        EXPECT_LE(n.dot(p), support_value(shape, n) + 1e-14) << shape_type_name(shape);
      }
    }
  }
}

TEST(Cavity, DistanceIsTheRoomLeftAndTheSameBothWays) {
  test::Random random(12);
  const Shape cavity = Cavity{1};
  for (const Shape& shape : shapes) {
    for (int k = 0; k < 20; ++k) {
      const Pose X_WA{random_rotation(random), random.vector()},
          X_WB{random_rotation(random), X_WA.p + 0.6 * random.vector()};
      const DistanceResult d = signed_distance(cavity, X_WA, shape, X_WB);
      EXPECT_NEAR(d.distance, 1 - (d.p_WB - X_WA.p).norm(), 1e-12);
      EXPECT_NEAR((d.p_WA - X_WA.p).norm(), 1, 1e-12);
      EXPECT_NEAR((d.p_WB - d.p_WA - d.distance * d.n_W).norm(), 0, 1e-12);
      const DistanceResult back = signed_distance(shape, X_WB, cavity, X_WA);
      EXPECT_EQ(back.distance, d.distance);
      EXPECT_EQ(back.n_W, -d.n_W);
    }
  }
}

TEST(Cavity, ABoxStandsOnItsFourLowerCorners) {
  // Half diagonal of the base 0.5, so the corners are at the wall sqrt(1 - 0.25) below the centre.
  const Box box{Vec3(0.3, 0.4, 0.1)};
  const double depth = std::sqrt(0.75);
  const Pose X_WB{Mat3::Identity(), Vec3(0, 0, -depth + 0.1)};
  const std::vector<ContactPoint> contacts = contact_set(Cavity{1}, at_origin, box, X_WB, 1e-9);
  ASSERT_EQ(contacts.size(), 4u);
  for (const ContactPoint& contact : contacts) {
    EXPECT_NEAR(contact.gap, 0, 1e-15);
    EXPECT_NEAR(contact.n_W.z(), depth, 1e-15);
    EXPECT_NEAR((contact.p_WA + contact.n_W).norm(), 0, 1e-15) << "the normals meet in the centre";
    EXPECT_TRUE(contact.curvature_B.radius_W.isZero(0));
  }
  const std::vector<ContactPoint> back = contact_set(box, X_WB, Cavity{1}, at_origin, 1e-9);
  ASSERT_EQ(back.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(back[i].n_W, -contacts[i].n_W);
}

TEST(Cavity, TheWallsCurvatureIsThatOfItsNormals) {
  // A turn of the normal at the witness point by dm moves it by radius dm.
  const ContactPoint one = cavity_contact(Cavity{2}, at_origin, Vec3(0.3, -0.4, -1), 0.25);
  const double small = 1e-6;
  const ContactPoint other = cavity_contact(Cavity{2}, at_origin, Vec3(0.3 + small, -0.4, -1), 0.25);
  const Vec3 turn = other.n_W - one.n_W;
  EXPECT_NEAR((one.curvature_A.radius_W * turn - (other.p_WA - one.p_WA)).norm(), 0, 10 * small * small);
}

/// Time of the first contact by safe steps, and that nothing was passed on the way.
void expect_certified(const Shape& shape, const Vec3& x, const Vec3& v, const Vec3& w, const Vec3& a) {
  const Shape cavity = Cavity{1};
  const TwistMotion still(at_origin, Vec3::Zero(), Vec3::Zero());
  const TwistMotion motion({Mat3::Identity(), x}, v, w, a);
  const MovingShape A{&cavity, at_origin, &still}, B{&shape, at_origin, &motion};
  const TimeOfContact found = find_time_of_contact({&A, 1}, {&B, 1}, 0, 10);
  ASSERT_TRUE(found.is_contact);
  EXPECT_LE(found.upper - found.lower, 1e-12);
  const auto gap = [&](double t) {
    return signed_distance(cavity, at_origin, shape, motion.sample(t).X_WB).distance;
  };
  for (int k = 0; k < 2000; ++k) EXPECT_GT(gap(found.lower * k / 2000), 0);
  EXPECT_NEAR(gap(found.upper), 0, 1e-11);
}

TEST(Cavity, TimesOfContactAreCertified) {
  expect_certified(Sphere{0.3}, Vec3(0.1, 0.2, 0), Vec3(1, -0.5, 0.3), Vec3::Zero(), Vec3(0, 0, -9.81));
  expect_certified(Box{Vec3(0.5, 0.1, 0.1)}, Vec3(0.1, 0.2, 0), Vec3(0.2, 0, 0), Vec3(3, 8, -5),
                   Vec3::Zero());
  expect_certified(Capsule{0.1, 0.5}, Vec3(0, 0, 0.2), Vec3(0, 0.3, 0), Vec3(10, 0, 1), Vec3(0, 0, -1));
}

TEST(Cavity, ABallThrownFromTheCentreMeetsTheWallInClosedForm) {
  const Shape cavity = Cavity{1}, ball = Sphere{0.25};
  const TwistMotion still(at_origin, Vec3::Zero(), Vec3::Zero());
  const TwistMotion motion(at_origin, Vec3(0.6, 0, 0.8), Vec3(1, 2, 3));
  const MovingShape A{&cavity, at_origin, &still}, B{&ball, at_origin, &motion};
  const TimeOfContact found = find_time_of_contact({&A, 1}, {&B, 1}, 0, 10);
  ASSERT_TRUE(found.is_contact);
  EXPECT_NEAR(found.lower, 0.75, 1e-12);
}

TEST(Cavity, RaysFromWithinMeetTheWall) {
  const RaySpan span = ray_span(Cavity{2}, {Vec3(0.5, 0, 0), Vec3(1, 0, 0)});
  EXPECT_NEAR(span.in, 1.5, 1e-15);
  EXPECT_NEAR((span.n_in - Vec3(-1, 0, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(span.out, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(ray_span(Cavity{2}, {Vec3(0, 5, 0), Vec3(1, 0, 0)}).is_empty()) << "all of it is in the solid";
}

}  // namespace
}  // namespace rigor::cavity_test
