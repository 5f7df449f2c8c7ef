// Heavy bodies on chains of light ones: what they pull taut vibrates faster than substeps can follow.

#include "random_vectors.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"
#include "sim/bulk/substep_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

namespace rigor::bulk_taut_chains_test {
namespace {

constexpr double gravity = 9.81, ball_radius = 0.3;

struct Wrecker {
  int links;
  double length;     ///< Of a link [m].
  double ball_mass;  ///< [kg].
  double link_mass;  ///< [kg].
  JointType joint;
  int rows;  ///< Of bricks that the ball hits.
  double scale() const { return ball_mass * gravity * (links * length + ball_radius); }  ///< [J].
};

/// A chain that is released from the horizontal with a ball at its end.
std::shared_ptr<const Model> build(const Wrecker& own) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -gravity));
  builder.add_body({.name = "floor", .motion = MotionType::fixed, .shapes = {{HalfSpace{Vec3::UnitZ(), 0}}}});
  const Vec3 hook(0, 0, own.links * own.length + ball_radius + 0.6);
  for (int k = 0; k <= own.links; ++k) {
    const bool is_ball = k == own.links;
    const std::string name = "l" + std::to_string(k);
    BodyDescription body;
    body.name = name;
    body.p_WU = hook - Vec3(0, k * own.length + (is_ball ? ball_radius : own.length / 2), 0);
    body.q_WU = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
    body.mass = is_ball ? own.ball_mass : own.link_mass;
    if (is_ball) {
      body.shapes = {{Sphere{ball_radius}}};
    } else {
      body.shapes = {{Capsule{0.1 * own.length, 0.3 * own.length}}};
    }
    builder.add_body(body);
    ModelBuilder::JointDescription joint;
    joint.name = "j" + name;
    joint.type = own.joint;
    joint.bodies = {k == 0 ? "world" : "l" + std::to_string(k - 1), name};
    joint.anchors = {hook - Vec3(0, k * own.length, 0)};
    if (own.joint == JointType::hinge) joint.axis = Vec3::UnitX();
    builder.add_joint(joint);
  }
  for (int row = 0; row < own.rows; ++row) {
    for (int k = -1; k <= 1; ++k) {
      BodyDescription brick;
      brick.name = "b" + std::to_string(row) + "_" + std::to_string(k);
      brick.p_WU = Vec3(0.5 * k, 0.35, 0.3 * row + 0.15);
      brick.shapes = {{Box{Vec3(0.25, 0.15, 0.15)}}};
      brick.density = 1000;
      builder.add_body(brick);
    }
  }
  return builder.build();
}

/// Changes of the energy, as parts of the scene's scale.
test::EnergyChange energy_change(const Wrecker& own, double step, double time) {
  const test::EnergyChange change = test::substep_energy_change(build(own), step, time);
  return {change.rise / own.scale(), change.last / own.scale()};
}

/// most_ratio: of the ball and a link, as a power of ten.
Wrecker random_wrecker(test::Random& random, int rows, double most_ratio) {
  const double ball_mass = std::pow(10, random.uniform(1, 4));
  return {.links = 2 + static_cast<int>(random.uniform(0, 8)),
          .length = random.uniform(0.1, 0.3),
          .ball_mass = ball_mass,
          .link_mass = ball_mass / std::pow(10, random.uniform(2, most_ratio)),
          .joint = random.uniform(0, 1) < 0.5 ? JointType::ball : JointType::hinge,
          .rows = rows};
}

TEST(BulkTautChains, SwingAsPendulumsDo) {
  test::Random random(31);
  for (int k = 0; k < 12; ++k) {
    const Wrecker own = random_wrecker(random, 0, 5);
    const double step = random.uniform(0.005, 0.0167);
    SCOPED_TRACE(testing::Message() << own.links << " links, 1:" << own.ball_mass / own.link_mass << ", "
                                    << step);
    const test::EnergyChange change = energy_change(own, step, 1.5);
    // Steps that push before joints hold know the energy to h g v m, here h/6 and v <= 7 m/s.
    EXPECT_LE(std::abs(change.last), 0.02);
    EXPECT_LE(change.rise, 0.02);
  }
}

/// Where the ball is after `time` [s].
Vec3 ball_after(const std::shared_ptr<const Model>& model, const Method& method, double step, double time) {
  RunSettings settings;
  settings.duration = time;
  settings.step = step;
  settings.output_interval = time;
  Vec3 x = Vec3::Zero();
  const auto note = [&](const State& state, const AdvanceReport&, const Auditor&) {
    x = state.position(model->body_count() - 1);
    return true;
  };
  run_simulation(model, method, settings, std::nullopt, note);
  return x;
}

TEST(BulkTautChains, CarryTheBallWhereEventsDo) {
  test::Random random(33);
  for (int k = 0; k < 6; ++k) {
    const Wrecker own = random_wrecker(random, 0, 4);
    const double step = random.uniform(0.005, 0.0167), time = 0.5;
    SCOPED_TRACE(testing::Message() << own.links << " links, 1:" << own.ball_mass / own.link_mass);
    const std::shared_ptr<const Model> model = build(own);
    Method substep, events;
    substep.scheme = Scheme::time_stepping;
    substep.solver = SolverMethod::substep;
    events.scheme = Scheme::event_driven;
    const Vec3 x = ball_after(model, substep, step, time), exact = ball_after(model, events, 0.01, time);
    // Steps of Euler's method are ahead by half a substep: h g t / 2.
    EXPECT_LE((x - exact).norm(), 1.2 * step / 6 * gravity * time / 2);
    EXPECT_GT((exact - model->body(model->body_count() - 1).p_WB).norm(), 0.5);
  }
}

TEST(BulkTautChains, StrikeWallsWithoutBreakingOut) {
  test::Random random(32);
  for (int k = 0; k < 24; ++k) {
    const Wrecker own = random_wrecker(random, 3, 3.3);
    const double step = random.uniform(0.005, 0.0167);
    SCOPED_TRACE(testing::Message() << k << ": " << own.links << " links, 1:" << own.ball_mass / own.link_mass
                                    << ", " << step);
    EXPECT_LE(energy_change(own, step, 1.5).rise, 0.05);
  }
}

}  // namespace
}  // namespace rigor::bulk_taut_chains_test
