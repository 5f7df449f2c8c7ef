// Runs of random scenes that end anywhere and go on, in every scheme: the bits and the audit are those of the
// run that was not put aside.

#include "random_vectors.hpp"
#include "rigor/sim/simulation.hpp"
#include "sim/random_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace rigor::resumed_runs_test {
namespace {

struct Case {
  const char* name;
  Method method;
  int scenes;
  double duration = 0.35;  ///< [s].
};

Method method_of(Scheme scheme, SolverMethod solver = SolverMethod::exact) {
  Method method;
  method.scheme = scheme;
  method.solver = solver;
  return method;
}

class ResumedRuns : public testing::TestWithParam<Case> {
 protected:
  /// From the start, or from where another run can be resumed.
  RunResult run(const Model& model, double until, double interval, const RunResult* before = nullptr) const {
    const RunSettings settings{.duration = until, .step = 0.01, .output_interval = interval};
    const std::shared_ptr<const Model> shared(std::shared_ptr<const Model>(), &model);
    const Observer goes_on = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
    if (before == nullptr) return run_simulation(shared, GetParam().method, settings, std::nullopt, goes_on);
    // As a file keeps it: bytes, and no scheme at work.
    const State start = deserialise(serialise(before->resumable));
    return run_simulation(shared, GetParam().method, settings, start, goes_on, {}, before->resumable_audit);
  }
};

void expect_same(const RunResult& resumed, const RunResult& whole) {
  EXPECT_EQ(resumed.state, whole.state);
  const AdvanceReport &a = resumed.audit.report, &b = whole.audit.report;
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.impacts, b.impacts);
  EXPECT_EQ(a.resting, b.resting);
  EXPECT_EQ(a.separations, b.separations);
  EXPECT_EQ(a.slip_to_stick, b.slip_to_stick);
  EXPECT_EQ(a.work, b.work);
  EXPECT_EQ(a.friction_loss, b.friction_loss);
  EXPECT_EQ(a.projection_loss, b.projection_loss);
  EXPECT_EQ(a.max_penetration, b.max_penetration);
  EXPECT_EQ(a.coarse_steps, b.coarse_steps);
  EXPECT_EQ(a.max_residual, b.max_residual);
  EXPECT_EQ(resumed.audit.linear_momentum_error, whole.audit.linear_momentum_error);
  EXPECT_EQ(resumed.audit.angular_momentum_error, whole.audit.angular_momentum_error);
  EXPECT_EQ(resumed.audit.max_increase, whole.audit.max_increase);
  EXPECT_EQ(resumed.audit.dissipated, whole.audit.dissipated);
  EXPECT_EQ(resumed.audit.violations, whole.audit.violations);
}

TEST_P(ResumedRuns, AreTheWholeRunFromAnyPlace) {
  for (int seed = 1; seed <= GetParam().scenes; ++seed) {
    const std::shared_ptr<const Model> model = test::RandomScene(static_cast<unsigned>(seed), 3).build();
    const double duration = GetParam().duration;
    test::Random random(static_cast<unsigned>(seed));
    const double interval = seed % 2 == 0 ? 0.05 : 0.0333333;
    const RunResult whole = run(*model, duration, interval);
    // Anywhere, at an output, and a rounding beside one.
    const double on_grid = interval * std::floor(random.uniform(1, duration / interval));
    for (const double place : {random.uniform(0, duration), on_grid, on_grid * (1 + 1e-15)}) {
      SCOPED_TRACE("scene " + std::to_string(seed) + " put aside at " + std::to_string(place));
      const RunResult first = run(*model, place, interval);
      expect_same(run(*model, duration, interval, &first), whole);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, ResumedRuns,
                         testing::Values(Case{"event_driven", method_of(Scheme::event_driven), 30},
                                         Case{"hybrid", method_of(Scheme::hybrid), 30},
                                         Case{"impulse_based", method_of(Scheme::impulse_based), 40, 0.19},
                                         Case{"automatic", method_of(Scheme::automatic), 30},
                                         Case{"time_stepping", method_of(Scheme::time_stepping), 30},
                                         Case{"substep",
                                              method_of(Scheme::time_stepping, SolverMethod::substep), 40},
                                         Case{"penalty", method_of(Scheme::penalty), 15}),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace rigor::resumed_runs_test
