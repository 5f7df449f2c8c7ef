#include "studies.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/study/workers/journal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace rigor::runner_test {
namespace {

using studies::finding_of;
using studies::finished;

const std::string slides = R"yaml(rigor_study: 1
scene: ../ramp_slide.yaml
kind: sweep
repeats: 2
set:
  run: {duration: 2, step: 0.01, output_interval: 0.5}
  world.gravity: [0, 0, -9.81]
  expect: []
parameters:
  - {name: mu, key: materials.wood.friction, range: [0.3, 1], count: 5}
  - {name: v, range: [0.5, 3]}
assign:
  bodies.block.velocity: [v, 0, 0]
outcomes:
  - {name: distance, value: body.block.position.x}
  - {name: error, formula: "distance - v^2 / (2*mu*9.81)"
}
)yaml";

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string temporary(const std::string& name) {
  const std::string path = testing::TempDir() + "rigor_" + name;
  std::filesystem::remove(path);
  return path;
}

TEST(Study, BlocksSlideAsFarAsFrictionSays) {
  const auto study = finished(slides);
  ASSERT_EQ(study->run_count(), 10u);
  for (std::uint64_t run = 0; run < 10; ++run) EXPECT_NEAR(study->rows().value(run, 1), 0, 1e-9);
}

TEST(Study, HasTheSameBitsOnAnyNumberOfThreads) {
  const std::string alone = study_csv(*finished(slides));
  EXPECT_EQ(study_csv(*finished(slides, 2)), alone);
  EXPECT_EQ(study_csv(*finished(slides, 3)), alone);
}

/// Runs until so many rows are delivered.
std::uint64_t interrupted_after(int rows, const std::string& journal) {
  Study study(parse_study(slides, std::string(RIGOR_SOURCE_DIR) + "/scenes/studies/test.yaml"));
  const auto pool = make_thread_pool([&] { return study.make_executor(); }, 1);
  int seen = 0;
  StudySettings settings{journal, [&] { return seen >= rows; }, [&](const auto&) { ++seen; }};
  EXPECT_FALSE(study.run(*pool, settings));
  return study.rows().count();
}

TEST(Study, ItsJournalBelongsToOneProcess) {
  const std::string path = temporary("locked.journal");
  {
    const JournalLock lock(path);
    EXPECT_THROW(JournalLock(path, 0.1), InputError);
    // The wait ends when asked.
    const std::function<bool()> asked = [] { return true; };
    const InterruptScope scope(asked);
    EXPECT_THROW(JournalLock(path, 1000), Interrupted);
  }
  {
    const JournalLock lock(path);
    Study study(parse_study(slides, std::string(RIGOR_SOURCE_DIR) + "/scenes/studies/test.yaml"));
    // Looking takes no lock.
    EXPECT_EQ(study.task_of(0, path).run, 0u);
  }
  EXPECT_NO_THROW(JournalLock(path, 0));
  const auto study = finished(slides, 1, {path, {}, {}});
  EXPECT_EQ(study->run_count(), 10u);
}

TEST(Study, GoesOnWhereItWasInterruptedAndRunsNothingTwice) {
  const std::string whole = study_csv(*finished(slides)), path = temporary("resume.journal");
  EXPECT_EQ(interrupted_after(3, path), 3u);
  EXPECT_EQ(interrupted_after(4, path), 7u);
  const std::uintmax_t before = std::filesystem::file_size(path);
  const auto study = finished(slides, 2, {path, {}, {}});
  EXPECT_EQ(study->resumed(), 7u);
  EXPECT_EQ(study_csv(*study), whole);
  EXPECT_EQ(std::filesystem::file_size(path), before + 3 * journal_row_bytes(2));
}

TEST(Journal, MayEndAtAnyByte) {
  const std::string whole = study_csv(*finished(slides)), path = temporary("cut.journal");
  finished(slides, 1, {path, {}, {}});
  const std::string bytes = bytes_of(path);
  // As a killed process leaves it: at any length the rows before it are kept, and the study ends the same.
  for (std::size_t length = 0; length <= bytes.size(); length += 13) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes.substr(0, length);
    const auto study = finished(slides, 1, {path, {}, {}});
    ASSERT_EQ(study_csv(*study), whole) << length;
    ASSERT_EQ(bytes_of(path).size(), bytes.size()) << length;
  }
}

TEST(Journal, LeavesOutARowWhoseBytesChanged) {
  const std::string path = temporary("damage.journal");
  finished(slides, 1, {path, {}, {}});
  std::string bytes = bytes_of(path);
  bytes[bytes.size() - 20] = static_cast<char>(bytes[bytes.size() - 20] ^ 1);
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  const auto study = finished(slides, 1, {path, {}, {}});
  EXPECT_EQ(study->resumed(), 9u);
  EXPECT_EQ(study_csv(*study), study_csv(*finished(slides)));
}

TEST(Journal, OfAnotherStudyIsRefused) {
  const std::string path = temporary("other.journal");
  finished(slides, 1, {path, {}, {}});
  std::string other = slides;
  other.replace(other.find("count: 5"), 8, "count: 6");
  EXPECT_THROW(finished(other, 1, {path, {}, {}}), InputError);
}

TEST(Study, ARunThatCannotBeIsARowWithItsReason) {
  std::string text = slides;
  text.replace(text.find("range: [0.3, 1], count: 5"), 25, "values: [0.3, -1, 0.5]");
  const auto study = finished(text);
  ASSERT_EQ(study->run_count(), 6u);
  EXPECT_EQ(study->rows().status(2), RunStatus::refused);
  EXPECT_NE(study->rows().reason(2).find("friction is -1"), std::string::npos) << study->rows().reason(2);
  EXPECT_TRUE(std::isnan(study->rows().value(2, 0)));
  EXPECT_EQ(study->rows().status(4), RunStatus::done);
}

