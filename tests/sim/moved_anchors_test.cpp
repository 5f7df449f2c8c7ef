// Bodies on paths that change their velocity while others lie on them or hang from them by joints and
// springs.

#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"
#include "sim/scheme_fuzz.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::moved_anchors_test {
namespace {

using ForceDescription = ModelBuilder::ForceDescription;
using JointDescription = ModelBuilder::JointDescription;

BodyDescription leader(const std::string& name, const Shape& shape, std::vector<PathPoint> path) {
  BodyDescription body = test::stepping_body(name, shape, Vec3::Zero());
  body.motion = MotionType::kinematic;
  body.mass = {};
  body.path = std::move(path);
  return body;
}

/// A path of legs, on multiples of a tenth of a second or between them, of which some stand still.
std::vector<PathPoint> random_path(test::Random& random, const Vec3& start) {
  std::vector<PathPoint> path;
  Vec3 p = start;
  for (double t = 0; t < 1;) {
    path.push_back({t, p, Quat::Identity()});
    t += random.uniform(0, 1) < 0.5 ? 0.1 * std::ceil(random.uniform(0, 3)) : random.uniform(0.03, 0.3);
    if (random.uniform(0, 1) < 0.6) p += 0.1 * random.vector();
  }
  return path;
}

/// What a body on a path leads at the place x: bodies that lie on it, or one that hangs from it in the air.
void add_group(test::Random& random, double x, const std::string& number, ModelBuilder& builder) {
  const std::string led = "led" + number, leads = "leads" + number;
  const int kind = static_cast<int>(random.uniform(0, 4.999));
  if (kind == 0) {
    builder.add_body(leader(leads, Box{Vec3(0.6, 0.6, 0.05)}, random_path(random, Vec3(x, 0, 0.6))));
    builder.add_body(test::stepping_body(led, Box{Vec3::Constant(0.1)}, Vec3(x, 0, 0.75)));
    builder.add_body(test::stepping_body(led + "ball", Sphere{0.1}, Vec3(x + 0.3, 0, 0.75)));
    return;
  }
  builder.add_body(leader(leads, Box{Vec3::Constant(0.05)}, random_path(random, Vec3(x, 0, 3))));
  const double z = random.uniform(1, 2);
  builder.add_body(test::stepping_body(led, Box{Vec3::Constant(0.1)}, Vec3(x, 0, z)));
  if (kind == 1) {
    ForceDescription spring{ForceDescription::Type::spring, {leads, led}};
    spring.points = {Vec3::Zero(), Vec3(random.uniform(-0.05, 0.05), 0, 0.05)};
    spring.stiffness = std::pow(10.0, random.uniform(0, 2.5));
    spring.damping = std::pow(10.0, random.uniform(-2, 0.5));
    spring.length = random.uniform(0.7, 1) * (3 - z);
    return builder.add_force(spring);
  }
  JointDescription joint;
  joint.name = "joint" + number;
  joint.bodies = {leads, led};
  joint.anchors = {Vec3(x, 0, 3)};
  joint.type = kind == 2 ? JointType::ball : kind == 3 ? JointType::hinge : JointType::slider;
  if (kind == 3) joint.axis = Vec3::UnitY();
  if (kind > 2) {
    JointAxis axis;
    axis.stiffness = std::pow(10.0, random.uniform(0, 2));
    axis.damping = std::pow(10.0, random.uniform(-1, 1));
    joint.axes = {axis};
  }
  builder.add_joint(joint);
}

std::shared_ptr<const Model> random_scene(test::Random& random) {
  ModelBuilder builder = test::stepping_builder(0, random.uniform(0, 0.8), Vec3(0, 0, -9.81));
  add_group(random, 0, "0", builder);
  add_group(random, 4, "1", builder);
  return builder.build();
}

TEST(MovedAnchors, EverySchemeEndsWithBooksThatAreRight) {
  test::Random random(11);
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = random_scene(random);
    for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::time_stepping}) {
      SCOPED_TRACE(static_cast<int>(scheme));
      Method method;
      method.scheme = scheme;
      const test::FuzzOutcome outcome = test::fuzz_run(model, method, 1, 1000000);
      EXPECT_FALSE(outcome.took_too_long);
      EXPECT_EQ(outcome.trouble, "");
    }
  }
}

