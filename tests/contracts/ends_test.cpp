// How the program ends where scenes are hard or files lie: by an exit code of docs/errors.md, soon, and with
// files that can be read.

#include "contracts/program.hpp"
#include "io/forged_files.hpp"
#include "rigor/io/trajectory/hdf5_reader.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

namespace rigor::ends_test {
namespace {

constexpr const char* head =
    "rigor: 1\nrun: {duration: 0.5, step: 0.005, output_interval: 0.02}\nbodies:\n"
    "  - {name: floor, motion: static, shapes: [{type: plane}]}\n";

struct HardScene {
  const char* name;
  const char* bodies;
};

/// Valid scenes that no integrator with a step of 5 ms follows.
constexpr HardScene hard_scenes[] = {
    {"drag",
     "  - {name: a, position: [0, 0, 1], velocity: [1, 0, 0], linear_drag: 3e14, angular_drag: 1e15, shapes: "
     "[{type: box, size: [0.2, 0.3, 0.2]}]}\n"},
    {"spring",
     "  - {name: a, position: [0, 0, 2], mass: 2e-3, shapes: [{type: sphere, radius: 0.1}]}\nforces:\n"
     "  - {type: spring, between: [world, a], points: [[0, 0, 3], [0, 0, 0]], stiffness: 5e14, length: "
     "0.5}\n"},
    {"distance",
     "  - {name: a, position: [0, 0, 3], mass: 1e-6, shapes: [{type: sphere, radius: 0.1}]}\n"
     "  - {name: b, position: [0.3, 0, 3], mass: 1, shapes: [{type: sphere, radius: 0.1}]}\njoints:\n"
     "  - {name: s, type: distance, bodies: [a, b], anchors: [[0, 0, 3], [0.3, 0, 3]], limits: [0.2, 0.5], "
     "stiffness: 1e12, damping: 1e9}\n"},
    {"chain",
     "  - {name: a, position: [0, 0, 3], mass: 2e-6, shapes: [{type: sphere, radius: 0.1}]}\n"
     "  - {name: b, position: [0.3, 0, 3], mass: 3, shapes: [{type: sphere, radius: 0.1}]}\n"
     "  - {name: c, position: [0.6, 0, 3], mass: 1e5, shapes: [{type: sphere, radius: 0.1}]}\njoints:\n"
     "  - {name: s, type: distance, bodies: [a, b], anchors: [[0, 0, 3], [0.3, 0, 3]], limits: [0.1, 0.5], "
     "stiffness: 1e12, damping: 1e9}\n"
     "  - {name: r, type: distance, bodies: [b, c], anchors: [[0.3, 0, 3], [0.6, 0, 3]], limits: [0.1, 0.5], "
     "stiffness: 1e12, damping: 1e9}\n"},
    {"force",
     "  - {name: a, position: [0, 0, 1], shapes: [{type: box, size: [0.2, 0.3, 0.2]}]}\nforces:\n"
     "  - {type: constant, body: a, force: [1e15, 0, 0], point: [0, 0, 0.1]}\n"},
    {"slider",
     "  - {name: a, position: [0, 0, 3], mass: 1e-6, velocity: [0, 0, -2], shapes: [{type: sphere, radius: "
     "0.1}]}\njoints:\n"
     "  - {name: s, type: slider, bodies: [world, a], anchor: [0, 0, 3], axis: [0, 0, 1], limits: [-0.1, "
     "0.1], "
     "damping: 1e4}\n"}};

/// Every number of the rows of a trajectory in CSV, as many as there are names.
void expect_finite_rows(const std::string& text, const std::string& run) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto commas = std::count(line.begin(), line.end(), ',');
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << run;
    std::istringstream values(line);
    for (std::string value; std::getline(values, value, ',');)
      EXPECT_TRUE(std::isfinite(std::strtod(value.c_str(), nullptr) * 1e-150)) << run << ": " << value;
  }
}

/// Waits until the run has begun its trajectory in CSV; from then on it answers signals, whatever else the
/// machine does.
void wait_for_rows(const ProgramFolder& folder) {
  const auto begin = std::chrono::steady_clock::now();
  while (line_count(folder.read("a.csv")) < 1 &&
         std::chrono::steady_clock::now() - begin < std::chrono::seconds(20))
    ::usleep(1000);
}

