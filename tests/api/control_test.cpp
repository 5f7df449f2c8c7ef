#include "api/api_scenes.hpp"
#include "rigor/api/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::control_test {
namespace {

class EveryControlledScheme : public testing::TestWithParam<const char*> {
 public:
  Scene scene(const char* rest, double step = 0.01) const { return scene_with(GetParam(), rest, step); }
  bool is_of_32_bits() const { return std::string(GetParam()).find("substep") != std::string::npos; }
  double tolerance() const { return is_of_32_bits() ? 2e-5 : 1e-9; }
};

TEST_P(EveryControlledScheme, AnEffortIsATorqueAboutTheAxis) {
  Simulation simulation(scene(wheel_on_hinge));
  // ω = τ t / I, and the work is τ φ = ½ I ω².
  const double torque = 0.18;
  simulation.set_motor_effort("axle", torque);
  simulation.advance_to(0.5);
  const double rate = torque * 0.5 / wheel_moment;
  EXPECT_NEAR(simulation.angular_velocity("wheel").z(), rate, tolerance());
  const JointReaction axle = simulation.joint_forces("axle");
  EXPECT_NEAR(axle.rates[0], rate, tolerance());
  EXPECT_NEAR(axle.efforts[0], torque, 1e-12);
  simulation.set_motor_effort("axle", 0);
  simulation.advance_to(1);
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], rate, tolerance());
  EXPECT_NEAR(simulation.joint_motion("axle").coordinates[0], rate * 0.25 + rate * 0.5, 0.011);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(audit.report.work, 0.5 * wheel_moment * rate * rate, is_of_32_bits() ? 2e-3 : 1e-9);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, AnEffortActsOnceBesideAServoThatComesAndGoes) {
  // A servo with a largest force is a function of the time, for which the scheme is another one than without
  // it.
  const Scene two_wheels = scene(R"(
world: {gravity: [0, 0, 0]}
bodies:
  - {name: wheel, position: [0, 2, 1], mass: 2, shapes: [{type: cylinder, radius: 0.3, length: 0.1}]}
  - {name: other, position: [0, 0, 1], mass: 2, shapes: [{type: cylinder, radius: 0.3, length: 0.1}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 2, 1], axis: [0, 0, 1]}
  - {name: shaft, type: hinge, bodies: [world, other], anchor: [0, 0, 1], axis: [0, 0, 1]}
)");
  Simulation simulation(two_wheels);
  const double torque = 0.18;
  const auto rate = [&simulation] { return simulation.joint_motion("axle").rates[0]; };
  simulation.set_motor_position("shaft", 0.2, 5, 0.5, 0, 1);
  simulation.set_motor_effort("axle", torque);
  simulation.advance_to(0.1);
  EXPECT_NEAR(rate(), torque * 0.1 / wheel_moment, tolerance());
  Simulation restored(two_wheels);
  restored.restore(simulation.save());
  simulation.release_motor("shaft");
  restored.release_motor("shaft");
  simulation.advance_to(0.2);
  EXPECT_NEAR(rate(), torque * 0.2 / wheel_moment, tolerance());
  simulation.set_motor_position("shaft", 0, 5, 0.5, 0, 1);
  simulation.advance_to(0.3);
  EXPECT_NEAR(rate(), torque * 0.3 / wheel_moment, tolerance());
  restored.advance_to(0.2);
  restored.set_motor_position("shaft", 0, 5, 0.5, 0, 1);
  restored.advance_to(0.3);
  EXPECT_EQ(restored.velocities(), simulation.velocities());
  EXPECT_EQ(restored.positions(), simulation.positions());
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, ChangesInEachStepHaveTheBitsOfASimulationBegunAnew) {
  // Some steppers go on with what has changed; one that restores has a stepper of its own each time.
  const Scene busy = scene(busy_scene);
  Simulation kept(busy), anew(busy);
  for (int i = 0; i < 12; ++i) {
    anew.restore(anew.save());
    for (Simulation* own : {&kept, &anew}) {
      if (i % 3 == 0) own->set_motor_velocity("axle", 0.3 * i, 2);
      if (i % 3 == 1) own->set_motor_position("axle", 0.1 * i, 5, 0.5, 0, 1);
      if (i % 3 == 2) own->set_motor_position("axle", 0.1, 5 + i, 0.5);
      if (i % 4 == 1) own->set_motor_effort("axle", 0.1);
      if (i % 4 == 2) own->set_gravity(Vec3(0, 0.1 * i, -9));
      if (i == 5) own->set_friction("rubber", 0.2);
      if (i == 7) own->move_to("cart", {Mat3::Identity(), Vec3(0, -2, 1.2)}, 0.03);
      own->apply_force("box", Vec3(0.1 * i, 0, 1));
      own->step();
    }
    ASSERT_EQ(kept.positions(), anew.positions()) << "step " << i;
    ASSERT_EQ(kept.velocities(), anew.velocities()) << "step " << i;
    ASSERT_EQ(kept.angular_velocities(), anew.angular_velocities()) << "step " << i;
  }
}

