#include "rigor/io/trajectory/checkpoint.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace rigor::checkpoint_test {
namespace {

const char* const two_balls = R"(
rigor: 1
name: two balls
run: {duration: 2, output_interval: 0.25}
materials: [{name: rubber, density: 1000, friction: 0.3, restitution: 0.8}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: a, position: [0, 0, 1], angular_velocity: [1, 2, 3], shapes: [{type: sphere, radius: 0.1, material: rubber}]}
  - {name: b, position: [0.05, 0, 2], shapes: [{type: box, size: [0.2, 0.3, 0.4], material: rubber}]}
)";

Scene scene_of(const std::string& text) {
  return parse_scene(text, "scene.yaml", ".");
}
const Scene& balls() {
  static const Scene scene = scene_of(two_balls);
  return scene;
}
std::uint64_t fingerprint_of(const Scene& scene) {
  return fingerprint(*scene.model, scene.method, scene.run.step);
}

RunResult run(const Scene& scene, double duration, const std::optional<State>& start) {
  RunSettings settings = scene.run;
  settings.duration = duration;
  return run_simulation(scene.model, scene.method, settings, start,
                        [](const State&, const AdvanceReport&, const Auditor&) { return true; });
}

Checkpoint sample_checkpoint() {
  Checkpoint checkpoint{.fingerprint = 42};
  checkpoint.state = make_initial_state(*balls().model);
  checkpoint.audit.sim_time = 1.5;
  checkpoint.audit.report.impacts = 7;
  checkpoint.audit.report.penetration_A = -1;
  checkpoint.audit.report.momentum_error = Vec3(1, 2, 3);
  checkpoint.audit.report.inconsistent = {3, 0, 2, 0.25};
  checkpoint.audit.report.spans = {
      {.begin = 0, .end = 1, .energy = -3, .work = 2, .rise = 1e-9, .impacts = 4, .end_cause = "a crowd"},
      {.scheme = Scheme::time_stepping, .begin = 1, .end = 1.5}};
  checkpoint.audit.books.lowest_of_span = -5;
  checkpoint.state.handover = {.carrier = HandoverMemory::Carrier::soft_steps,
                               .owed = 12.5,
                               .price = 3,
                               .owed_by_steps = 7.5,
                               .soft_step = 0.001};
  checkpoint.audit.warnings = {"one", "two"};
  return checkpoint;
}

TEST(Checkpoint, ARunInTwoPartsEndsAsTheRunInOneGoBitForBit) {
  const TemporaryFolder folder;
  const Scene scene = scene_of(two_balls);
  const RunResult whole = run(scene, 2, std::nullopt);
  const RunResult first = run(scene, 1, std::nullopt);
  write_checkpoint(folder / "run.cp", {fingerprint_of(scene), first.state, first.audit});

  const Checkpoint checkpoint = read_checkpoint(folder / "run.cp", fingerprint_of(scene), *scene.model);
  const RunResult second = run(scene_of(two_balls), 2, checkpoint.state);
  EXPECT_EQ(second.state, whole.state);

  const Audit joined = joined_audit(checkpoint.audit, second.audit);
  EXPECT_GT(whole.audit.report.impacts, first.audit.report.impacts);
  EXPECT_EQ(joined.report.impacts, whole.audit.report.impacts);
  EXPECT_EQ(joined.report.resting, whole.audit.report.resting);
  EXPECT_EQ(joined.sim_time, 2);
  EXPECT_EQ(joined.initial.total(), whole.audit.initial.total());
  EXPECT_EQ(joined.final.total(), whole.audit.final.total());
  // No work is done here, so that both are the same difference.
  EXPECT_EQ(joined.dissipated, whole.audit.dissipated);
}

TEST(Checkpoint, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const Checkpoint written = sample_checkpoint();
  write_checkpoint(folder / "a.cp", written);
  const Checkpoint read = read_checkpoint(folder / "a.cp", 42, *balls().model);
  EXPECT_EQ(read.state, written.state);
  EXPECT_EQ(read.audit.sim_time, 1.5);
  EXPECT_EQ(read.audit.report.impacts, 7);
  EXPECT_EQ(read.audit.report.penetration_A, -1);
  EXPECT_EQ(read.audit.report.momentum_error, Vec3(1, 2, 3));
  EXPECT_EQ(read.audit.report.inconsistent.instants, 3);
  EXPECT_EQ(read.audit.report.inconsistent.body_B, 2);
  EXPECT_EQ(read.audit.report.inconsistent.first, 0.25);
  EXPECT_EQ(read.audit.report.indeterminate.instants, 0);
  EXPECT_EQ(read.audit.report.indeterminate.body_A, -1);
  ASSERT_EQ(read.audit.report.spans.size(), 2u);
  const SchemeSpan &first = read.audit.report.spans[0], &last = read.audit.report.spans[1];
  EXPECT_EQ(first.scheme, Scheme::event_driven);
  EXPECT_EQ(last.scheme, Scheme::time_stepping);
  for (const auto& [value, expected] : {std::pair{first.end, 1.0},
                                        {first.energy, -3.0},
                                        {first.work, 2.0},
                                        {first.rise, 1e-9},
                                        {last.begin, 1.0},
                                        {last.end, 1.5},
                                        {read.audit.books.lowest_of_span, -5.0}})
    EXPECT_EQ(value, expected);
  EXPECT_EQ(first.impacts, 4);
  EXPECT_EQ(first.end_cause, "a crowd");
  EXPECT_EQ(last.end_cause, "");
  EXPECT_EQ(read.audit.warnings, (std::vector<std::string>{"one", "two"}));
}

