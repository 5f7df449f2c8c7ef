// Stiff springs that press bodies on each other, at steps much longer than their periods.

#include "rigor/sim/time_stepping/time_stepper.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::implicit_springs_test {
namespace {

constexpr double g = 9.81;

Method stepping() {
  Method method;
  method.scheme = Scheme::time_stepping;
  return method;
}

const Shape kBlock = Box{Vec3(0.2, 0.2, 0.1)};

BodyDescription block(const char* name, double z, const Vec3& v = Vec3::Zero()) {
  BodyDescription body = test::stepping_body(name, kBlock, Vec3(0, 0, z));
  body.velocity = v;
  return body;
}

ModelBuilder::ForceDescription spring(const std::vector<std::string>& bodies, const std::vector<Vec3>& points,
                                      double stiffness, double length) {
  ModelBuilder::ForceDescription force{ModelBuilder::ForceDescription::Type::spring, bodies, points};
  force.stiffness = stiffness;
  force.length = length;
  return force;
}

/// A block of 1 kg on the floor under a spring from far above, which presses on its centre with this force.
std::shared_ptr<const Model> pressed_block(double stiffness, double force, double mu, const Vec3& v) {
  constexpr double length = 100;
  ModelBuilder builder = test::stepping_builder(0, mu, Vec3(0, 0, -g));
  builder.add_body(block("block", 0.1, v));
  builder.add_force(
      spring({"world", "block"}, {Vec3(0, 0, 0.1 + length)}, stiffness, length + force / stiffness));
  return builder.build();
}

TEST(ImplicitSprings, StiffSpringHoldsABlockOnTheFloorAtAnyStep) {
  for (const double stiffness : {1e4, 1e7, 1e10}) {
    for (const double h : {0.1, 1.0 / 60, 1e-3}) {
      const std::shared_ptr<const Model> model = pressed_block(stiffness, 50, 0.5, Vec3::Zero());
      State state = make_initial_state(*model);
      const AdvanceReport report = TimeStepper(model, stepping(), h).advance(state, 1);
      EXPECT_LT((state.position(1) - Vec3(0, 0, 0.1)).norm(), 1e-9) << stiffness << " " << h;
      EXPECT_LT(state.linear_momentum(1).norm(), 1e-9) << stiffness << " " << h;
      // One problem a step: the spring's periods are not followed.
      EXPECT_LE(report.steps, 1.01 / h + 1) << stiffness << " " << h;
      EXPECT_LT(report.momentum_error.norm(), 1e-9);
    }
  }
}

TEST(ImplicitSprings, FrictionFeelsTheForceOfTheSpring) {
  // (m g + f) μ brakes; the tilt of the spring turns f by x / length, and adds k x² / (2 length) to it.
  const double mu = 0.3, f = 20, v = 0.5, t = 0.05, h = 0.005, k = 1e6;
  const std::shared_ptr<const Model> model = pressed_block(k, f, mu, Vec3(v, 0, 0));
  State state = make_initial_state(*model);
  TimeStepper(model, stepping(), h).advance(state, t);
  const double a = mu * (g + f), way = v * t - 0.5 * a * t * t;
  EXPECT_NEAR(state.linear_momentum(1).x(), v - a * t, t * (f * way / 100 + mu * k * way * way / 200));
  EXPECT_LT(std::abs(state.position(1).z() - 0.1), 1e-9);
}

TEST(ImplicitSprings, BlockOnAStiffSpringKeepsItsEnergyAboveAPressedOne) {
  // Two blocks joined by a spring far stiffer than the step: the upper one rests on it.
  const double k = 1e8, length = 1;
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  builder.add_body(block("low", 0.1));
  builder.add_body(block("high", 0.1 + length - g / k));
  builder.add_force(spring({"low", "high"}, {}, k, length));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  TimeStepper(model, stepping(), 1.0 / 60).advance(state, 1);
  EXPECT_NEAR(state.position(2).z(), 0.1 + length - g / k, 1e-12);
  EXPECT_NEAR(state.position(1).z(), 0.1, 1e-12);

  // Kicked, it swings about there with the energy of the kick.
  state.set_body(2, state.position(2), state.orientation(2), Vec3(0, 0, 1e-3), Vec3::Zero());
  double highest = 0;
  TimeStepper stepper(model, stepping(), 1.0 / 60);
  for (int i = 1; i <= 60; ++i) {
    stepper.advance(state, 1 + i / 60.0);
    const double x = state.position(2).z() - (0.1 + length - g / k);
    const double energy = 0.5 * (state.linear_momentum(2).squaredNorm() + k * x * x);
    highest = std::max(highest, energy);
  }
  EXPECT_LE(highest, 0.5e-6 * (1 + 1e-6));
}

}  // namespace
}  // namespace rigor::implicit_springs_test
