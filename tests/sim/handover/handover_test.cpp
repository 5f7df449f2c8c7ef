// `auto` hands over between events and fixed steps: where, how accurately, and with the same bits whenever
// the run is put aside. The bounds are lower than those of a run, so that small heaps cross them.

#include "sim/handover/falling_heaps.hpp"

#include "rigor/core/work_count.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/drives/driven_stepper.hpp"
#include "rigor/sim/event_driven/hybrid_stepper.hpp"
#include "rigor/sim/handover/auto_stepper.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::handover_test {
namespace {

constexpr HandoverBounds low_bounds{.paid_by_events = 4e3, .most_owed = 400, .paid_by_steps = 2e3};

std::unique_ptr<AutoStepper> auto_stepper(const std::shared_ptr<const Model>& model,
                                          const HandoverBounds& bounds = low_bounds) {
  const ResolvedMethod resolved = resolve_scheme(*model, automatic());
  std::unique_ptr<EventDrivenStepper> events =
      resolved.method.scheme == Scheme::hybrid
          ? std::make_unique<HybridStepper>(model, resolved.method, step)
          : std::make_unique<EventDrivenStepper>(model, resolved.method, step);
  return std::make_unique<AutoStepper>(model, std::move(events), resolved, step, 1, bounds);
}

/// A run of so many outputs, with its State and audit at each.
struct Course {
  std::vector<State> states;
  std::vector<Audit> audits;
};

Course run(const std::shared_ptr<const Model>& model, int outputs) {
  State state = make_initial_state(*model);
  Auditor auditor(model, automatic(), state);
  const std::unique_ptr<Stepper> stepper = auto_stepper(model);
  Course course{{state}, {auditor.audit(state)}};
  for (int k = 1; k <= outputs; ++k) {
    const AdvanceReport report = stepper->advance(state, k * interval);
    EXPECT_EQ(report.reason, StopReason::reached_end) << report.detail;
    auditor.observe(state, report);
    course.states.push_back(state);
    course.audits.push_back(auditor.audit(state));
  }
  return course;
}

TEST(Handover, RandomHeapsKeepTheirBooksOnBothSides) {
  constexpr int outputs = 40;
  int to_steps = 0, to_events = 0;
  for (unsigned seed = 0; seed < 16; ++seed) {
    SCOPED_TRACE(seed);
    const Course heap_run = run(heap(seed), outputs);
    const Audit& audit = heap_run.audits.back();
    EXPECT_TRUE(audit.violations.empty()) << audit.violations.front();
    EXPECT_EQ(audit.spans.front().of.begin, 0);
    EXPECT_DOUBLE_EQ(audit.spans.back().of.end, outputs * interval);
    double work = 0, until = 0;
    long impacts = 0;
    for (std::size_t i = 0; i < audit.spans.size(); ++i) {
      // Spans follow each other and alternate; each says why it was handed over.
      const SchemeSpan& span = audit.spans[i].of;
      EXPECT_EQ(span.begin, until);
      EXPECT_EQ(span.scheme == Scheme::time_stepping, i % 2 == 1);
      EXPECT_TRUE(i + 1 == audit.spans.size() || !span.end_cause.empty());
      EXPECT_LE(span.rise, audit.spans[i].most_rise);
      if (i % 2 == 1) ++to_steps;
      if (i % 2 == 0 && i > 0) ++to_events;
      work += span.work, impacts += span.impacts, until = span.end;
    }
    EXPECT_DOUBLE_EQ(work, audit.report.work);
    EXPECT_EQ(impacts, audit.report.impacts);
    EXPECT_EQ(audit.spans.back().of.energy, audit.final.total());
    // The energy is not that of a run without hand-over, but no more than at the start.
    EXPECT_LE(audit.final.total(), audit.initial.total() * (1 + 1e-9));
  }
  // The family crosses the border in both directions.
  EXPECT_GE(to_steps, 8);
  EXPECT_GE(to_events, 4);
}

/// The heap, and beside it a wheel whose motor and a ball whose force are functions of the time.
std::shared_ptr<const Model> driven_heap(unsigned seed) {
  ModelBuilder builder = heap_builder(seed);
  const auto add = [&](const std::string& name, const Vec3& x) {
    BodyDescription body;
    body.name = name;
    body.p_WU = x;
    body.mass = 2;
    body.shapes.push_back({Sphere{0.1}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("wheel", Vec3(0, 3, 1));
  add("pushed", Vec3(0, 5, 40));
  ModelBuilder::JointDescription axle;
  axle.name = "axle";
  axle.type = JointType::hinge;
  axle.bodies = {"world", "wheel"};
  axle.anchors = {Vec3(0, 3, 1.3)};
  axle.axis = Vec3::UnitX();
  axle.drives = {{.kind = JointDrive::Kind::position,
                  .aim = TimeFunction::Sine{.amplitude = 1, .frequency = 2},
                  .stiffness = 60,
                  .damping = 2,
                  .max_force = 5}};
  builder.add_joint(axle);
  return builder.build();
}

/// As make_stepper makes it, with the low bounds.
std::unique_ptr<Stepper> driven_stepper(const std::shared_ptr<const Model>& model) {
  return std::make_unique<DrivenStepper>(
      model, step, [](const std::shared_ptr<const Model>& driven) { return auto_stepper(driven); });
}

TEST(Handover, WithinDrivenStepsTheBooksCloseAndTheBitsStay) {
  constexpr int outputs = 30;
  int handed_over = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const std::shared_ptr<const Model> model = driven_heap(seed);
    State state = make_initial_state(*model);
    Auditor auditor(model, automatic(), state);
    const std::unique_ptr<Stepper> stepper = driven_stepper(model);
    State middle;
    for (int k = 1; k <= outputs; ++k) {
      const AdvanceReport report = stepper->advance(state, k * interval);
      ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
      auditor.observe(state, report);
      if (k == outputs / 3) middle = deserialise(serialise(state));
    }
    const Audit audit = auditor.audit(state);
    EXPECT_TRUE(audit.violations.empty()) << audit.violations.front();
    double work = 0, until = 0;
    for (const Audit::Span& span : audit.spans) {
      EXPECT_EQ(span.of.begin, until);
      until = span.of.end;
      work += span.of.work;
      // Between two equal steps of the drives, as events come.
      if (span.of.begin > 0 && std::abs(std::remainder(span.of.begin, step)) > 1e-9) ++handed_over;
    }
    EXPECT_NEAR(work, audit.report.work, 1e-12 * (1 + std::abs(work)));
    EXPECT_GT(std::abs(audit.report.motor_work), 1e-3);

    const std::unique_ptr<Stepper> fresh = driven_stepper(model);
    for (int k = outputs / 3 + 1; k <= outputs; ++k) fresh->advance(middle, k * interval);
    EXPECT_EQ(middle, state);
  }
  EXPECT_GE(handed_over, 3);
}

TEST(Handover, AFreshStepperFindsTheSameBitsAtEveryOutput) {
  std::mt19937 engine(3);
  for (const unsigned seed : {0u, 1u, 3u, 7u}) {
    SCOPED_TRACE(seed);
    const std::shared_ptr<const Model> model = heap(seed);
    const Course whole = run(model, 30);
    EXPECT_TRUE(whole.audits.back().was_handed_over());
    for (int k = 0; k < 4; ++k) {
      // The State as bytes and back, at a random output.
      const std::size_t place = engine() % 30;
      SCOPED_TRACE(place);
      State state = deserialise(serialise(whole.states[place]));
      ASSERT_EQ(state, whole.states[place]);
      Auditor auditor(model, resolve_scheme(*model, automatic()), state, whole.audits[place]);
      const std::unique_ptr<Stepper> stepper = auto_stepper(model);
      for (std::size_t i = place + 1; i <= 30; ++i) {
        auditor.observe(state, stepper->advance(state, static_cast<double>(i) * interval));
        ASSERT_EQ(state, whole.states[i]) << "at t = " << state.t;
      }
      const Audit resumed = auditor.audit(state), &audit = whole.audits.back();
      EXPECT_EQ(resumed.report.effort, audit.report.effort);
      EXPECT_EQ(resumed.max_increase, audit.max_increase);
      ASSERT_EQ(resumed.spans.size(), audit.spans.size());
      for (std::size_t i = 0; i < audit.spans.size(); ++i) {
        EXPECT_EQ(resumed.spans[i].of.begin, audit.spans[i].of.begin);
        EXPECT_EQ(resumed.spans[i].of.rise, audit.spans[i].of.rise);
        EXPECT_EQ(resumed.spans[i].of.impacts, audit.spans[i].of.impacts);
        EXPECT_EQ(resumed.spans[i].of.end_cause, audit.spans[i].of.end_cause);
      }
    }
  }
}

/// Balls and a capsule that fall on a ground.
std::shared_ptr<const Model> round_bodies_on(const Shape& ground, unsigned seed) {
  test::Random random(seed);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  for (int k = 0; k < 4; ++k) {
    BodyDescription body;
    body.name = "body" + std::to_string(k);
    body.motion = k == 0 ? MotionType::fixed : MotionType::dynamic;
    if (k > 0) {
      body.p_WU = Vec3(0.4 * k - 0.8, 0.1 * random.uniform(-1, 1), 0.2);
      body.velocity = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    }
    const Shape round = k == 3 ? Shape(Capsule{0.05, 0.1}) : Shape(Sphere{0.07});
    body.shapes.push_back({k == 0 ? ground : round, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  }
  return builder.build();
}

/// A ground of so many triangles [m].
Shape hills(double height) {
  HeightField field{HeightRows(31, std::vector<double>(31, 0.0)), Vec2(3, 3), 0.3};
  for (std::size_t i = 0; i < 31; ++i) {
    for (std::size_t k = 0; k < 31; ++k)
      field.rows[i][k] =
          height * std::sin(0.9 * static_cast<double>(i)) * std::cos(0.7 * static_cast<double>(k));
  }
  return make_mesh(std::make_shared<const TriangleMesh>(make_height_field_mesh(field)));
}

TEST(Handover, WhatFollowsBodiesAlongMeshesCounts) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    // The effort holds nearly all that was counted; what the start and the end of a call search is left out.
    const std::shared_ptr<const Model> model = round_bodies_on(hills(0.03), seed);
    Method named;
    named.scheme = Scheme::event_driven;
    State by_events = make_initial_state(*model);
    const std::uint64_t before = following_counted();
    const double effort = make_stepper(model, named, step)->advance(by_events, 0.6).effort;
    EXPECT_GT(following_counted(), before);
    EXPECT_GT(effort, 0.02 * static_cast<double>(following_counted() - before));

    // Over hills that work hands over; a fresh stepper in a fresh process, which cuts the solid into pieces
    // for itself, finds the same bits and owes the same.
    const Course whole = run(round_bodies_on(hills(0.03), seed), 30);
    EXPECT_TRUE(whole.audits.back().was_handed_over());
    const std::shared_ptr<const Model> again = round_bodies_on(hills(0.03), seed);
    for (const std::size_t place : {3u, 7u, 11u}) {
      SCOPED_TRACE(place);
      State state = deserialise(serialise(whole.states[place]));
      const std::unique_ptr<Stepper> stepper = auto_stepper(again);
      for (std::size_t i = place + 1; i <= 30; ++i) {
        stepper->advance(state, static_cast<double>(i) * interval);
        ASSERT_EQ(state, whole.states[i]) << "at t = " << state.t;
      }
    }
  }
}

TEST(Handover, NothingChangesWhereEventsAreFew) {
  // Without a hand-over the run is that of the scheme by itself, and a named scheme is never left.
  const std::shared_ptr<const Model> model = heap(0);
  Method named;
  named.scheme = resolve_scheme(*model, automatic()).method.scheme;
  State by_auto = make_initial_state(*model), by_name = by_auto;
  const std::unique_ptr<Stepper> chosen = make_stepper(model, automatic(), step),
                                 own = make_stepper(model, named, step);
  for (int k = 1; k <= 20; ++k) {
    const AdvanceReport report = chosen->advance(by_auto, k * interval);
    ASSERT_EQ(report.spans.size(), 1u);
    EXPECT_TRUE(own->advance(by_name, k * interval).spans.empty());
    by_auto.handover = {};
    ASSERT_EQ(by_auto, by_name);
  }
  EXPECT_EQ(by_name.handover, HandoverMemory{});
}

TEST(Handover, ALookChangesNothing) {
  const std::shared_ptr<const Model> model = heap(1);
  const Course whole = run(model, 30);
  for (std::size_t i = 4; i < 30; i += 3) {
    // What is seen on the way lies between the two outputs.
    State state = whole.states[i];
    const double t = (static_cast<double>(i) + 0.3) * interval;
    const AdvanceReport report = auto_stepper(model)->look(state, static_cast<double>(i + 1) * interval, t);
    EXPECT_EQ(report.reason, StopReason::reached_end);
    EXPECT_NEAR(state.t, t, 1e-9 * step);
    for (int body = 1; body < model->body_count(); ++body)
      EXPECT_LE((state.position(body) - whole.states[i].position(body)).norm(), 0.3 * interval * 6);
  }
}

TEST(Handover, SchemesThatTimeSteppingCannotReplaceAreNeverLeft) {
  const std::shared_ptr<const Model> model = heap(0);
  EXPECT_TRUE(resolve_scheme(*model, automatic()).steps.has_value());
  Method substep = automatic();
  substep.solver = SolverMethod::substep;
  EXPECT_FALSE(resolve_scheme(*model, substep).steps.has_value());
  Method named;
  named.scheme = Scheme::event_driven;
  EXPECT_FALSE(resolve_scheme(*model, named).steps.has_value());
}

/// A pile of so many boxes that fall askew on each other, none of which bounces.
std::shared_ptr<const Model> pile(unsigned seed, int boxes) {
  test::Random random(seed);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  BodyDescription floor{.name = "floor", .motion = MotionType::fixed};
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (int k = 0; k < boxes; ++k) {
    BodyDescription body{.name = "box" + std::to_string(k)};
    body.p_WU = Vec3(0.02 * random.uniform(-1, 1), 0.02 * random.uniform(-1, 1), 0.08 + 0.14 * k);
    body.q_WU =
        Quat(1, 0.2 * random.uniform(-1, 1), 0.2 * random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
    body.shapes.push_back({Box{Vec3(0.08, 0.06, 0.04)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  }
  return builder.build();
}

/// Steps from the beginning, of which so many operations may be owed.
std::unique_ptr<AutoStepper> stepper_of_steps(const std::shared_ptr<const Model>& model, double most_owed,
                                              int threads = 1) {
  ResolvedMethod choice = resolve_scheme(*model, automatic());
  choice.method = *choice.steps;
  choice.steps.reset();
  return std::make_unique<AutoStepper>(model, nullptr, choice, step, threads,
                                       HandoverBounds{.paid_to_steps = 1e4, .most_owed_by_steps = most_owed});
}

TEST(Handover, StepsThatAreTooDearAreFollowedBySoftOnes) {
  constexpr int outputs = 30;
  int softened = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const std::shared_ptr<const Model> model = pile(seed, 4);
    const double most_owed = 2e4;
    double soft_step = 0;
    State state = make_initial_state(*model), on_threads = state, resumed = state;
    Auditor auditor(model, automatic(), state);
    const std::unique_ptr<Stepper> stepper = stepper_of_steps(model, most_owed),
                                   threaded = stepper_of_steps(model, most_owed, 3);
    for (int k = 1; k <= outputs; ++k) {
      const AdvanceReport report = stepper->advance(state, k * interval);
      ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
      auditor.observe(state, report);
      if (soft_step > 0) {
        EXPECT_EQ(state.handover.soft_step, soft_step);
      }
      soft_step = state.handover.soft_step;
      // The same bits on threads, and by a stepper that knows the State alone.
      threaded->advance(on_threads, k * interval);
      stepper_of_steps(model, most_owed)->advance(resumed, k * interval);
      ASSERT_EQ(state, on_threads);
      ASSERT_EQ(state, resumed);
    }
    // Soft steps are no longer than the scene's, and of one length.
    if (soft_step > 0) {
      EXPECT_GE(soft_step, step / 16);
      EXPECT_LE(soft_step, step);
    }
    // Each span is judged by what carried it, and soft steps carry to the end.
    const Audit audit = auditor.audit(state);
    EXPECT_TRUE(audit.violations.empty()) << audit.violations.front();
    if (audit.spans.size() < 2) continue;
    ++softened;
    ASSERT_EQ(audit.spans.size(), 2u);
    const Audit::Span &exact = audit.spans[0], &soft = audit.spans[1];
    EXPECT_EQ(exact.of.name(), "time-stepping");
    EXPECT_EQ(soft.of.name(), "time-stepping (substep)");
    EXPECT_NE(exact.of.end_cause.find("exact steps take too long"), std::string::npos);
    EXPECT_EQ(exact.of.end, soft.of.begin);
    EXPECT_DOUBLE_EQ(soft.of.end, outputs * interval);
    EXPECT_LT(exact.most_rise, soft.most_rise);
    EXPECT_EQ(state.handover.carrier, HandoverMemory::Carrier::soft_steps);
  }
  EXPECT_GE(softened, 4);
}

TEST(Handover, AStepThatAloneIsTooDearIsGivenUp) {
  // Nothing may be owed: the first step whose contacts are more than time pays for is left to soft steps.
  const std::shared_ptr<const Model> model = pile(1, 5);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper_of_steps(model, 0)->advance(state, 0.3);
  EXPECT_EQ(report.reason, StopReason::reached_end) << report.detail;
  EXPECT_DOUBLE_EQ(state.t, 0.3);
  ASSERT_EQ(report.spans.size(), 2u);

  // Until there the steps are those of the scheme by itself.
  Method exact;
  exact.scheme = Scheme::time_stepping;
  State by_steps = make_initial_state(*model), by_auto = by_steps;
  const double until = report.spans[0].end;
  if (until > 0) {
    stepper_of_steps(model, 0)->look(by_auto, 0.3, until);
    make_stepper(model, exact, step)->look(by_steps, 0.3, until);
    for (int body = 1; body < model->body_count(); ++body)
      EXPECT_LE((by_auto.position(body) - by_steps.position(body)).norm(), 1e-12);
  }
}

TEST(Handover, AnImpactThatIsTooDearIsNotBegun) {
  // Ten iterations of four contacts are beyond what may be owed: the first impact of a box is left to steps,
  // with the momentum with which the box came.
  const std::shared_ptr<const Model> model = pile(2, 1);
  State state = make_initial_state(*model);
  Auditor auditor(model, automatic(), state);
  const std::unique_ptr<AutoStepper> stepper =
      auto_stepper(model, {.paid_by_events = 1, .most_owed = 9, .paid_by_steps = 1});
  const AdvanceReport report = stepper->advance(state, 0.5);
  auditor.observe(state, report);
  ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
  ASSERT_GE(report.spans.size(), 2u);
  EXPECT_EQ(report.spans[0].scheme, Scheme::event_driven);
  EXPECT_EQ(report.spans[0].impacts, 0);
  EXPECT_NE(report.spans[0].end_cause.find("events crowd"), std::string::npos);
  EXPECT_GT(report.spans[0].end, 0);
  EXPECT_LT(report.spans[0].end, 0.5);
  // Until the impact the box has only fallen.
  const double g = 9.81, m = model->body(1).mass, t = report.spans[0].end;
  State at_impact = make_initial_state(*model);
  auto_stepper(model, {.paid_by_events = 1, .most_owed = 9, .paid_by_steps = 1})->advance(at_impact, t);
  EXPECT_NEAR(at_impact.linear_momentum(1).z(), -m * g * t, 1e-12 * m * g);
  EXPECT_EQ(auditor.audit(state).violations, std::vector<std::string>{});
}

TEST(Handover, WhoWantsExactStepsHasNoLastResort) {
  const std::shared_ptr<const Model> model = heap(0);
  Method method = automatic();
  EXPECT_TRUE(resolve_scheme(*model, method).soft_steps.has_value());
  method.last_resort = LastResort::none;
  EXPECT_FALSE(resolve_scheme(*model, method).soft_steps.has_value());
  // A solver that the scene names is kept, and so is a scheme.
  method = automatic();
  method.solver = SolverMethod::pgs;
  EXPECT_FALSE(resolve_scheme(*model, method).soft_steps.has_value());
  method = {};
  method.scheme = Scheme::time_stepping;
  EXPECT_FALSE(resolve_scheme(*model, method).soft_steps.has_value());
}

TEST(WorkBudget, TimePaysForWork) {
  WorkBudget budget{.rate = 100, .most = 50, .owed = 0, .t = 1};
  budget.charge(40, 1);
  EXPECT_FALSE(budget.is_exceeded());
  budget.charge(40, 1.1);
  EXPECT_DOUBLE_EQ(budget.owed, 70);
  EXPECT_TRUE(budget.is_exceeded());
  // Nothing is saved up.
  budget.charge(1, 10);
  EXPECT_DOUBLE_EQ(budget.owed, 1);
}

}  // namespace
}  // namespace rigor::handover_test