// A part whose work is not known leaves the energy of the whole unjudged, whichever part it is.
TEST(Checkpoint, WorkThatIsNotKnownStaysSo) {
  const TemporaryFolder folder;
  Checkpoint known = sample_checkpoint(), unknown = known;
  unknown.audit.knows_work = unknown.audit.books.knows_work = false;
  write_checkpoint(folder / "known.cp", known);
  write_checkpoint(folder / "unknown.cp", unknown);
  known = read_checkpoint(folder / "known.cp", 42, *balls().model);
  unknown = read_checkpoint(folder / "unknown.cp", 42, *balls().model);
  EXPECT_TRUE(known.audit.knows_work && known.audit.books.knows_work);
  EXPECT_FALSE(unknown.audit.knows_work || unknown.audit.books.knows_work);
  for (const Checkpoint* const first : {&known, &unknown}) {
    for (const Checkpoint* const second : {&known, &unknown}) {
      const Audit joined = joined_audit(first->audit, second->audit);
      const bool are_known = first == &known && second == &known;
      EXPECT_EQ(joined.knows_work, are_known);
      EXPECT_EQ(joined.books.knows_work, are_known);
    }
  }
}

TEST(Checkpoint, OfAnotherSimulationIsRefused) {
  const TemporaryFolder folder;
  write_checkpoint(folder / "a.cp", sample_checkpoint());
  try {
    read_checkpoint(folder / "a.cp", 43, *balls().model);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("another simulation"), std::string::npos);
  }
}

TEST(Checkpoint, DamageAnywhereIsFound) {
  const TemporaryFolder folder;
  write_checkpoint(folder / "a.cp", sample_checkpoint());
  std::ifstream file(folder / "a.cp", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t i = 0; i < bytes.size(); i += 7) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    std::ofstream(folder / "b.cp", std::ios::binary) << damaged;
    EXPECT_THROW(read_checkpoint(folder / "b.cp", 42, *balls().model), InputError) << i;
    std::ofstream(folder / "b.cp", std::ios::binary) << bytes.substr(0, i);
    EXPECT_THROW(read_checkpoint(folder / "b.cp", 42, *balls().model), InputError) << i;
  }
  EXPECT_THROW(read_checkpoint(folder / "missing.cp", 42, *balls().model), InputError);
  EXPECT_THROW(read_checkpoint(folder.path(), 42, *balls().model), InputError);
}

TEST(Checkpoint, LeavesNoTemporaryFileAndKeepsTheOldOneOnFailure) {
  const TemporaryFolder folder;
  write_checkpoint(folder / "a.cp", sample_checkpoint());
  write_checkpoint(folder / "a.cp", sample_checkpoint());
  EXPECT_THROW(write_checkpoint(folder / "missing/a.cp", sample_checkpoint()), FileError);
  std::filesystem::create_directory(folder / "folder");
  std::ofstream(folder / "folder/file").put('1');
  EXPECT_THROW(write_checkpoint(folder / "folder", sample_checkpoint()), FileError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

TEST(Fingerprint, TellsSimulationsApartAndNotTheirSpelling) {
  const std::string text = two_balls;
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string copy = text;
    copy.replace(copy.find(from), from.size(), to);
    return fingerprint_of(scene_of(copy));
  };
  const std::uint64_t original = fingerprint_of(scene_of(text));
  EXPECT_EQ(original, fingerprint_of(scene_of(text + "\n# a comment\n")));
  EXPECT_EQ(original, changed("duration: 2", "duration: 20"));
  EXPECT_EQ(original, changed("radius: 0.1", "radius: 0.10"));
  EXPECT_NE(original, changed("radius: 0.1", "radius: 0.11"));
  EXPECT_NE(original, changed("restitution: 0.8", "restitution: 0.7"));
  for (const char* const key : {"tangential_restitution", "rolling_friction", "torsional_friction"}) {
    EXPECT_NE(original, changed("restitution: 0.8", std::string("restitution: 0.8, ") + key + ": 0.1"))
        << key;
  }
  EXPECT_NE(original, changed("name: two balls", "name: two\nexclude: [[a, b]]"));
  EXPECT_NE(original, changed("density: 1000", "density: 1001"));
  EXPECT_NE(original, changed("position: [0, 0, 1]", "position: [0, 0, 1.5]"));
  EXPECT_NE(original, changed("size: [0.2, 0.3, 0.4]", "size: [0.2, 0.4, 0.3]"));
  EXPECT_NE(original, changed("name: two balls", "name: two\nmethod: {integrator: rk4}"));
  EXPECT_NE(original, changed("duration: 2", "duration: 2, step: 0.02"));
  EXPECT_NE(original, changed("name: two balls", "name: two\nworld: {gravity: [0, 0, -9]}"));
}

}  // namespace
}  // namespace rigor::checkpoint_test
