#include "io/forged_files.hpp"
#include "io/trajectory_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/audit_json.hpp"
#include "rigor/io/trajectory/checkpoint.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"
#include "rigor/model/state_check.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

namespace rigor::forged_checkpoint_test {
namespace {

/// Two bodies on a joint above a floor: the State has contacts, joints, and all that schemes remember.
std::string scene_text(const std::string& method) {
  return "rigor: 1\nname: forged\nrun: {duration: 2, output_interval: 0.05}\nmethod: " + method + R"(
bodies:
  - {name: floor, motion: static, shapes: [{type: plane}]}
  - {name: a, position: [0, 0, 0.1], mass: 1, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
  - {name: b, position: [0.5, 0, 0.5], mass: 2, angular_velocity: [1, 2, 3], shapes: [{type: sphere, radius: 0.1}]}
  - {name: c, position: [0.8, 0, 0.5], mass: 2, shapes: [{type: sphere, radius: 0.1}]}
joints:
  - {name: arm, type: ball, bodies: [b, c], anchor: [0.65, 0, 0.5]}
)";
}

struct Sample {
  Scene scene;
  std::uint64_t fingerprint;
  std::string bytes;
};

Sample sample(const std::string& method, double duration) {
  Scene scene = parse_scene(scene_text(method), "scene.yaml", ".");
  RunSettings settings = scene.run;
  settings.duration = duration;
  const RunResult result =
      run_simulation(scene.model, scene.method, settings, std::nullopt,
                     [](const State&, const AdvanceReport&, const Auditor&) { return true; });
  const std::uint64_t own = fingerprint(*scene.model, scene.method, scene.run.step);
  std::string bytes = checkpoint_bytes({own, result.state, result.audit});
  return {std::move(scene), own, std::move(bytes)};
}

std::optional<Checkpoint> read(const Sample& sample, const std::string& bytes,
                               const TemporaryFolder& folder) {
  std::ofstream(folder / "a.cp", std::ios::binary) << bytes;
  try {
    return read_checkpoint(folder / "a.cp", sample.fingerprint, *sample.scene.model);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.cp"), std::string::npos) << error.what();
    return std::nullopt;
  }
}

Checkpoint checkpoint_of(const Sample& sample) {
  const TemporaryFolder folder;
  return *read(sample, sample.bytes, folder);
}

bool is_finite(const State& state) {
  const auto all = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  };
  return std::isfinite(state.t) && all(state.x) && all(state.q) && all(state.P) && all(state.L);
}

/// Whatever is read of a forged file is used as the program uses it: it runs on, or stops and says why, and
/// every number of it is one.
void try_forgeries(const std::string& method, int count, int most_runs, std::uint64_t seed) {
  const Sample own = sample(method, 0.2);
  const TemporaryFolder folder;
  ASSERT_TRUE(read(own, own.bytes, folder)) << method;
  std::mt19937_64 engine(seed);
  int runs = 0;
  for (int i = 0; i < count; ++i) {
    const std::string forged = test::forged_checkpoint(own.bytes, engine);
    const std::optional<Checkpoint> checkpoint = read(own, forged, folder);
    if (!checkpoint) continue;
    ASSERT_EQ(state_error(*own.scene.model, checkpoint->state), "") << method << " " << i;
    if (checkpoint->state.t >= 0.3 || runs++ >= most_runs) continue;
    RunSettings settings = own.scene.run;
    settings.duration = 0.3;
    long asked = 0;
    const RunResult result = run_simulation(
        own.scene.model, own.scene.method, settings, checkpoint->state,
        [&](const State& state, const AdvanceReport&, const Auditor& auditor) {
          EXPECT_TRUE(is_finite(state)) << method << " " << i;
          EXPECT_TRUE(std::isfinite(auditor.energy().total())) << method << " " << i;
          return true;
        },
        [&asked] { return ++asked > 2000; });
    const std::string json = audit_json(joined_audit(checkpoint->audit, result.audit));
    EXPECT_FALSE(json.empty());
  }
}

TEST(ForgedCheckpoint, OfTheEventDrivenSchemeIsRefusedOrRuns) {
  try_forgeries("{scheme: event-driven}", 400, 15, 1);
}
TEST(ForgedCheckpoint, OfTheSubstepSolverIsRefusedOrRuns) {
  try_forgeries("{scheme: time-stepping, solver: substep}", 400, 15, 2);
}
TEST(ForgedCheckpoint, OfAutoIsRefusedOrRuns) {
  try_forgeries("{scheme: auto}", 200, 10, 4);
  try_forgeries("{scheme: auto, last_resort: none}", 100, 5, 5);
}
TEST(ForgedCheckpoint, OfThePenaltySchemeIsRefusedOrRuns) {
  try_forgeries("{scheme: penalty, penalty: local}", 200, 10, 3);
}

TEST(ForgedCheckpoint, AFlightOfYearsIsLeftOffWhenAsked) {
  // The windows of a flight are gone through again from its anchor on: of this one there are ten million.
  const Sample own = sample("{scheme: event-driven}", 0.2);
  Checkpoint checkpoint = checkpoint_of(own);
  checkpoint.state.t = 1e6;
  const std::unique_ptr<Stepper> stepper =
      make_stepper(own.scene.model, own.scene.method, own.scene.run.step);
  long asked = 0;
  stepper->set_interrupt([&asked] { return ++asked > 100; });
  EXPECT_EQ(stepper->advance(checkpoint.state, 1e6 + 0.1).reason, StopReason::interrupted);
  EXPECT_LE(asked, 102);
}

TEST(ForgedCheckpoint, NamesWhatCannotBe) {
  const Sample own = sample("{scheme: event-driven}", 0.2);
  const TemporaryFolder folder;
  const auto refusal = [&](const auto& change) {
    Checkpoint checkpoint = checkpoint_of(own);
    change(checkpoint);
    write_checkpoint(folder / "a.cp", checkpoint);
    try {
      read_checkpoint(folder / "a.cp", own.fingerprint, *own.scene.model);
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.rfind("scene: ") + 7);
    }
    return std::string();
  };
  EXPECT_EQ(refusal([](Checkpoint&) {}), "");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.t = -9e16; }), "its time is -9e+16 s");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.x[5] = NAN; }), "body 'a': its position is not finite");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.P[7] = 1e200; }), "body 'b': its momentum is not finite");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.q[8] += 0.1; }),
            "body 'b': its orientation is not a unit quaternion");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.epoch[1] = 1; }),
            "body 'a': its anchor is not between 0 and the State's time");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.L[0] = 1; }),
            "body 'floor': its momentum is not 0, though its motion is prescribed");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.contacts.push_back({.body_A = 0, .body_B = 9}); }),
            "a remembered contact is between shapes that do not exist");
  ASSERT_FALSE(checkpoint_of(own).state.events.contacts.empty());
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.events.contacts[0].body_B = 4; }),
            "a contact that lasts is between shapes that do not exist");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.events.contacts[0].shape_A = -1; }),
            "a contact that lasts is between shapes that do not exist");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.events.contacts[0].values[2] = INFINITY; }),
            "a contact that lasts holds a number that is not finite, or energy");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.events.contacts[0].energy = 1; }),
            "a contact that lasts holds a number that is not finite, or energy");
  for (const double mode : {-1.0, 0.5, 4.0})
    EXPECT_EQ(refusal([&](Checkpoint& c) { c.state.events.contacts[0].values[EventMemory::mode] = mode; }),
              "a contact that lasts has a mode that does not exist");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.quiet_time.push_back(1); }),
            "it has 1 quiet times for 4 bodies");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.audit.report.drift_joint = 1; }),
            "its audit names a joint that does not exist");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.audit.report.penetration_A = 4; }),
            "its audit names a body that does not exist");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.audit.report.work = NAN; }), "a number of its audit is not finite");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.audit.report.impacts = -1; }),
            "a count of its audit is negative or beyond any run");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.audit.sim_time = -1; }), "its audit has a negative time");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.handover.owed = -1; }),
            "the work that it remembers is negative or beyond any run");
  using Carrier = HandoverMemory::Carrier;
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.handover.carrier = Carrier::soft_steps; }),
            "the length of its soft steps is 0 s");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.state.handover.soft_step = 0.01; }),
            "the length of its soft steps is 0.01 s");
  EXPECT_EQ(refusal([](Checkpoint& c) {
              c.audit.report.spans = {{.scheme = Scheme::time_stepping, .solver = SolverMethod(3)}};
            }),
            "a span of its schemes names a solver that does not exist");
  EXPECT_EQ(refusal([](Checkpoint& c) {
              c.audit.report.spans = {{.begin = 0, .end = 2}, {.begin = 1, .end = 3}};
            }),
            "the spans of its schemes are in disorder");
  EXPECT_EQ(refusal([](Checkpoint& c) { c.audit.report.spans = {{.scheme = Scheme::automatic}}; }),
            "a span of its schemes names a scheme that does not exist");
}

}  // namespace
}  // namespace rigor::forged_checkpoint_test