TEST_P(EveryControlledScheme, AnEffortBetweenTwoBodiesKeepsTheirMomentum) {
  // A slider between two free bodies: the force acts on both, along the line through both anchors.
  Simulation simulation(scene(R"(
world: {gravity: [0, 0, 0]}
bodies:
  - {name: a, position: [0, 0, 0], mass: 1, angular_velocity: [0, 0, 0.5], velocity: [0, 0, 0], shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
  - {name: b, position: [1, 0, 0], mass: 3, angular_velocity: [0, 0, 0.5], velocity: [0, 0.5, 0], shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
joints:
  - {name: rail, type: slider, bodies: [a, b], anchor: [0.5, 0.3, 0], axis: [1, 0, 0]}
)",
                              0.001));
  const auto momentum = [&simulation] {
    return Vec3(simulation.velocity("a") + 3 * simulation.velocity("b"));
  };
  const auto about_origin = [&simulation] {
    const double I_a = 1 * 0.08 / 12, I_b = 3 * 0.08 / 12;
    return Vec3(simulation.position("a").cross(simulation.velocity("a")) +
                3 * simulation.position("b").cross(simulation.velocity("b")) +
                I_a * simulation.angular_velocity("a") + I_b * simulation.angular_velocity("b"));
  };
  const Vec3 before = momentum(), turning = about_origin();
  simulation.set_motor_effort("rail", 2);
  simulation.advance_to(0.2);
  EXPECT_LT((momentum() - before).norm(), 1e-4);
  EXPECT_LT((about_origin() - turning).norm(), is_of_32_bits() ? 1e-3 : 1e-4);
  EXPECT_GT(simulation.joint_motion("rail").rates[0], 0.4);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, AMotorFollowsTargetsAtRunTime) {
  Simulation simulation(scene(wheel_on_hinge));
  simulation.set_motor_velocity("axle", 4);
  simulation.advance_to(0.1);
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], 4, 1e-4);
  simulation.set_motor_velocity("axle", -1);
  simulation.advance_to(0.2);
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], -1, 1e-4);
  // With a limit: at τ / I = 1 rad/s² it takes its time.
  simulation.set_motor_velocity("axle", 1, wheel_moment);
  simulation.advance_to(1.2);
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], 0, 0.02);
  simulation.release_motor("axle");
  simulation.advance_to(1.5);
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], 0, 0.02);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, AMotorIsInPlaceOfTheLastOne) {
  // Each of the motors is set while the one before has not yet acted, and after it has.
  for (const bool acts : {false, true}) {
    Simulation simulation(scene(wheel_on_hinge));
    const auto act = [&] {
      if (acts) simulation.step();
    };
    simulation.set_motor_velocity("axle", 4);
    act();
    simulation.set_motor_position("axle", 1, 5, 1);
    act();
    simulation.set_motor_effort("axle", 0.3);
    act();
    simulation.set_motor_velocity("axle", -2);
    simulation.advance_to(0.5);
    EXPECT_NEAR(simulation.joint_motion("axle").rates[0], -2, 1e-4);
    EXPECT_NEAR(simulation.joint_forces("axle").efforts[0], 0, 1e-6);
    simulation.set_motor_effort("axle", 0.09);
    simulation.advance_to(1.5);
    EXPECT_NEAR(simulation.joint_motion("axle").rates[0], -1, 1e-4);
    EXPECT_NEAR(simulation.joint_forces("axle").efforts[0], 0.09, 1e-12);
    EXPECT_EQ(violations_of(simulation), "");
  }
}

