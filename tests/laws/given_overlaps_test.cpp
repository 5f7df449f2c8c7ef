// Bodies that a scene puts into each other by less than method.contact_tolerance, as rounded coordinates do:
// no scheme holds the lift out of it against itself.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/splitmix64.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace rigor::given_overlaps_test {
namespace {

RunResult run(const std::string& text, const std::string& scheme) {
  const Scene scene = parse_scene(text, "given_overlaps.yaml", {}, {"method.scheme=" + scheme});
  return run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                        [](const State&, const AdvanceReport&, const Auditor&) { return true; });
}

TEST(GivenOverlaps, AreLiftedByWorkThatTheAuditKnows) {
  // One box on the floor: the work is its weight times the depth.
  const double depth = 9e-7, weight = 1000 * 9.80665;
  const std::string text = fmt::format(
      "{{rigor: 1, run: {{duration: 0.02}}, bodies: [{{name: floor, motion: static, shapes: [{{type: "
      "plane}}]}}, {{name: box, "
      "position: [0, 0, {:.17g}], shapes: [{{type: box, size: [1, 1, 1]}}]}}]}}",
      0.5 - depth);
  const RunResult result = run(text, "event-driven");
  EXPECT_EQ(result.audit.violations, std::vector<std::string>{});
  EXPECT_NEAR(result.audit.report.work, weight * depth, 1e-9 * weight * depth + 1e-12 * weight);
}

TEST(GivenOverlaps, OfStacksPassTheAuditInEveryScheme) {
  SplitMix64 random(3);
  const auto uniform = [&](double lower, double upper) { return lower + (upper - lower) * random.uniform(); };
  for (int k = 0; k < 6; ++k) {
    std::string text =
        "{rigor: 1, run: {duration: 0.05}, bodies: [{name: floor, motion: static, shapes: [{type: plane}]}";
    double top = 0;
    const int count = static_cast<int>(uniform(1, 4.99));
    const double width = std::pow(10.0, uniform(-1.5, 0.5));
    for (int i = 0; i < count; ++i) {
      const double height = width * uniform(0.3, 1);
      top -= uniform(0.1, 0.99) * 1e-6;
      text += fmt::format(
          ", {{name: b{}, position: [0, 0, {:.17g}], density: {:.6g}, shapes: [{{type: box, size: [{:.6g}, "
          "{:.6g}, "
          "{:.17g}]}}]}}",
          i, top + 0.5 * height, std::pow(10.0, uniform(2, 4)), width, width, height);
      top += height;
    }
    text += "]}";
    for (const char* const scheme : {"auto", "event-driven", "hybrid", "time-stepping", "impulse-based"})
      EXPECT_EQ(run(text, scheme).audit.violations, std::vector<std::string>{})
          << scheme << ", stack " << k << "\n"
          << text;
  }
}

}  // namespace
}  // namespace rigor::given_overlaps_test
