// Stiff springs and dampers of a scene, and the steps that the penalty scheme takes for them.

#include "sim/time_stepping_scenes.hpp"

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/penalty/force_rates.hpp"
#include "rigor/sim/report/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
