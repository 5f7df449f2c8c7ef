// Steps of first order that an event of others cuts short: a shorter step of first order leads elsewhere than
// the path on which the others met the bodies.

#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <numbers>

namespace rigor::cut_steps_test {
namespace {

struct Coin {
  const char* name;
  double radius, thickness;
  Vec3 place;  ///< [m].
  double tilt;
  Vec3 velocity, spin;
};

/// Two coins that fall on a floor, roll, and meet.
std::shared_ptr<const Model> coins() {
  constexpr double density = 3185.1;
  ModelBuilder builder = test::stepping_builder(0, 0.9, Vec3(0, 0, -9.80665));
  const Coin both[] = {{"small",
                        0.028982,
                        0.0046586,
                        {0.3, 0, 0.0480473408989},
                        0.43120950148,
                        {0.199632504736, 0.076601526885, 0},
                        {2.82331055269, 0.724990094395, -13.3378240915}},
                       {"large",
                        0.046768,
                        0.0078874,
                        {0.45, 0, 0.0772741160083},
                        0.789349383352,
                        {0.119654120777, 0.265547216918, 0},
                        {1.57516116537, -4.9933455029, 55.8015461982}}};
  for (const Coin& coin : both) {
    BodyDescription body =
        test::stepping_body(coin.name, Cylinder{coin.radius, 0.5 * coin.thickness}, coin.place);
    body.mass = density * std::numbers::pi * coin.radius * coin.radius * coin.thickness;
    body.q_WU = Eigen::AngleAxisd(coin.tilt, Vec3::UnitX());
    body.velocity = coin.velocity;
    body.angular_velocity = coin.spin;
    builder.add_body(body);
  }
  return builder.build();
}

TEST(CutSteps, EndOnThePathOnWhichOthersMetTheirBodies) {
  const std::shared_ptr<const Model> model = coins();
  State state = make_initial_state(*model);
  const Method method;
  EventDrivenStepper stepper(model, method, 0.01);
  const AdvanceReport report = stepper.advance(state, 0.56);
  ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
  EXPECT_GT(report.coarse_steps, 100);
  EXPECT_LE(report.max_penetration, method.contact_tolerance);
}

}  // namespace
}  // namespace rigor::cut_steps_test
