// A ball in a spherical bowl: rolling it is a pendulum of length (R - r)(1 + k), sliding one of length R - r.

#include "laws/scene_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

namespace rigor::test::bowl_test {
namespace {

constexpr double g = 9.81;

/// Period of a pendulum of this length let go at this angle: 4 sqrt(length/g) K(sin(angle/2)), K by the
/// arithmetic-geometric mean.
double pendulum_period(double length, double angle) {
  double a = 1, b = std::cos(angle / 2);
  for (int k = 0; k < 10; ++k) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 4 * std::sqrt(length / g) * std::numbers::pi / (2 * a);
}

/// The shipped scene with the ball let go at this angle and this friction, for this long.
SceneRun run_bowl(double angle, double friction, double duration) {
  const auto text = [](const auto&... parts) {
    std::ostringstream stream;
    stream.precision(17);
    (stream << ... << parts);
    return stream.str();
  };
  return run_scene("bowl.yaml", {text("bodies.ball.position=[", 0.9 * std::sin(angle), ", 0, ",
                                      -0.9 * std::cos(angle), "]"),
                                 text("materials.cork.friction=", friction), text("run.duration=", duration),
                                 text("run.output_interval=", duration)});
}

TEST(Bowl, PeriodsAreThoseOfTheCatalogue) {
  EXPECT_NEAR(pendulum_period(1.26, 0), 2.251804264272623, 1e-14);
  EXPECT_NEAR(pendulum_period(1.26, 40 * std::numbers::pi / 180), 2.322376978894158, 1e-14);
}

TEST(Bowl, ARollingBallIsAtTheBottomAfterFiveQuarters) {
  // There it is fastest: an error of the period shows at once.
  for (const double degrees : {0.1, 40.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const SceneRun run = run_bowl(angle, 1, 1.25 * pendulum_period(1.26, angle));
    const Audit::BodyEnd& ball = run.end_of("ball");
    EXPECT_NEAR(ball.position.x() / ball.velocity.x(), 0, 1e-9) << degrees << ": time off [s]";
    EXPECT_NEAR(ball.position.z(), -0.9, 1e-9) << degrees;
    EXPECT_TRUE(run.audit().violations.empty());
    // Energy: the height has become motion, v² (1 + 2/5) = 2 g h.
    EXPECT_NEAR(-ball.velocity.x(), std::sqrt(2 * g * 0.9 * (1 - std::cos(angle)) / 1.4), 1e-9) << degrees;
  }
}

TEST(Bowl, ASlidingBallDoesNotTurnAndSwingsFaster) {
  const double angle = 40 * std::numbers::pi / 180;
  const SceneRun run = run_bowl(angle, 0, 1.25 * pendulum_period(0.9, angle));
  EXPECT_NEAR(run.end_of("ball").position.x(), 0, 1e-9);
  // Gaps that are kept move the ball against the moment of its momentum about the origin, by the error of the
  // steps.
  EXPECT_LE(run.end_of("ball").angular_velocity.norm(), 1e-8);
}

TEST(Bowl, TheSceneEndsWhereItBegan) {
  const SceneRun run = run_scene("bowl.yaml");
  const Vec3 start(0.9 * std::sin(40 * std::numbers::pi / 180), 0,
                   -0.9 * std::cos(40 * std::numbers::pi / 180));
  EXPECT_LE((run.end_of("ball").position - start).norm(), 1e-9);
}

TEST(Bowl, ShapesThatCannotTouchACavityAreRefused) {
  const std::string text = R"(
rigor: 1
bodies:
  - {name: room, motion: static, shapes: [{type: cavity, radius: 1}]}
  - {name: egg, shapes: [{type: ellipsoid, radii: [0.1, 0.2, 0.3]}]}
)";
  try {
    parse_scene(text, "scene.yaml", ".");
    FAIL() << "must be refused";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what())
                  .find("scene.yaml:5:5: body 'egg': its ellipsoid cannot collide with the cavity of "
                        "body 'room'; spheres, capsules, boxes, convex shapes and meshes can"),
              std::string::npos)
        << error.what();
  }
}

TEST(Bowl, BoxesAndCapsulesComeToRestInIt) {
  const std::string text = R"(
rigor: 1
world: {gravity: [0, 0, -9.81]}
run: {duration: 6, output_interval: 1}
materials: [{name: m, friction: 0.6, restitution: 0.3}]
bodies:
  - {name: room, motion: static, shapes: [{type: cavity, radius: 1, material: m}]}
  - {name: box, position: [0.2, 0.1, -0.4], rpy: [0.6, 0.3, 0.4], mass: 1,
     shapes: [{type: box, size: [0.3, 0.4, 0.2], material: m}]}
  - {name: rod, position: [-0.3, 0, -0.2], rpy: [0.2, 1.0, 0.4], mass: 1,
     shapes: [{type: capsule, radius: 0.05, length: 0.5, material: m}]}
)";
  SceneRun run;
  run.scene = parse_scene(text, "scene.yaml", ".");
  run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt,
                              [](const State&, const AdvanceReport&, const Auditor&) { return true; });
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  EXPECT_TRUE(run.audit().violations.empty());
  EXPECT_LE(run.audit().report.max_penetration, 1e-6);
  for (const char* name : {"box", "rod"}) EXPECT_LE(run.end_of(name).velocity.norm(), 1e-6) << name;
}

}  // namespace
}  // namespace rigor::test::bowl_test
