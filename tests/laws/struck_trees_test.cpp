// Trees of joints of many types whose bodies fall on a floor with friction, at limits that bounce: every
// impact finds its impulses.

#include "random_vectors.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rigor::struck_trees_test {
namespace {

std::string vector_text(const Vec3& v) {
  return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", v.x(), v.y(), v.z());
}

/// What the joint to a body is, besides the bodies that it joins.
std::string joint_text(test::Random& random, const Vec3& anchor) {
  const Vec3 axis = random.vector().normalized();
  const std::string at = ", anchor: " + vector_text(anchor), along = ", axis: " + vector_text(axis);
  const std::string across = ", second_axis: " + vector_text(axis.unitOrthogonal());
  const auto limits = [&] {
    return fmt::format("{{limits: [{:.4g}, {:.4g}], restitution: {:.3g}}}", random.uniform(-0.9, -0.2),
                       random.uniform(0.2, 0.9), random.uniform(0, 1));
  };
  const auto sprung = [&] {
    return fmt::format("{{stiffness: {:.4g}, damping: {:.3g}}}", random.uniform(1, 300),
                       random.uniform(0, 3));
  };
  switch (static_cast<int>(random.uniform(0, 5))) {
    case 0:
      return "type: fixed";
    case 1:
      return "type: ball" + at;
    case 2:
      return "type: planar" + along + across + ", coordinates: [" + sprung() + ", {}, {}]";
    case 3:
      return "type: universal" + at + along + across + ", coordinates: [" + limits() + ", " + limits() + "]";
    default:
      return "type: cylindrical" + at + along + ", coordinates: [{friction: 0.3}, " + sprung() + "]";
  }
}

std::string shape_text(test::Random& random) {
  const double r = random.uniform(0.04, 0.1), l = random.uniform(0.05, 0.17);
  switch (static_cast<int>(random.uniform(0, 4))) {
    case 0:
      return fmt::format("{{type: sphere, radius: {:.5g}}}", r);
    case 1:
      return fmt::format("{{type: cone, radius: {:.5g}, length: {:.5g}}}", r, l);
    case 2:
      return fmt::format("{{type: cylinder, radius: {:.5g}, length: {:.5g}}}", r, l);
    default:
      return fmt::format("{{type: capsule, radius: {:.5g}, length: {:.5g}}}", 0.5 * r, l);
  }
}

/// Five bodies; the first hangs on the world, each other one on an earlier body.
std::string tree(unsigned seed) {
  test::Random random(seed);
  std::string bodies, joints;
  std::vector<Vec3> places;
  for (int k = 0; k < 5; ++k) {
    const int parent = k == 0 ? -1 : static_cast<int>(random.uniform(0, k));
    const Vec3 before = k == 0 ? Vec3(0, 0, 0.1) : places[static_cast<std::size_t>(parent)];
    Vec3 place = Vec3::Zero();
    if (k > 0) {
      // Where it overlaps no other body.
      do place = before + 0.3 * random.vector().normalized();
      while (std::any_of(places.begin(), places.end(),
                         [&](const Vec3& p) { return (p - place).norm() < 0.29; }));
    }
    places.push_back(place);
    bodies += fmt::format(
        "  - {{name: b{}, position: {}, axis_angle: {{axis: {}, angle: {:.4g}}}, shapes: [{}]}}\n", k,
        vector_text(place), vector_text(random.vector().normalized()), random.uniform(-3, 3),
        shape_text(random));
    const std::string joined = k == 0 ? "world" : fmt::format("b{}", parent);
    const std::string what = k == 0 ? fmt::format("type: cylindrical, anchor: [0, 0, 0.1], axis: {}",
                                                  vector_text(Vec3(0.3 * random.number(), 0.2, -0.9)))
                                    : joint_text(random, 0.5 * (before + place));
    joints += fmt::format("  - {{name: j{}, bodies: [{}, b{}], {}}}\n", k, joined, k, what);
  }
  return "rigor: 1\nrun: {duration: 0.7, step: 0.01, output_interval: 0.05}\n"
         "materials: [{name: default, density: 1500, friction: 0.6, restitution: 0.3}]\nbodies:\n"
         "  - {name: floor, motion: static, shapes: [{type: plane, offset: -0.95}]}\n" +
         bodies + "joints:\n" + joints;
}

TEST(StruckTrees, FindTheImpulsesOfEveryImpact) {
  long impacts = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Scene scene = parse_scene(tree(seed), "tree.yaml", ".");
    const RunResult result =
        run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    EXPECT_EQ(result.audit.report.reason, StopReason::reached_end) << seed << result.audit.report.detail;
    EXPECT_TRUE(result.audit.violations.empty()) << seed << ": " << result.audit.violations.front();
    impacts += result.audit.report.impacts;
  }
  EXPECT_GT(impacts, 20);
}

}  // namespace
}  // namespace rigor::struck_trees_test
