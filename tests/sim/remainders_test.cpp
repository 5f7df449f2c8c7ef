// Runs with fixed steps that end anywhere: what is left of a step changes nothing, and a resumed run goes on
// as if it had not ended.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rigor::remainders_test {
namespace {

/// A box that rests on another, one that falls askew, and a pendulum.
std::shared_ptr<const Model> boxes() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  Material material{"m"};
  material.friction = 0.4;
  material.restitution = 0.3;
  builder.add_material(material);
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& p_W, const Vec3& v_W) {
    BodyDescription body;
    body.name = name;
    body.p_WU = p_W;
    body.velocity = v_W;
    if (is_unbounded(shape)) body.motion = MotionType::fixed;
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Vec3::Zero());
  add("below", Box{Vec3::Constant(0.5)}, Vec3(0, 0, 0.5), Vec3::Zero());
  add("above", Box{Vec3::Constant(0.5)}, Vec3(0, 0, 1.5), Vec3::Zero());
  add("falling", Sphere{0.2}, Vec3(2, 0, 0.5), Vec3(0.3, 0, -1));
  return builder.build();
}

Method method_of(Scheme scheme, SolverMethod solver, PenaltyMethod penalty = PenaltyMethod::local) {
  Method method;
  method.scheme = scheme;
  method.solver = solver;
  method.penalty = penalty;
  return method;
}

RunResult run(const Method& method, const RunSettings& settings, const RunResult* before = nullptr) {
  const Observer goes_on = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
  if (before == nullptr) return run_simulation(boxes(), method, settings, std::nullopt, goes_on);
  return run_simulation(boxes(), method, settings, before->resumable, goes_on, {}, before->resumable_audit);
}

void expect_same(const RunResult& resumed, const RunResult& whole) {
  EXPECT_EQ(resumed.state, whole.state);
  const Audit &a = resumed.audit, &b = whole.audit;
  EXPECT_EQ(a.report.steps, b.report.steps);
  EXPECT_EQ(a.report.impacts, b.report.impacts);
  EXPECT_EQ(a.report.work, b.report.work);
  EXPECT_EQ(a.linear_momentum_error, b.linear_momentum_error);
  EXPECT_EQ(a.max_increase, b.max_increase);
  EXPECT_EQ(a.dissipated, b.dissipated);
  EXPECT_EQ(a.sim_time, b.sim_time);
  EXPECT_EQ(a.violations, b.violations);
}

TEST(Remainders, AResumedRunIsTheWholeRunFromAnyPlace) {
  constexpr double duration = 0.4;
  const std::vector<std::pair<Method, int>> methods{
      {method_of(Scheme::time_stepping, SolverMethod::substep), 100},
      {method_of(Scheme::time_stepping, SolverMethod::exact), 12},
      {method_of(Scheme::time_stepping, SolverMethod::pgs), 12},
      {method_of(Scheme::penalty, SolverMethod::exact), 4},
      {method_of(Scheme::penalty, SolverMethod::exact, PenaltyMethod::global), 4}};
  std::mt19937 engine(1);
  for (const auto& [method, places] : methods) {
    for (const double interval : {0.1, 0.0333333}) {
      RunSettings settings{.duration = duration, .step = 1.0 / 60, .output_interval = interval};
      const RunResult whole = run(method, settings);
      for (int k = 0; k < places / 2; ++k) {
        // Every other place is an output, or a rounding beside it.
        const double part = static_cast<double>(engine()) / 4294967296.0;
        settings.duration = k % 2 == 0 ? 0.4 * part : 0.1 * (1 + k / 2 % 3);
        SCOPED_TRACE(settings.duration);
        const RunResult first = run(method, settings);
        EXPECT_EQ(first.audit.report.reason, StopReason::reached_end);
        EXPECT_NEAR(first.state.t, settings.duration, 1e-10);
        settings.duration = duration;
        expect_same(run(method, settings, &first), whole);
      }
    }
  }
}

TEST(Remainders, OfAnyLengthTheyAddNoEnergy) {
  // Two boxes at rest: nothing may move them, however short the last step is.
  for (const SolverMethod solver : {SolverMethod::substep, SolverMethod::exact}) {
    const Method method = method_of(Scheme::time_stepping, solver);
    RunSettings settings{.step = 1.0 / 60, .output_interval = 0.1};
    for (const double rest : {1e-12, 1e-9, 2e-6, 1e-4, 0.004, 1.0 / 60, 0.05, 0.0999999}) {
      settings.duration = 0.8;
      const RunResult grid = run(method, settings);
      settings.duration = 0.8 + rest;
      const RunResult beyond = run(method, settings);
      const double energy = grid.audit.final.total();
      EXPECT_LE(beyond.audit.final.total(), energy * (1 + 1e-6)) << rest;
      EXPECT_GE(beyond.audit.final.total(), energy * (1 - 1e-3)) << rest;
      EXPECT_LE((beyond.state.position(2) - grid.state.position(2)).norm(), 1e-3 * rest + 1e-9) << rest;
    }
  }
}

}  // namespace
}  // namespace rigor::remainders_test