TEST_P(EveryControlledScheme, APositionServoIsADampedOscillator) {
  Simulation simulation(scene(wheel_on_hinge, 0.001));
  // I φ'' = -k (φ - 1) - c φ' with ω = 10 rad/s, critically damped: φ = 1 - (1 + ω t) e^{-ω t}.
  const double rate = 10;
  simulation.set_motor_position("axle", 1, wheel_moment * rate * rate, 2 * wheel_moment * rate);
  for (const double t : {0.1, 0.3, 1.0}) {
    simulation.advance_to(t);
    EXPECT_NEAR(simulation.joint_motion("axle").coordinates[0], 1 - (1 + rate * t) * std::exp(-rate * t),
                6e-3)
        << t;
  }
  // A target that moves on is work.
  simulation.set_motor_position("axle", -1, wheel_moment * rate * rate, 2 * wheel_moment * rate);
  simulation.advance_to(2);
  EXPECT_NEAR(simulation.joint_motion("axle").coordinates[0], -1, 1e-3);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(audit.report.work, 0.5 * wheel_moment * rate * rate * (1 + 4), 0.05);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, AControllerIsAskedAtEachMultipleOfItsPeriod) {
  Simulation simulation(scene(floating_ball));
  std::vector<double> times;
  simulation.set_controller(
      [&times](Simulation& own) {
        times.push_back(own.time());
        own.apply_force("ball", Vec3(std::cos(own.time()), 0, 0));
      },
      0.025);
  for (const double t : {0.01, 0.05, 0.06, 0.2}) simulation.advance_to(t);
  ASSERT_EQ(times.size(), 8u);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_DOUBLE_EQ(times[k], 0.025 * static_cast<double>(k));
  // The impulse of a force that is held over each period: Σ cos(t_k) T.
  double impulse = 0;
  for (const double t : times) impulse += 0.025 * std::cos(t);
  EXPECT_NEAR(simulation.velocity("ball").x(), impulse, tolerance());
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, AControllerHoldsWhatWouldFall) {
  // A rod upright on a hinge, held by a torque at 200 Hz, pushed at the beginning.
  Simulation simulation(scene(R"(
bodies:
  - {name: rod, position: [0, 0, 0.5], mass: 1, angular_velocity: [0, 0.2, 0], velocity: [0.1, 0, 0], shapes: [{type: capsule, radius: 0.02, length: 0.96}]}
joints:
  - {name: pivot, type: hinge, bodies: [world, rod], anchor: [0, 0, 0], axis: [0, 1, 0]}
)",
                              0.005));
  simulation.set_controller([](Simulation& own) {
    const JointReaction pivot = own.joint_motion("pivot");
    own.set_motor_effort("pivot", -20 * pivot.coordinates[0] - 4 * pivot.rates[0]);
  });
  simulation.advance_to(3);
  EXPECT_NEAR(simulation.joint_motion("pivot").coordinates[0], 0, 1e-3);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryControlledScheme, AKinematicBodyGoesWhereItIsLed) {
  Simulation simulation(scene(R"(
world: {gravity: [0, 0, 0]}
bodies:
  - {name: paddle, motion: kinematic, position: [0, 0, 0], shapes: [{type: box, size: [0.1, 1, 1]}]}
  - {name: ball, position: [0.5, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
)"));
  simulation.advance_to(0.1);
  simulation.move_to("paddle", {Mat3::Identity(), Vec3(0.6, 0, 0)}, 0.5);
  simulation.advance_to(0.3);
  EXPECT_NEAR(simulation.position("paddle").x(), 0.24, 1e-6);
  EXPECT_NEAR(simulation.velocity("paddle").x(), 1.2, 1e-5);
  simulation.advance_to(0.7);
  EXPECT_NEAR(simulation.position("paddle").x(), 0.6, 1e-6);
  EXPECT_EQ(simulation.velocity("paddle").norm(), 0);
  // It struck the ball with e = 0, and supplied the energy.
  // Penalty springs let go of it with a rebound of some percent.
  EXPECT_NEAR(simulation.velocity("ball").x(), 1.2, 0.06);
  EXPECT_EQ(violations_of(simulation), "");
  simulation.set_velocity("paddle", Vec3(0, 0, 2), Vec3::Zero());
  simulation.advance_to(1.2);
  EXPECT_NEAR(simulation.position("paddle").z(), 1, 1e-6);
  simulation.set_pose("paddle", {Mat3::Identity(), Vec3(-5, 0, 0)});
  EXPECT_NEAR(simulation.position("paddle").x(), -5, 1e-12);
  simulation.advance_to(1.3);
  EXPECT_NEAR(simulation.position("paddle").x(), -5, 1e-12);
}

TEST_P(EveryControlledScheme, GravityAndSurfacesChangeOnTheWay) {
  Simulation simulation(scene(R"(
materials: [{name: ice, friction: 0, restitution: 0}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: ice}]}
  - {name: box, position: [0, 0, 0.1], velocity: [1, 0, 0], mass: 3, shapes: [{type: box, size: [0.2, 0.2, 0.2], material: ice}]}
)"));
  simulation.advance_to(0.5);
  EXPECT_NEAR(simulation.velocity("box").x(), 1, 1e-6);
  simulation.set_friction("ice", 0.1);
  simulation.advance_to(1);
  EXPECT_NEAR(simulation.velocity("box").x(), 1 - 0.1 * 9.80665 * 0.5, 0.03);
  simulation.set_gravity(Vec3(0, 0, 1));
  simulation.advance_to(2);
  // Slow collisions may throw it by as much as the resting velocity, twice.
  EXPECT_NEAR(simulation.velocity("box").z(), 1, 2e-3);
  EXPECT_EQ(violations_of(simulation), "");
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryControlledScheme, testing::ValuesIn(all_scheme_texts),
                         scheme_test_name);

}  // namespace
}  // namespace rigor::control_test
