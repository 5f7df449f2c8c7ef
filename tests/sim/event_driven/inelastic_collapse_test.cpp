// Three balls on a line, e < 7 - 4√3: infinitely many impacts in a finite time (McNamara and Young, Inelastic
// Collapse and Clumping in a One-Dimensional Granular Medium, Phys. Fluids A 4, 1992).

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace rigor::inelastic_collapse_test {
namespace {

/// Three balls of 1 kg and radius 0.1, their surfaces as far apart as the points of the reference.
std::shared_ptr<const Model> three_balls(const nlohmann::json& c) {
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0, c["e"]});
  for (std::size_t i = 0; i < 3; ++i) {
    BodyDescription ball;
    ball.name = "ball" + std::to_string(i);
    ball.p_WU = Vec3(c["x"][i].get<double>() + 0.2 * static_cast<double>(i), 0, 0);
    ball.velocity = Vec3(c["v"][i], 0, 0);
    ball.mass = 1;
    ball.shapes.push_back({Sphere{0.1}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(ball);
  }
  return builder.build();
}

struct Collapse {
  AdvanceReport report;
  double last_impact = 0;     ///< [s].
  double velocity_error = 0;  ///< Largest difference from the reference [m/s].
  double momentum_error = 0;  ///< [kg m/s].
};

Collapse run_collapse(const nlohmann::json& c, double contact_tolerance) {
  Method method;
  method.contact_tolerance = contact_tolerance;
  const std::shared_ptr<const Model> model = three_balls(c);
  State state = make_initial_state(*model);
  EventDrivenStepper stepper(model, method, 0.01);
  Collapse result{stepper.advance(state, 100)};
  for (const MotionEvent& event : result.report.events)
    result.last_impact = std::max(result.last_impact, event.time);
  double momentum = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double v = state.linear_momentum(i).x();
    result.velocity_error = std::max(result.velocity_error, std::abs(v - c["v_after"][k].get<double>()));
    momentum += v - c["v"][k].get<double>();
  }
  result.momentum_error = std::abs(momentum);
  return result;
}

class InelasticCollapse : public testing::Test {
 protected:
  const nlohmann::json file_ =
      nlohmann::json::parse(std::ifstream(std::string(RIGOR_TEST_DATA) + "/collapse.json"));
};

TEST_F(InelasticCollapse, AboveTheCriticalRestitutionTheImpactsAreThoseOfTheReference) {
  for (const nlohmann::json& c : file_["cases"]) {
    if (c["collapse"]) continue;
    const Collapse run = run_collapse(c, 1e-6);
    EXPECT_EQ(run.report.reason, StopReason::reached_end);
    EXPECT_EQ(run.report.impacts, c["impacts"].get<long>()) << c["e"];
    // The last gaps close at 1e-6 m/s: rounding of a position of 1e-15 m is 1e-9 s there.
    EXPECT_NEAR(run.last_impact, c["t_last"], 1e-9) << c["e"];
    EXPECT_LE(run.velocity_error, 1e-14) << c["e"];
  }
}

// The engine does not end the series by a rule: without a force that presses them together the balls bounce
// on until their gaps are below the contact tolerance. Then all three touch, both impacts are one event, and
// what is left of the speeds parts them. Smaller tolerances come closer to the limit.
TEST_F(InelasticCollapse, BelowItTheSeriesEndsWhereAllThreeTouch) {
  for (const nlohmann::json& c : file_["cases"]) {
    if (!c["collapse"]) continue;
    const double limit = c["t_last"];
    const Collapse coarse = run_collapse(c, 1e-6), fine = run_collapse(c, 1e-12);
    for (const Collapse& run : {coarse, fine}) {
      EXPECT_EQ(run.report.reason, StopReason::reached_end);
      EXPECT_LE(run.momentum_error, 1e-15);
      EXPECT_LE(run.last_impact, limit);
      EXPECT_LE(run.report.impacts, 16);
    }
    EXPECT_LE(coarse.velocity_error, 1e-3) << c["e"];
    EXPECT_LE(fine.velocity_error, 1e-2 * coarse.velocity_error) << c["e"];
    EXPECT_LT(limit - fine.last_impact, 0.5 * (limit - coarse.last_impact)) << c["e"];
    // Far from the critical e the series is short: a millionth of a metre per second is left, and of a
    // second.
    if (c["e"].get<double>() == 0.05) {
      EXPECT_NEAR(fine.last_impact, limit, 1e-6);
      EXPECT_LE(fine.velocity_error, 2e-6);
    }
  }
}

}  // namespace
}  // namespace rigor::inelastic_collapse_test
