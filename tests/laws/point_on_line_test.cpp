// A point that slides along a line, against closed forms: by event-driven steps, by time steps of the 64-bit
// path and by substeps in 32 bits.

#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rigor::test::point_on_line_test {
namespace {

constexpr double g = 9.80665;

struct Scheme {
  std::string method;
  double step;
  double tolerance;  ///< Of lengths in m and, relative, of energies.
};
/// Fixed steps are of first order: errors of the size of the step, half a millisecond, times rates of up to
/// 10 rad/s.
const std::vector<Scheme> kSchemes = {{"{scheme: event-driven}", 0.01, 1e-8},
                                      {"{scheme: time-stepping, solver: exact}", 0.0005, 1e-2},
                                      {"{scheme: time-stepping, solver: substep}", 0.0005, 1e-3}};

std::vector<State> states_of(const std::string& text) {
  const Scene scene = parse_scene(text, "line.yaml", ".");
  std::vector<State> states;
  const Observer observer = [&](const State& state, const AdvanceReport&, const Auditor&) {
    states.push_back(state);
    return true;
  };
  const Audit audit = run_simulation(scene.model, scene.method, scene.run, std::nullopt, observer).audit;
  for (const std::string& violation : audit.violations) ADD_FAILURE() << violation;
  return states;
}

std::string scene_text(const Scheme& scheme, const std::string& rest) {
  return "rigor: 1\nrun: {duration: 2, step: " + std::to_string(scheme.step) +
         ", output_interval: 0.1}\nmethod: " + scheme.method + rest;
}

TEST(PointOnLine, ARodWhoseEndSlidesFreelyFallsStraightDown) {
  // No force acts along the line, so the centre stays at its x. With θ the angle from the vertical and
  // ż = l θ' sin θ, energy gives θ'² (I + m l² sin²θ) = 2 m g l (cos θ - cos θ₀).
  constexpr double m = 2, l = 0.5, I = 0.17, start = M_PI / 3;
  for (const Scheme& scheme : kSchemes) {
    const std::string text = scene_text(scheme, R"(
bodies:
  - {name: rod, position: [0.4330127018922193, 0, -0.25], inertia: {mass: 2, moments: [0.17, 0.17, 0.17]}}
joints:
  - {name: ring, type: point_on_line, bodies: [world, rod], anchor: [0, 0, 0], axis: [1, 0, 0]}
)");
    double fastest = 0;
    for (const State& state : states_of(text)) {
      const Vec3 x = state.position(0);
      EXPECT_NEAR(x.x(), l * std::sin(start), scheme.tolerance) << scheme.method << " " << state.t;
      EXPECT_NEAR(x.y(), 0, scheme.tolerance) << scheme.method << " " << state.t;
      // The end of the rod is on the line.
      const Vec3 end = x + rotation_matrix(state.orientation(0)) * Vec3(-l * std::sin(start), 0, 0.25);
      EXPECT_NEAR(end.y(), 0, scheme.tolerance) << scheme.method << " " << state.t;
      EXPECT_NEAR(end.z(), 0, scheme.tolerance) << scheme.method << " " << state.t;
      const double cosine = -x.z() / l, rate = state.angular_momentum(0).y() / I;
      const double kinetic = 0.5 * rate * rate * (I + m * l * l * (1 - cosine * cosine));
      EXPECT_NEAR(kinetic, m * g * l * (cosine - std::cos(start)), scheme.tolerance * m * g * l)
          << scheme.method << " " << state.t;
      fastest = std::max(fastest, std::abs(rate));
    }
    EXPECT_GT(fastest, 3) << scheme.method;
  }
}

TEST(PointOnLine, ABeadOnASprungWireOscillatesAndSpinsFreely) {
  // Along a wire at 30 deg with a spring k: s'' = -g sin 30° - k s/m from rest, and no torque on the bead.
  constexpr double m = 2, k = 50;
  const double rate = std::sqrt(k / m), depth = 0.5 * g * m / k;
  const Vec3 along(std::cos(M_PI / 6), 0, 0.5);
  for (const Scheme& scheme : kSchemes) {
    const std::string text = scene_text(scheme, R"(
bodies:
  - {name: bead, inertia: {mass: 2, moments: [0.1, 0.1, 0.1]}, angular_velocity: [1, 2, 3]}
joints:
  - {name: wire, type: point_on_line, bodies: [world, bead], anchor: [0, 0, 0], axis: [0.8660254037844386, 0, 0.5], stiffness: 50}
)");
    for (const State& state : states_of(text)) {
      const double s = -depth * (1 - std::cos(rate * state.t));
      EXPECT_LE((state.position(0) - s * along).norm(), scheme.tolerance) << scheme.method << " " << state.t;
      EXPECT_LE((state.angular_momentum(0) - 0.1 * Vec3(1, 2, 3)).norm(), 0.1 * scheme.tolerance)
          << scheme.method << " " << state.t;
    }
  }
}

}  // namespace
}  // namespace rigor::test::point_on_line_test
