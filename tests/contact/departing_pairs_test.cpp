// The search for the next impact of bodies that touch and move apart.

#include "geometry/mesh_shapes.hpp"
#include "geometry/solid_shapes.hpp"
#include "rigor/contact/time_of_impact.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/body.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rigor::departing_pairs_test {
namespace {

constexpr double kGravity = 9.81;

/// A body of one shape, thrown or at rest.
struct Thrown {
  Body body;
  Motion motion;

  Thrown(const Shape& shape, const BodyPhase& start, double acceleration) {
    body.shapes = {{BodyShape{.shape = shape, .radius = radius_about(shape, Vec3::Zero())}}};
    const BodyInertia inertia{1, Vec3::Ones()};
    motion = Motion::flight(FreeFlight(inertia, start, 0, Vec3(0, 0, -acceleration)), inertia);
  }
};

Thrown at_rest(const Shape& shape, double z) {
  return {shape, {Vec3(0, 0, z), Quat::Identity(), Vec3::Zero(), Vec3::Zero()}, 0};
}

/// A slab whose upper side is z = 0.
std::vector<Thrown> grounds() {
  const Mesh slab = test::as_mesh(make_box_mesh(Vec3(-1, -1, -1), Vec3(1, 1, 0)));
  return {at_rest(Box{Vec3(1, 1, 0.5)}, -0.5), at_rest(slab, 0)};
}

TEST(DepartingPairs, WhatLeavesTheGroundComesBackWhenItsFlightEnds) {
  // However slow it is: the flight of speed v lasts 2 v / g, also where its height v² / (2 g) is far below
  // the overlap that is allowed.
  for (const Thrown& ground : grounds()) {
    for (const Shape& shape : {Shape(Sphere{0.1}), Shape(Box{Vec3(0.1, 0.2, 0.1)})}) {
      for (const double speed : {1.0, 1e-2, 1e-3, 1e-4, 1e-5}) {
        const Thrown ball(shape, {Vec3(0.2, 0.3, 0.1), Quat::Identity(), Vec3(0, 0, speed), Vec3::Zero()},
                          kGravity);
        for (const ToiRefinement refinement :
             {ToiRefinement::conservative, ToiRefinement::ratio, ToiRefinement::bisection}) {
          ToiOptions options;
          options.refinement = refinement;
          const TimeOfImpact found =
              find_time_of_impact(ground.body, ground.motion, ball.body, ball.motion, 0, 1, options);
          ASSERT_TRUE(found.is_contact) << speed;
          // Rounding of a distance of 1e-16 m at this speed, and the time tolerance.
          EXPECT_NEAR(found.time, 2 * speed / kGravity, 2e-12 + 1e-15 / speed) << speed;
        }
      }
    }
  }
}

TEST(DepartingPairs, WhatLeavesWithASmallOverlapIsBackAtTheSameOverlap) {
  constexpr double overlap = 1e-7, speed = 1e-4;  // It rises by 5e-10 m: it is never apart.
  for (const Thrown& ground : grounds()) {
    const Thrown ball(Sphere{0.1},
                      {Vec3(0.2, 0.3, 0.1 - overlap), Quat::Identity(), Vec3(0, 0, speed), Vec3::Zero()},
                      kGravity);
    const TimeOfImpact found =
        find_time_of_impact(ground.body, ground.motion, ball.body, ball.motion, 0, 1, ToiOptions{});
    ASSERT_TRUE(found.is_contact);
    EXPECT_NEAR(found.time, 2 * speed / kGravity, 2e-11);
  }
}

TEST(DepartingPairs, WhoCreepsTogetherMeetsWhereHalfOfTheOverlapIsUsedUp) {
  // As bodies of a stack do that fall together between two micro-collisions: no acceleration makes them
  // faster.
  const Shape ball = Sphere{0.1}, block = Box{Vec3(0.1, 0.2, 0.1)};
  for (const auto& [lower, upper] : {std::pair(ball, ball), std::pair(block, block), std::pair(block, ball),
                                     std::pair(Shape(HalfSpace{Vec3::UnitZ(), 0}), ball)}) {
    for (const double speed : {1e-5, 1e-7, 1e-9}) {
      const double height = std::holds_alternative<HalfSpace>(lower) ? 0.1 : 0.2, span = 2e-6 / speed;
      const Thrown ground = at_rest(lower, 0);
      const Thrown body(upper, {Vec3(0, 0, height), Quat::Identity(), Vec3(0, 0, -speed), Vec3::Zero()}, 0);
      ToiOptions options;
      options.rest_velocity = 1e-4;
      const auto find = [&] {
        return find_time_of_impact(ground.body, ground.motion, body.body, body.motion, 0, span, options);
      };
      EXPECT_FALSE(find().is_contact) << speed;
      options.deep_velocity = 1e-12;
      const TimeOfImpact found = find();
      ASSERT_TRUE(found.is_contact) << speed;
      EXPECT_LE(speed * found.time, options.contact_tolerance) << speed;
      EXPECT_GE(speed * found.time, 0.25 * options.contact_tolerance) << speed;
    }
  }
}

}  // namespace
}  // namespace rigor::departing_pairs_test