/// A ball of 1 kg at rest on a spring of rest length, without gravity; the other end of the spring begins to
/// move away at 0.3 m/s when `begin` has come.
struct SpringScene {
  static constexpr double stiffness = 50, speed = 0.3;
  double begin;

  std::shared_ptr<const Model> build() const {
    ModelBuilder builder;
    builder.add_material({"m", 1000, 0, 0});
    builder.add_body(leader("anchor", Sphere{0.02},
                            {{0, Vec3(1, 0, 0), Quat::Identity()},
                             {begin, Vec3(1, 0, 0), Quat::Identity()},
                             {begin + 10, Vec3(1 + 10 * speed, 0, 0), Quat::Identity()}}));
    builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3::Zero()));
    ForceDescription spring{ForceDescription::Type::spring, {"anchor", "ball"}};
    spring.points = {Vec3::Zero(), Vec3::Zero()};
    spring.stiffness = stiffness;
    builder.add_force(spring);
    return builder.build();
  }

  /// Where the ball is at t [m].
  double place(double t) const {
    const double w = std::sqrt(stiffness), s = std::max(0.0, t - begin);
    return speed * (s - std::sin(w * s) / w);
  }
};

TEST(MovedAnchors, WhatHangsAtRestNoticesThatItsAnchorBegins) {
  // Between two outputs, and at one.
  for (const double begin : {0.4537, 0.5}) {
    const SpringScene scene{begin};
    const std::shared_ptr<const Model> model = scene.build();
    for (const Scheme scheme :
         {Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based, Scheme::time_stepping}) {
      SCOPED_TRACE(static_cast<int>(scheme));
      Method method;
      method.scheme = scheme;
      State state = make_initial_state(*model);
      const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
      for (int k = 1; k <= 10; ++k) {
        ASSERT_EQ(stepper->advance(state, 0.1 * k).reason, StopReason::reached_end);
        EXPECT_NEAR(state.position(1).x(), scene.place(0.1 * k), 1e-8);
      }
    }
  }
}

TEST(MovedAnchors, AFreshStepperWhereALegBeginsGoesOnBitForBit) {
  test::Random random(5);
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    // Legs begin at 0.3: what lies and what hangs is at rest until then.
    ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
    const auto path = [&](const Vec3& p) {
      return std::vector<PathPoint>{{0, p, Quat::Identity()},
                                    {0.3, p, Quat::Identity()},
                                    {0.9, p + 0.2 * random.vector(), Quat::Identity()}};
    };
    builder.add_body(leader("tray", Box{Vec3(0.6, 0.6, 0.05)}, path(Vec3(0, 0, 0.6))));
    builder.add_body(test::stepping_body("box", Box{Vec3::Constant(0.1)}, Vec3(0, 0, 0.75)));
    builder.add_body(leader("hook", Sphere{0.05}, path(Vec3(4, 0, 3))));
    builder.add_body(test::stepping_body("weight", Box{Vec3::Constant(0.1)}, Vec3(4, 0, 1)));
    JointDescription rope;
    rope.name = "rope";
    rope.type = JointType::distance;
    rope.bodies = {"hook", "weight"};
    rope.anchors = {Vec3(4, 0, 3), Vec3(4, 0, 1.05)};
    builder.add_joint(rope);
    const std::shared_ptr<const Model> model = builder.build();

    for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::time_stepping}) {
      SCOPED_TRACE(static_cast<int>(scheme));
      Method method;
      method.scheme = scheme;
      State whole = make_initial_state(*model);
      const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
      stepper->advance(whole, 0.3);
      State resumed = whole;
      stepper->advance(whole, 0.6);
      make_stepper(model, method, 0.01)->advance(resumed, 0.6);
      EXPECT_TRUE(whole == resumed);
      // They have been taken along.
      EXPECT_GT((whole.position(4) - Vec3(4, 0, 1)).norm(), 1e-4);
    }
  }
}

}  // namespace
}  // namespace rigor::moved_anchors_test