TEST(Study, MistakesAreToldBeforeAnythingRuns) {
  const auto message = [](const std::string& from, const std::string& to) {
    std::string text = slides;
    text.replace(text.find(from), from.size(), to);
    try {
      const Study study(parse_study(text, std::string(RIGOR_SOURCE_DIR) + "/scenes/studies/test.yaml"));
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.messages().front());
    }
  };
  EXPECT_EQ(message("kind: sweep", "kind: sweep"), "");
  EXPECT_NE(message("kind: sweep", "kind: sweap")
                .find("test.yaml:3:7: the study: unknown kind 'sweap'; did you mean 'sweep'?"),
            std::string::npos);
  EXPECT_NE(message("repeats: 2", "repeat: 2").find("unknown key 'repeat'"), std::string::npos);
  EXPECT_NE(message("range: [0.3, 1]", "range: [1, 0.3]").find("range is empty"), std::string::npos);
  EXPECT_NE(message("2*mu*9.81", "2*nu*9.81").find("unknown name 'nu'; did you mean 'mu'?"),
            std::string::npos);
  EXPECT_NE(
      message("body.block.position.x", "body.blok.position.x").find("no quantity 'body.blok.position.x'"),
      std::string::npos);
  EXPECT_NE(
      message("materials.wood.friction", "materials.wod.friction").find("there is no 'wod' in the list"),
      std::string::npos);
  EXPECT_NE(message("repeats: 2", "repeats: 90000000").find("runs, must be at most 1e+08"),
            std::string::npos);
  EXPECT_NE(message("[v, 0, 0]", "[w, 0, 0]").find("unknown name 'w'"), std::string::npos);
  EXPECT_NE(message("v^2 / (", "v^2 / ((").find("formula"), std::string::npos);
}

TEST(Study, FilesOfEqualStudiesAreEqual) {
  const auto a = finished(slides), b = finished(slides, 2);
  for (const std::string suffix : {".csv", ".json", ".h5", ".html", ".svg"}) {
    const std::string one = temporary("one" + suffix), two = temporary("two" + suffix);
    write_study(*a, one);
    write_study(*b, two);
    EXPECT_GT(bytes_of(one).size(), 100u);
    EXPECT_EQ(bytes_of(one), bytes_of(two)) << suffix;
  }
}

TEST(Outcomes, AreWhatTheSceneSays) {
  const auto study = finished(R"yaml(rigor_study: 1
scene: ../bouncing_ball.yaml
kind: sweep
set:
  run: {duration: 1, step: 0.01, output_interval: 0.01}
  expect: []
parameters:
  - {name: h, values: [1]}
assign:
  bodies.ball.position: [0, 0, h + 0.1]
outcomes:
  - {name: impacts, count: impact}
  - {name: none, count: impact, bodies: [ball, ball]}
  - {name: strike, time_of: impact, bodies: [ball, floor]}
  - {name: never, time_of: impact, number: 9, else: -1}
  - {name: impulse, impulse: largest, bodies: ball}
  - {name: lowest, min: body.ball.position.z}
  - {name: highest, max: body.ball.position.z}
  - {name: falling, first: "body.ball.velocity.z < -2"}
  - {name: middle, value: body.ball.position.z, at: 0.3}
  - {name: booked, value: audit.impacts}
  - {name: drift, value: energy.total - 9.81*(h + 0.1)}
  - {name: twice, formula: 2*impacts}
)yaml");
  const double fall = std::sqrt(2 / 9.81);
  EXPECT_EQ(finding_of(*study, "impacts").value, 1);
  EXPECT_NEAR(finding_of(*study, "strike").value, fall, 1e-12);
  EXPECT_EQ(finding_of(*study, "never").value, -1);
  EXPECT_NEAR(finding_of(*study, "impulse").value, 2 * std::sqrt(2 * 9.81), 1e-10);
  EXPECT_NEAR(finding_of(*study, "highest").value, 1.1, 1e-12);
  EXPECT_NEAR(finding_of(*study, "falling").value, 0.21, 1e-12);
  EXPECT_NEAR(finding_of(*study, "middle").value, 1.1 - 0.5 * 9.81 * 0.09, 1e-12);
  EXPECT_EQ(finding_of(*study, "booked").value, 1);
  EXPECT_NEAR(finding_of(*study, "drift").value, 0, 1e-10);
  EXPECT_EQ(finding_of(*study, "twice").value, 2);
}

TEST(Chaos, NeighboursInFreeFlightPartWithTheirVelocities) {
  // δ(t) = 1e-9 m/s t: neither an exponent above that of a power law nor a horizon.
  const auto study = finished(R"yaml(rigor_study: 1
scene: ../bouncing_ball.yaml
kind: chaos
runs: 1
perturb: v
perturbation: 1e-6
bound: 5e-7
set:
  run: {duration: 1, step: 0.01, output_interval: 0.1}
  world.gravity: [0, 0, 0]
  expect: []
parameters:
  - {name: v, range: [1, 2]}
assign:
  bodies.ball.velocity: [v, 0, 0]
outcomes:
  - {name: x, value: body.ball.position.x}
)yaml");
  EXPECT_NEAR(finding_of(*study, "horizon").value, 0.6, 0.101);
  EXPECT_NEAR(finding_of(*study, "last_distance").value, 1e-6, 1e-14);
}

}  // namespace
}  // namespace rigor::runner_test
