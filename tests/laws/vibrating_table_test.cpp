// A ball that bounces on a vibrating table, once each period.

#include "laws/scene_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace rigor::test::vibrating_table_test {
namespace {

constexpr double g = 9.81;

TEST(VibratingTable, HoldsTheBallOnItsOrbitForTwoHundredPeriods) {
  // z = A sin(ω t + φ), 2 mm and 20 Hz. The ball leaves at g T/2 and comes back at -g T/2, so with
  // restitution e the table must move at V = (1 - e)/(1 + e) g T/2 = A ω cos φ. A table of 10⁹ times the
  // ball's mass on a spring.
  const double A = 0.002, omega = 2 * M_PI * 20, T = 0.05, e = 0.5;
  const double V = (1 - e) / (1 + e) * g * T / 2, cosine = V / (A * omega);
  EXPECT_NEAR(cosine, 0.3252729149440611, 1e-15);
  const double z = A * std::sqrt(1 - cosine * cosine), mass = 1e6, stiffness = mass * omega * omega;
  // The spring hangs the table from a point 1 m above; its rest length lets it stand at z = 0 under gravity.
  const double rest = 1 - g / (omega * omega);
  std::ostringstream text;
  text.precision(17);
  text << "rigor: 1\nworld: {gravity: [0, 0, -9.81]}\nrun: {duration: 10.02, step: 0.001, output_interval: "
          "0.05}\n"
       << "method: {tolerance: 1e-12}\nmaterials: [{name: m, friction: 0, restitution: 0.5}]\nbodies:\n"
       << "  - {name: table, position: [0, 0, " << z << "], velocity: [0, 0, " << V << "], mass: " << mass
       << ", shapes: [{type: box, size: [1, 1, 0.1], position: [0, 0, -0.05], material: m}]}\n"
       << "  - {name: ball, position: [0, 0, " << z + 0.01 << "], velocity: [0, 0, " << g * T / 2
       << "], mass: 0.001, shapes: [{type: sphere, radius: 0.01, material: m}]}\n"
       << "forces:\n  - {type: spring, between: [world, table], points: [[0, 0, 1], [0, 0, 0]], stiffness: "
       << stiffness << ", damping: 0, length: " << rest << "}\n";
  SceneRun run;
  run.scene = parse_scene(text.str(), "table.yaml", ".");
  const Observer observer = [&](const State&, const AdvanceReport& since, const Auditor&) {
    run.events.insert(run.events.end(), since.events.begin(), since.events.end());
    return true;
  };
  run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt, observer);
  ASSERT_EQ(run.audit().report.impacts, 200);
  double k = 0;
  for (const MotionEvent& event : run.events) {
    if (event.kind != MotionEvent::Kind::impact) continue;
    ++k;
    EXPECT_NEAR(event.time, k * T, 1e-6 * T) << k;
    // Impulse (1 + e) m times the relative speed of impact.
    EXPECT_NEAR(event.j_W.norm(), (1 + e) * 0.001 * 0.327, 1e-6 * 0.001) << k;
  }
}

}  // namespace
}  // namespace rigor::test::vibrating_table_test
