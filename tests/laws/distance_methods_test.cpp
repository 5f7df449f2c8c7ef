// A scene gives the same motion whatever finds the distances of its polyhedra.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/audit_json.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace rigor::distance_methods_test {
namespace {

/// A box, a tetrahedron and an octahedron in space that strike one another and tumble away.
Scene tumblers(const std::string& distance) {
  return parse_scene("rigor: 1\nname: tumblers\nmethod: {distance: " + distance + R"(}
run: {duration: 2, step: 0.05, output_interval: 0.5}
world: {gravity: [0, 0, 0]}
materials: [{name: m, density: 1000, friction: 0.2, restitution: 0.9}]
bodies:
  - {name: box, position: [0, 0, 0], rpy: [0.3, 0.2, 0.1], angular_velocity: [0.5, 1, 0.3],
     shapes: [{type: box, size: [0.3, 0.4, 0.5], material: m}]}
  - {name: tetrahedron, position: [1, 0.1, 0.05], velocity: [-1, 0, 0], angular_velocity: [3, 1, -2],
     shapes: [{type: convex, material: m,
               vertices: [[0.3, 0, 0], [-0.2, 0.3, 0], [-0.2, -0.2, 0.1], [0, 0, -0.3]]}]}
  - {name: octahedron, position: [0.1, 1, -0.05], velocity: [0, -0.8, 0.05], angular_velocity: [-1, 2, 1],
     shapes: [{type: convex, material: m,
               vertices: [[0.2, 0, 0], [-0.2, 0, 0], [0, 0.25, 0], [0, -0.25, 0], [0, 0, 0.3], [0, 0, -0.3]]}]}
)",
                     "tumblers.yaml", ".");
}

RunResult run(const Scene& scene, double duration, const std::optional<State>& start = std::nullopt) {
  RunSettings settings = scene.run;
  settings.duration = duration;
  return run_simulation(scene.model, scene.method, settings, start,
                        [](const State&, const AdvanceReport&, const Auditor&) { return true; });
}

TEST(DistanceMethods, WalkAndGjkGiveTheSameMotionToRounding) {
  const RunResult gjk = run(tumblers("gjk"), 2), walk = run(tumblers("lin-canny"), 2);
  EXPECT_EQ(walk.audit.report.reason, StopReason::reached_end);
  EXPECT_TRUE(walk.audit.violations.empty());
  EXPECT_GE(walk.audit.report.impacts, 2);
  EXPECT_EQ(walk.audit.report.impacts, gjk.audit.report.impacts);
  for (std::size_t i = 0; i < walk.audit.bodies.size(); ++i) {
    const Audit::BodyEnd &a = walk.audit.bodies[i], &b = gjk.audit.bodies[i];
    // Times of impact differ by rounding, and each impact of bodies that tumble makes that some ten times
    // more.
    EXPECT_LT((a.position - b.position).norm(), 1e-10) << a.name;
    EXPECT_LT((a.velocity - b.velocity).norm(), 1e-10) << a.name;
  }
}

TEST(DistanceMethods, TheAuditNamesTheOneThatWasUsed) {
  for (const std::string name : {"gjk", "lin-canny"}) {
    const RunResult result = run(tumblers(name), 0.1);
    EXPECT_EQ(nlohmann::json::parse(audit_json(result.audit)).at("method").at("distance"), name);
  }
}

TEST(DistanceMethods, ARunByTheWalkInPartsEndsAsTheRunInOneGoBitForBit) {
  const Scene scene = tumblers("lin-canny");
  const RunResult whole = run(scene, 2);
  const RunResult first = run(scene, 1);
  EXPECT_EQ(run(tumblers("lin-canny"), 2, first.state).state, whole.state);
  EXPECT_EQ(run(scene, 2).state, whole.state);
}

}  // namespace
}  // namespace rigor::distance_methods_test
