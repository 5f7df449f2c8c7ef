// Caps that lie on each other or on boxes, off centre: where a rim crosses a border the contact is a point of
// its body, and only the lowest point of a tilted rim moves along it.

#include "random_vectors.hpp"
#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::rim_crossings_test {
namespace {

std::shared_ptr<const Model> two_bodies(const Shape& lower, const Shape& upper) {
  ModelBuilder builder;
  for (const auto& [name, shape] : {std::pair{"lower", lower}, std::pair{"upper", upper}}) {
    BodyDescription body;
    body.name = name;
    body.shapes.push_back({shape});
    builder.add_body(body);
  }
  return builder.build();
}

Pose displaced(const Pose& pose, const Vec3& turn, const Vec3& shift) {
  return {rotation_matrix(rotation_exp(turn)) * pose.R, pose.p + shift};
}

TEST(RimCrossings, TrackedGapsChangeByNoMoreThanTheBodiesMove) {
  test::Random random(4);
  int crossings = 0;
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(k);
    // A cap on another or on a box, off centre by a part of its radius, parallel but for 1e-15 to 1e-7.
    const double radius = random.uniform(0.5, 1), half = random.uniform(0.1, 1);
    const Shape lower =
        random.number() < 0 ? Shape{Cylinder{random.uniform(0.5, 1), 0.3}} : Shape{Box{Vec3(0.6, 0.7, 0.3)}};
    const std::shared_ptr<const Model> model = two_bodies(lower, Cylinder{radius, half});
    const double tilt = std::pow(10.0, random.uniform(-15, -7));
    const Pose A{rotation_matrix(rotation_exp(random.vector())), random.vector()};
    const Vec3 across(0.4 * random.number(), 0.4 * random.number(), 0.3 + half);
    const Pose B{A.R * rotation_matrix(rotation_exp(tilt * random.vector())), A * across};

    // Both move a little.
    constexpr double motion = 1e-9;
    const Pose A1 = displaced(A, motion * random.vector(), motion * random.vector());
    const Pose B1 = displaced(B, motion * random.vector(), motion * random.vector());
    for (const Contact& contact : find_contacts(*model, 0, 1, A, B, 1e-6)) {
      const ContactPoint now = tracked_contact(*model, contact, A, B, A1, B1);
      // Points are at most 3 m from the origins of the bodies, and neither moves or turns by more than √3.
      EXPECT_NEAR(now.gap, contact.point.gap, 30 * motion + 2 * tilt);
      const bool is_corner =
          contact.point.curvature_A.radius_W.isZero(0) && contact.point.curvature_B.radius_W.isZero(0);
      if (!is_corner) continue;
      ++crossings;
      EXPECT_LT((now.p_WB - contact.point.p_WB).norm(), 30 * motion);
    }
  }
  EXPECT_GT(crossings, 1000);
}

}  // namespace
}  // namespace rigor::rim_crossings_test
