// Stiff springs and dampers of a scene, and the steps that the penalty scheme takes for them.

#include "sim/time_stepping_scenes.hpp"

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/penalty/force_rates.hpp"
#include "rigor/sim/report/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace rigor::force_rates_test {
namespace {

/// A ball of 10 g, 0.1 m off the end of its spring, without gravity.
std::shared_ptr<const Model> ball_on_a_spring(double stiffness, double damping) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  BodyDescription ball = test::stepping_body("ball", Sphere{0.1}, Vec3(0.6, 0, 0));
  ball.mass = 0.01;
  builder.add_body(ball);
  ModelBuilder::ForceDescription spring{ModelBuilder::ForceDescription::Type::spring};
  spring.bodies = {"world", "ball"};
  spring.points = {Vec3::Zero(), Vec3::Zero()};
  spring.stiffness = stiffness;
  spring.damping = damping;
  spring.length = 0.5;
  builder.add_force(spring);
  return builder.build();
}

TEST(ForceRates, AreTwiceTheStiffnessOverTheMassOfASingleSpring) {
  const auto rates_of = [](const std::shared_ptr<const Model>& model) {
    return rates_of_forces(*model, Environment(*model), 0.01);
  };
  const PenaltyRates rates = rates_of(ball_on_a_spring(1000, 0.5));
  EXPECT_NEAR(rates.frequency, std::sqrt(2 * 1000 / 0.01), 1e-9);
  EXPECT_NEAR(rates.damping, 2 * 0.5 / 0.01, 1e-9);
  const PenaltyRates none = rates_of(ball_on_a_spring(0, 0));
  EXPECT_EQ(none.frequency, 0);
  EXPECT_EQ(none.damping, 0);
}

/// Two rods of 0.1 kg in a row with a hinge between them that damps; the second one rotates.
std::shared_ptr<const Model> damped_rods(double stiffness, double damping) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  for (int i = 0; i < 2; ++i) {
    BodyDescription rod =
        test::stepping_body("rod" + std::to_string(i), Box{Vec3(0.05, 0.01, 0.01)}, Vec3(0.1 * i, 0, 0));
    rod.mass = 0.1;
    rod.angular_velocity = Vec3(0, 0, i);
    rod.velocity = Vec3(0, 0.05 * i, 0);
    builder.add_body(rod);
  }
  ModelBuilder::JointDescription hinge;
  hinge.name = "hinge";
  hinge.type = JointType::hinge;
  hinge.bodies = {"rod0", "rod1"};
  hinge.anchors = {Vec3(0.05, 0, 0)};
  hinge.axis = Vec3::UnitZ();
  hinge.axes = {JointAxis{}};
  hinge.axes[0].stiffness = stiffness;
  hinge.axes[0].damping = damping;
  builder.add_joint(hinge);
  return builder.build();
}

TEST(ForceRates, OfAHingeFollowFromTheMomentsAboutItsAxis) {
  const double moment = 0.1 / 3 * (0.05 * 0.05 + 0.01 * 0.01);
  const std::shared_ptr<const Model> model = damped_rods(7, 0.3);
  const PenaltyRates rates = rates_of_forces(*model, Environment(*model), 0.01);
  EXPECT_NEAR(rates.frequency, std::sqrt(2 * 7 / moment), 1e-9 * rates.frequency);
  EXPECT_NEAR(rates.damping, 2 * 0.3 / moment, 1e-9 * rates.damping);
}

TEST(ForceRates, KeepStiffJointsStableUnderPenaltyAtLongSteps) {
  // Rates of c/I = 3500 /s and √(k/I) = 340 /s against steps of 0.01 s.
  for (const auto& [stiffness, damping] : {std::pair(0.0, 0.3), std::pair(10.0, 0.0)}) {
    const std::shared_ptr<const Model> model = damped_rods(stiffness, damping);
    const Environment environment(*model);
    Method method;
    method.scheme = Scheme::penalty;
    State state = make_initial_state(*model);
    const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
    const double before = mechanical_energy(*model, environment, state).total();
    for (int k = 1; k <= 10; ++k) {
      EXPECT_EQ(stepper->advance(state, 0.02 * k).reason, StopReason::reached_end);
      // What swings is off by (ω h)²/4 of its energy at most.
      EXPECT_LE(mechanical_energy(*model, environment, state).total(), before * (1 + 0.25 * 0.05 * 0.05))
          << k;
    }
    const double after = mechanical_energy(*model, environment, state).total();
    if (damping > 0) {
      EXPECT_LT(after, 0.9 * before);
    }
  }
}

TEST(ForceRates, KeepAStiffSpringStableUnderPenaltyAtLongSteps) {
  // ω = 316 /s: explicit steps of 0.01 s would multiply the energy each time.
  const std::shared_ptr<const Model> model = ball_on_a_spring(1000, 0);
  const Environment environment(*model);
  Method method;
  method.scheme = Scheme::penalty;
  State state = make_initial_state(*model);
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
  for (int k = 1; k <= 20; ++k) {
    EXPECT_EQ(stepper->advance(state, 0.05 * k).reason, StopReason::reached_end);
    // The bound of ω is √2 ω, and its steps swing with an energy that is off by (ω h)²/4 at most.
    constexpr double share = 0.25 * 0.05 * 0.05 / 2;
    EXPECT_NEAR(mechanical_energy(*model, environment, state).total(), 0.5 * 1000 * 0.01, share * 5) << k;
  }
}

}  // namespace
}  // namespace rigor::force_rates_test
