// The time in which a slip would end bounds the first try of a step, since its direction is singular as near
// as that.

#include "random_vectors.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/sim/islands/island_integrator.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::slip_time_test {
namespace {

constexpr double half_edge = 0.1, g = 9.81, infinite = std::numeric_limits<double>::infinity();

/// A step of 0.01 s at most of a cube that slides straight on along x.
ControlledStep step_of_cube(double friction, double speed, double suggested = 0.01,
                            double slip_time_before = infinite) {
  ModelBuilder builder = test::stepping_builder(0, friction, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("cube", Box{Vec3::Constant(half_edge)}, Vec3(0, 0, half_edge)));
  const std::shared_ptr<const Model> model = builder.build();
  const Environment environment(*model);
  const ContactSystemAssembler assembler(*model, environment);
  const Method method;
  const IslandIntegrator integrator(*model, environment, assembler, method);
  Island island;
  island.bodies = {1};
  BodyPhase start;
  start.x = Vec3(0, 0, half_edge);
  start.P = model->body(1).mass * speed * Vec3::UnitX();
  island.start = {start};
  island.contacts = find_contacts(*model, 0, 1, {}, Pose{Mat3::Identity(), start.x}, 1e-6);
  const ContactSystem system = assembler.assemble(0, island.bodies, island.start, island.contacts);
  island.states =
      solve_resting(system, assembler.environment_wrenches(system, 0), direction_tolerance(method)).states;
  const double longest = 0.01;
  return integrator.controlled_step(island, suggested, {1e-12, longest, longest, true, slip_time_before});
}

TEST(SlipTime, IsThatInWhichFrictionStopsTheSlip) {
  test::Random random(23);
  for (int k = 0; k < 50; ++k) {
    SCOPED_TRACE(k);
    const double friction = random.uniform(0.1, 0.8), speed = std::pow(10, random.uniform(-5, 1));
    const double slip_time = speed / (friction * g);
    const ControlledStep taken = step_of_cube(friction, speed);
    EXPECT_NEAR(taken.slip_time, slip_time, 1e-9 * slip_time);
    // Nothing suggests a length, or nothing slid where something did.
    EXPECT_LE(taken.step.h, slip_time * (1 + 1e-9));
    // In proportion to the slip times, within bounds: a straight slip is followed exactly, and no try
    // rejected.
    const double suggested = std::min(1e-3, 0.1 * slip_time);
    EXPECT_NEAR(step_of_cube(friction, speed, suggested, 0.8 * slip_time).step.h, suggested / 0.8,
                1e-9 * suggested);
    EXPECT_NEAR(step_of_cube(friction, speed, suggested, 1e-3 * slip_time).step.h, 2 * suggested,
                1e-9 * suggested);
    EXPECT_NEAR(step_of_cube(friction, speed, suggested, 1e3 * slip_time).step.h, 0.2 * suggested,
                1e-9 * suggested);
  }
}

TEST(SlipTime, IsInfiniteWithoutFriction) {
  const ControlledStep taken = step_of_cube(0, 1e-4);
  EXPECT_EQ(taken.slip_time, infinite);
  EXPECT_EQ(taken.step.h, 0.01);
}

}  // namespace
}  // namespace rigor::slip_time_test
