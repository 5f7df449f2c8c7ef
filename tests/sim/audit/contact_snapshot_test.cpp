#include "rigor/sim/audit/contact_snapshot.hpp"

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/method/method.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::contact_snapshot_test {
namespace {

constexpr double g = 9.81, mass = 2, mu = 0.4;

BodyDescription body_of(const std::string& name, const Shape& shape, const Vec3& x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}
BodyDescription floor_body() {
  BodyDescription floor = body_of("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
  floor.motion = MotionType::fixed;
  return floor;
}

/// A box on a plane that is inclined by the angle [rad], moving down the slope (-x) at this speed [m/s], at
/// this height above the plane [m].
std::shared_ptr<const Model> box_on_slope(double angle, double speed, double height = 0, double rise = 0) {
  ModelBuilder builder;
  // The slope is the x-y plane; gravity is inclined instead.
  builder.set_gravity(g * Vec3(-std::sin(angle), 0, -std::cos(angle)));
  builder.add_material({"m", 1000, mu, 0});
  builder.add_body(floor_body());
  BodyDescription box = body_of("box", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1 + height));
  box.velocity = Vec3(-speed, 0, rise);
  box.mass = mass;
  builder.add_body(box);
  return builder.build();
}

std::vector<TouchingPoint> snapshot(const Model& model, const Method& method = {}) {
  return contact_snapshot(model, method, make_initial_state(model));
}

Vec3 total_force(const std::vector<TouchingPoint>& points) {
  Vec3 sum = Vec3::Zero();
  for (const TouchingPoint& point : points) sum += point.force_W;
  return sum;
}

// Forces are sums of four solved ones: some roundings of the weight.
constexpr double rounding = 1e-11 * mass * g;

TEST(ContactSnapshot, ARestingBoxIsHeldByItsWeightAndSticks) {
  const double angle = 0.3;  // tan < mu
  const std::vector<TouchingPoint> points = snapshot(*box_on_slope(angle, 0));
  ASSERT_EQ(points.size(), 4u);
  for (const TouchingPoint& point : points) {
    EXPECT_EQ(point.mode, TouchingPoint::Mode::stick);
    EXPECT_EQ(point.body_A, 0);
    EXPECT_EQ(point.body_B, 1);
    EXPECT_EQ(point.n_W, Vec3(Vec3::UnitZ()));
    EXPECT_NEAR(point.p_W.z(), 0, 1e-12);
  }
  EXPECT_LT((total_force(points) - mass * g * Vec3(std::sin(angle), 0, std::cos(angle))).norm(), rounding);
}

// Micrometres a second are rounding there, and no slip against which all friction would act.
TEST(ContactSnapshot, WhatSoftStepsLeaveOfARestIsNoSlip) {
  Method soft;
  soft.scheme = Scheme::time_stepping;
  soft.solver = SolverMethod::substep;
  for (const double speed : {1e-7, 1e-5, 1e-4}) {
    const Vec3 force = total_force(snapshot(*box_on_slope(0, speed), soft));
    EXPECT_LT((force - mass * g * Vec3::UnitZ()).norm(), rounding) << speed;
  }
}

TEST(ContactSnapshot, ASlidingBoxIsBrakedByMuTimesTheNormalForce) {
  const double angle = 0.6, speed = 1.5;
  const std::vector<TouchingPoint> points = snapshot(*box_on_slope(angle, speed));
  ASSERT_EQ(points.size(), 4u);
  for (const TouchingPoint& point : points) {
    EXPECT_LT((point.u_W - Vec3(-speed, 0, 0)).norm(), 1e-14);
    EXPECT_EQ(point.mode, TouchingPoint::Mode::slide);
  }
  const double normal = mass * g * std::cos(angle);
  EXPECT_LT((total_force(points) - normal * Vec3(mu, 0, 1)).norm(), rounding);
}

TEST(ContactSnapshot, WhatPartsTouchesWithoutForceAndWhatIsApartDoesNotTouch) {
  const std::vector<TouchingPoint> parting = snapshot(*box_on_slope(0, 0, 0, 0.5));
  ASSERT_EQ(parting.size(), 4u);
  for (const TouchingPoint& point : parting) {
    EXPECT_EQ(point.mode, TouchingPoint::Mode::open);
    EXPECT_EQ(point.force_W, Vec3(Vec3::Zero()));
  }
  EXPECT_TRUE(snapshot(*box_on_slope(0, 0, 1e-3)).empty());
}

TEST(ContactSnapshot, OfGroupsTooLargeToSolveTheForcesAreNotKnown) {
  ModelBuilder builder;
  builder.set_gravity(g * -Vec3::UnitZ());
  builder.add_material({"m", 1000, mu, 0});
  builder.add_body(floor_body());
  // A row of 101 boxes face to face: four points under each and four between neighbours.
  for (int i = 0; i < 101; ++i) {
    builder.add_body(
        body_of("box" + std::to_string(i), Box{Vec3::Constant(0.125)}, Vec3(0.25 * i, 0, 0.125)));
  }
  const std::vector<TouchingPoint> points = snapshot(*builder.build());
  ASSERT_EQ(points.size(), 4u * 101 + 4u * 100);
  for (const TouchingPoint& point : points) {
    EXPECT_EQ(point.mode, TouchingPoint::Mode::unknown);
    EXPECT_TRUE(point.force_W.hasNaN());
  }
}

}  // namespace
}  // namespace rigor::contact_snapshot_test