TEST(Ends, HardScenesEndOnSigtermWithWholeFiles) {
  const ProgramFolder folder;
  for (const HardScene& scene : hard_scenes) {
    folder.write("a.yaml", std::string(head) + scene.bodies);
    for (const char* const scheme : {"event-driven", "time-stepping", "impulse-based"}) {
      const std::string run = std::string(scene.name) + " " + scheme;
      std::filesystem::remove(folder / "a.csv");
      const pid_t child =
          folder.start({"run", "a.yaml", "--quiet", "--set", std::string("method.scheme=") + scheme, "-o",
                        "a.csv", "-o", "a.h5", "--json", "a.json"});
      wait_for_rows(folder);
      ::usleep(30000);
      ::kill(child, SIGTERM);
      const auto begin = std::chrono::steady_clock::now();
      const ProgramResult result = folder.wait(child);
      const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
      EXPECT_LT(waited.count(), 2) << run;  // Beside other tests; 0.05 s alone.
      // A signal that finds the run over and its files closed, just before the process ends, ends it.
      EXPECT_TRUE(result.code == 130 || result.code == 4 || result.code == 0 || result.code == 1 ||
                  result.code == -SIGTERM)
          << run << ": " << result.code << "\n"
          << result.error;
      EXPECT_EQ(result.error.find("broken promise"), std::string::npos) << run << ": " << result.error;
      expect_finite_rows(folder.read("a.csv"), run);
      EXPECT_GE(read_hdf5_trajectory(folder / "a.h5").time.size(), 1u) << run;
      EXPECT_TRUE(folder.read("a.json").ends_with("}\n")) << run;
    }
  }
}

TEST(Ends, AForgedCheckpointIsRefusedWithAReasonOrRuns) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  ASSERT_EQ(folder.run({"run", "ball.yaml", "--quiet", "--duration", "0.4", "--checkpoint", "a.cp"}).code, 0);
  const std::string bytes = folder.read("a.cp");
  std::mt19937_64 engine(7);
  int refused = 0;
  for (int i = 0; i < 25; ++i) {
    std::ofstream(folder / "b.cp", std::ios::binary) << test::forged_checkpoint(bytes, engine);
    const ProgramResult result =
        folder.run({"run", "ball.yaml", "--quiet", "--duration", "0.6", "--resume", "b.cp", "-o", "a.csv"});
    EXPECT_GE(result.code, 0) << i;
    EXPECT_LE(result.code, 5) << i;
    if (result.code == 3) ++refused;
    if (result.code > 1) expect_contains(result.error, "error: ");
    if (result.code < 2) expect_finite_rows(folder.read("a.csv"), "forged");
  }
  EXPECT_GT(refused, 10);
}

TEST(Ends, AReaderOfAKilledRunsFileSaysHowFarItCame) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const pid_t child = folder.start({"run", "ball.yaml", "--duration", "1e8", "-o", "a.h5", "-o", "a.csv"});
  while (line_count(folder.read("a.csv")) < 20) ::usleep(1000);
  ::kill(child, SIGKILL);
  folder.wait(child);
  const ProgramResult result = folder.run({"plot", "a.h5", "energy.total", "-o", "a.svg"});
  EXPECT_EQ(result.code, 0) << result.error;
  expect_contains(result.error, "warning: 'a.h5': the run ended at t = ");
  expect_contains(result.error, " s of 1e+08 s");
}

TEST(Ends, NamesThatTurnALineAreShownEscaped) {
  const ProgramFolder folder;
  const std::string name = "\\u202Ellab\\u200F";  // In YAML; control characters are refused.
  std::string scene = ball_scene;
  scene.replace(scene.find("name: ball, pos"), 10, "name: \"" + name + "\"");
  folder.write("a.yaml", scene);
  const ProgramResult result = folder.run({"run", "a.yaml", "-o", "a.csv", "-o", "a.html"});
  EXPECT_EQ(result.code, 0) << result.error;
  const std::string shown = "\\xe2\\x80\\xaellab\\xe2\\x80\\x8f";
  expect_contains(result.out, shown);
  expect_contains(folder.read("a.csv"), shown + ".position.x [m]");
  for (const std::string& text : {result.out, result.error, folder.read("a.csv")}) {
    EXPECT_EQ(text.find("\u202E"), std::string::npos);
  }
}

TEST(Ends, ATrajectoryTellsWhereItsSceneLiesOnlyIfAsked) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  EXPECT_EQ(folder.run({"run", "ball.yaml", "--quiet", "-o", "a.h5"}).code, 0);
  EXPECT_EQ(read_hdf5_trajectory(folder / "a.h5").scene_file, "ball.yaml");
  EXPECT_EQ(folder.read("a.h5").find((folder / "").string()), std::string::npos);
  EXPECT_EQ(folder.run({"run", "ball.yaml", "--quiet", "--keep-path", "-o", "a.h5"}).code, 0);
  EXPECT_EQ(read_hdf5_trajectory(folder / "a.h5").scene_file, (folder / "ball.yaml").string());
}

}  // namespace
}  // namespace rigor::ends_test
