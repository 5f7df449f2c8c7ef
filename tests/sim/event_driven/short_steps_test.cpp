// A tiny, fast spinning cone that slides on a rim without friction: its normal force turns with its spin,
// faster than the shortest accurate step follows. Explicit stages fed on their own error there and added any
// energy.

#include "random_vectors.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/report/energy.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace rigor::short_steps_test {
namespace {

constexpr double half_plate = 0.001;  // [m].

/// A case on which the stages diverged, each of its numbers moved by up to a thousandth.
std::shared_ptr<const Model> spinning_cone(test::Random& random) {
  const auto near = [&](double x) { return x * (1 + 1e-3 * random.uniform(-1, 1)); };
  const auto near_vector = [&](double x, double y, double z) { return Vec3(near(x), near(y), near(z)); };
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 3903.29, 0, 0});
  BodyDescription plate = test::stepping_body("plate", Box{Vec3(45, 45, half_plate)}, Vec3::Zero());
  plate.motion = MotionType::fixed;
  plate.mass = {};
  builder.add_body(plate);
  BodyDescription cone = test::stepping_body("cone", Cone{near(0.00179969812), 0.5 * near(0.00340950007)},
                                             near_vector(-0.766297601, 0.552700659, 2.59632716));
  cone.mass = {};
  const Vec3 rpy = near_vector(1.51609276, 0.146451506, -2.97603964);
  cone.q_WU = Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(rpy.x(), Vec3::UnitX());
  cone.velocity = near_vector(-280.687251, -134.985416, -207.275761);
  cone.angular_velocity = near_vector(89.7201749, 90.4160683, 124.14567);
  builder.add_body(cone);
  return builder.build();
}

TEST(ShortSteps, ThatLoseTheirDigitsAddNoEnergy) {
  test::Random random(24669);
  constexpr double step = 1.0 / 60;
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = spinning_cone(random);
    const Environment environment(*model);
    State state = make_initial_state(*model);
    EventDrivenStepper stepper(model, {}, step);
    double energy = mechanical_energy(*model, environment, state).total();
    for (const double until : {1 * step, 2 * step, 3 * step, 3.55 * step}) {
      const AdvanceReport report = stepper.advance(state, until);
      ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
      const double after = mechanical_energy(*model, environment, state).total();
      EXPECT_LE(after, energy + 1e-9 * std::abs(energy));
      energy = after;
    }
  }
}

}  // namespace
}  // namespace rigor::short_steps_test
