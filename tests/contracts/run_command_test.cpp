#include "contracts/program.hpp"
#include "rigor/io/trajectory/hdf5_reader.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

// What `rigor run` promises: audits, files, exit codes, whatever happens on the way.

namespace rigor::run_command_test {
namespace {

using Json = nlohmann::json;

// Audits

TEST(RunCommand, ARunPrintsItsAuditOnStdoutAndNothingElse) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult result = folder.run({"run", "ball.yaml"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.error, "");
  for (const char* part : {"ball: 1 s simulated", "energy", "penetration", "audit passed"})
    expect_contains(result.out, part);
  EXPECT_EQ(result.out.find('\x1b'), std::string::npos);
  const ProgramResult quiet = folder.run({"run", "ball.yaml", "--quiet", "--threads", "4"});
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out + quiet.error, "");
}

TEST(RunCommand, JsonOnStdoutIsJsonAndTheTextGoesToStderr) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult result = folder.run({"run", "ball.yaml", "--duration", "0.5", "--json", "-"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(Json::parse(result.out)["sim_time"], 0.5);
  expect_contains(result.error, "audit passed");
  folder.run({"run", "ball.yaml", "--duration", "0.5", "--json", "audit.json", "--quiet"});
  EXPECT_EQ(Json::parse(folder.read("audit.json"))["bodies"], Json::parse(result.out)["bodies"]);
}

TEST(RunCommand, AllOutputsTellTheSameMotion) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult result =
      folder.run({"run", "ball.yaml", "-o", "a.csv", "-o", "a.h5", "-o", "a.json", "--json", "audit.json"});
  ASSERT_EQ(result.code, 0) << result.error;
  const StoredTrajectory stored = read_hdf5_trajectory(folder / "a.h5");
  // Outputs at 0, 0.1, ..., 1 s.
  ASSERT_EQ(stored.time.size(), 11u);
  EXPECT_EQ(stored.bodies, (std::vector<std::string>{"floor", "ball"}));
  EXPECT_EQ(stored.scene_text, ball_scene);
  EXPECT_EQ(line_count(folder.read("a.csv")), 12u);
  const Json json = Json::parse(folder.read("a.json")), audit = Json::parse(folder.read("audit.json"));
  ASSERT_EQ(json["trajectory"].size(), 11u);
  EXPECT_EQ(json["audit"], audit);
  const double z = audit["bodies"]["ball"]["position"][2].get<double>();
  EXPECT_EQ(stored.position[10 * 6 + 5], z);
  EXPECT_EQ(json["trajectory"][10]["position"][1][2].get<double>(), z);
  const auto impacts = std::count(stored.event_kind.begin(), stored.event_kind.end(), 0);
  EXPECT_EQ(impacts, audit["events"]["impacts"].get<long>());
}

TEST(RunCommand, AnAuditThatBreaksItsToleranceIsOne) {
  const ProgramFolder folder;
  // Explicit Euler makes an oscillator gain energy.
  folder.write("spring.yaml",
               "rigor: 1\nname: spring\nrun: {duration: 2, step: 0.01}\nmethod: {integrator: euler}\n"
               "world: {gravity: [0, 0, 0]}\n"
               "bodies: [{name: a, position: [1, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}]\n"
               "forces: [{type: spring, between: [world, a], points: [[0, 0, 0], [0, 0, 0]], stiffness: 100, "
               "damping: 0, "
               "length: 0.5}]\n");
  const ProgramResult result = folder.run({"run", "spring.yaml"});
  EXPECT_EQ(result.code, 1) << result.out << result.error;
  expect_contains(result.out, "audit FAILED");
  expect_contains(result.out, "unexplained rise of energy");
}

// Its motors raise the energy, and nobody has added up by how much: "0 J by motors" and an energy within its
// tolerance would be false.
TEST(RunCommand, WhereTheWorkIsNotKnownEnergyIsNotSaidToBeJudged) {
  const ProgramFolder folder;
  folder.write("mill.yaml",
               "rigor: 1\nname: mill\nrun: {duration: 0.5, step: 0.01}\nbodies:\n"
               "  - {name: wheel, mass: 1, shapes: [{type: cylinder, radius: 0.2, length: 0.1}]}\njoints:\n"
               "  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 0, 0], axis: [0, 0, 1], "
               "motor: {velocity: 20, max_force: 0.5}}\n");
  for (const bool is_soft : {false, true}) {
    std::vector<std::string> command = {"run",        "mill.yaml", "--json",
                                        "audit.json", "--set",     "method.scheme=time-stepping"};
    if (is_soft) command.insert(command.end(), {"--set", "method.solver=substep"});
    const ProgramResult result = folder.run(command);
    ASSERT_EQ(result.code, 0) << result.error;
    const Json energy = Json::parse(folder.read("audit.json"))["energy"];
    EXPECT_GT(energy["final"].get<double>(), energy["initial"].get<double>() + 0.1);
    for (const char* key : {"work", "motor_work", "dissipated", "max_increase"})
      EXPECT_EQ(energy[key].is_null(), is_soft) << key;
    EXPECT_EQ(result.out.find("J by motors") == std::string::npos, is_soft) << result.out;
    expect_contains(result.out, is_soft ? "audit passed: momentum, joints and penetration are within their "
                                          "tolerances; energy is not judged"
                                        : "audit passed: energy, momentum");
  }
}

TEST(RunCommand, ASimulationThatCannotGoOnIsFourAndKeepsWhatItHas) {
  const ProgramFolder folder;
  // A piston presses a ball that lies on the floor.
  folder.write(
      "piston.yaml",
      "rigor: 1\nname: piston\nmethod: {scheme: event-driven}\nrun: {duration: 2, output_interval: "
      "0.01}\nworld: {gravity: [0, 0, 0]}\n"
      "materials: [{name: m, restitution: 0, friction: 0}]\nbodies:\n"
      "  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: "
      "m}]}\n"
      "  - {name: ball, position: [0, 0, 0.5], mass: 1, velocity: [0, 0, -1], shapes: [{type: sphere, "
      "radius: 0.1, "
      "material: m}]}\n"
      "  - {name: piston, motion: kinematic, position: [0, 0, 2], velocity: [0, 0, -1], shapes: [{type: box, "
      "size: "
      "[1, 1, 1], material: m}]}\n");
  const ProgramResult result = folder.run({"run", "piston.yaml", "-o", "a.csv", "-o", "a.h5"});
  EXPECT_EQ(result.code, 4) << result.out << result.error;
  expect_contains(result.error, "the simulation stopped at t = 1.");
  expect_contains(result.error, "bodies: ");
  expect_contains(result.error, "ball");
  // What is judged is judged until there.
  expect_contains(result.out, "audit passed until t = 1.3 s of 2 s");
  expect_contains(result.error, "try --set method.scheme=time-stepping: ");
  const ProgramResult json = folder.run({"run", "piston.yaml", "--json", "-", "--quiet"});
  EXPECT_EQ(Json::parse(json.out)["complete"], false);
  EXPECT_NEAR(Json::parse(json.out)["end_time"].get<double>(), 1.3, 1e-6);
  EXPECT_EQ(Json::parse(json.out)["duration"], 2);
  // The advice is what the documentation says.
  const std::string marker = "what to try: ";
  const std::size_t at = result.error.find(marker);
  ASSERT_NE(at, std::string::npos);
  const std::string advice =
      result.error.substr(at + marker.size(), result.error.find('\n', at) - at - marker.size());
  expect_contains(text_of(RIGOR_SOURCE_DIR "/docs/errors.md"), advice);
  // The piston reaches the ball's height of 0.2 m at 1.3 s; all outputs until then are there.
  EXPECT_GT(read_hdf5_trajectory(folder / "a.h5").time.size(), 120u);
  EXPECT_EQ(line_count(folder.read("a.csv")), read_hdf5_trajectory(folder / "a.h5").time.size() + 1);
}

TEST(RunCommand, ALimitOfProcessorTimeEndsTheRunWithWhatThereIs) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  // The whole run would take half a minute.
  const ProgramResult result = folder.run(
      {"run", "ball.yaml", "--duration", "100000", "--cpu-limit", "0.05", "-o", "a.csv", "--json", "a.json"});
  EXPECT_EQ(result.code, 4) << result.out << result.error;
  expect_contains(result.error, "out of time: --cpu-limit 0.05 ended the run after ");
  expect_contains(result.error, "the files are closed");
  expect_contains(result.out, "audit passed until t = ");
  const Json audit = Json::parse(folder.read("a.json"));
  EXPECT_EQ(audit["complete"], false);
  EXPECT_GT(line_count(folder.read("a.csv")), 1u);
  expect_contains(audit["warnings"].dump(), "out of time");
  // A limit that is not reached changes nothing.
  EXPECT_EQ(folder.run({"run", "ball.yaml", "--duration", "0.1", "--cpu-limit", "100", "--quiet"}).code, 0);
}

// Files

TEST(RunCommand, OutputsThatCannotBeWrittenAreFiveBeforeTheRun) {
  const ProgramFolder folder;
  // So long that the test would not end if it were run.
  folder.write("ball.yaml", ball_scene);
  std::filesystem::create_directories(folder / "folder.csv");
  std::filesystem::create_directories(folder / "folder.h5");
  const std::vector<std::vector<std::string>> wrong = {
      {"-o", "folder.csv"},           {"-o", "folder.h5"},
      {"-o", "missing/a.csv"},        {"-o", "missing/a.h5"},
      {"-o", "missing/a.json"},       {"--json", "missing/a"},
      {"--json", "folder.h5"},        {"--checkpoint", "missing/a.cp"},
      {"--checkpoint", "folder.csv"},
  };
  for (std::vector<std::string> arguments : wrong) {
    arguments.insert(arguments.begin(), {"run", "ball.yaml", "--duration", "1e9"});
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 5) << testing::PrintToString(arguments);
    EXPECT_EQ(result.error.rfind("error: cannot write '", 0), 0u) << result.error;
    EXPECT_EQ(line_count(result.error), 1u);
  }
}

TEST(RunCommand, ADiskThatFillsUpIsFiveWithTheAuditSoFar) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  std::filesystem::create_symlink("/dev/full", folder / "full.json");
  const ProgramResult result = folder.run({"run", "ball.yaml", "-o", "a.csv", "--json", "full.json"});
  EXPECT_EQ(result.code, 5);
  expect_contains(result.out, "audit passed");
  expect_contains(result.error, "No space left on device");
  EXPECT_EQ(line_count(folder.read("a.csv")), 12u);
}

TEST(RunCommand, APageIsWrittenAtTheEndAndWhenInterrupted) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const auto is_whole = [](const std::string& page) {
    return page.rfind("<!doctype html>", 0) == 0 && page.find("data-kind=\"frames\"") != std::string::npos &&
           page.ends_with("</html>\n");
  };
  EXPECT_EQ(folder.run({"run", "ball.yaml", "-o", "a.html", "--quiet"}).code, 0);
  EXPECT_TRUE(is_whole(folder.read("a.html")));
  const pid_t child = folder.start({"run", "ball.yaml", "--duration", "1e8", "-o", "b.html", "-o", "b.csv"});
  while (line_count(folder.read("b.csv")) < 3) ::usleep(1000);
  ::kill(child, SIGINT);
  EXPECT_EQ(folder.wait(child).code, 130);
  EXPECT_TRUE(is_whole(folder.read("b.html")));
  const ProgramResult refused = folder.run({"run", "ball.yaml", "-o", "nowhere/c.html"});
  EXPECT_EQ(refused.code, 5);
  expect_contains(refused.error, "cannot write 'nowhere/c.html'");
}

TEST(RunCommand, AnInterruptClosesTheFilesAndIs130) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t child = folder.start({"run", "ball.yaml", "--duration", "1e8", "-o", "a.csv", "-o", "a.h5",
                                      "-o", "a.json", "--json", "audit.json", "--checkpoint", "a.cp"});
    while (line_count(folder.read("a.csv")) < 3) ::usleep(1000);
    ::kill(child, signal);
    const ProgramResult result = folder.wait(child);
    EXPECT_EQ(result.code, 130);
    expect_contains(result.error, "interrupted at t = ");
    expect_contains(result.out, "audit passed");
    const Json json = Json::parse(folder.read("a.json")), audit = Json::parse(folder.read("audit.json"));
    EXPECT_EQ(json["trajectory"].size(), read_hdf5_trajectory(folder / "a.h5").time.size());
    EXPECT_EQ(json["trajectory"].size() + 1, line_count(folder.read("a.csv")));
    EXPECT_EQ(json["trajectory"].back()["time"], audit["sim_time"]);
    EXPECT_TRUE(folder.has("a.cp"));
    std::filesystem::remove(folder / "a.csv");
  }
}

// However far off the next output time is.
TEST(RunCommand, AnInterruptBetweenOutputsEndsAtTheLastOne) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const pid_t child = folder.start(
      {"run", "ball.yaml", "--duration", "1e8", "--set", "run.output_interval=1e8", "-o", "a.csv"});
  while (!folder.has("a.csv")) ::usleep(1000);
  ::usleep(100000);
  ::kill(child, SIGINT);
  const ProgramResult result = folder.wait(child);
  EXPECT_EQ(result.code, 130);
  expect_contains(result.error, "interrupted at t = 0 s");
  EXPECT_EQ(line_count(folder.read("a.csv")), 2u);
}

TEST(RunCommand, AKilledRunLeavesFilesThatCanBeRead) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const pid_t child = folder.start({"run", "ball.yaml", "--duration", "1e8", "-o", "a.csv", "-o", "a.h5"});
  while (line_count(folder.read("a.csv")) < 100) ::usleep(1000);
  ::kill(child, SIGKILL);
  EXPECT_EQ(folder.wait(child).code, -SIGKILL);
  const StoredTrajectory stored = read_hdf5_trajectory(folder / "a.h5");
  EXPECT_GE(stored.time.size(), 1u);
  for (std::size_t k = 0; k < stored.time.size(); ++k) {
    ASSERT_DOUBLE_EQ(stored.time[k], 0.1 * static_cast<double>(k));
  }
}

TEST(RunCommand, AResumedRunEndsAsTheRunInOneGoBitForBit) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const auto bodies_of = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"run", "ball.yaml", "--json", "-", "--quiet"});
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 0) << result.error;
    const std::size_t at = result.out.find("\"bodies\": {");
    return at == std::string::npos ? "" : result.out.substr(at);
  };
  // As text: seventeen digits tell all doubles apart.
  const std::string whole = bodies_of({"--duration", "2"});
  bodies_of({"--duration", "1", "--checkpoint", "a.cp", "--checkpoint-every", "0.5"});
  EXPECT_EQ(bodies_of({"--duration", "2", "--resume", "a.cp"}), whole);
  EXPECT_FALSE(whole.empty());

  const ProgramResult nothing_to_do = folder.run({"run", "ball.yaml", "--resume", "a.cp"});
  EXPECT_EQ(nothing_to_do.code, 2);
  const ProgramResult other =
      folder.run({"run", "ball.yaml", "--duration", "2", "--resume", "a.cp", "--set", "bodies.ball.mass=2"});
  EXPECT_EQ(other.code, 3);
  expect_contains(other.error, "another simulation");
}

TEST(RunCommand, AResumedAuditCountsTheWholeRun) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  folder.run({"run", "ball.yaml", "--duration", "2", "--json", "whole.json"});
  folder.run({"run", "ball.yaml", "--duration", "1", "--checkpoint", "a.cp"});
  folder.run({"run", "ball.yaml", "--duration", "2", "--resume", "a.cp", "--json", "parts.json"});
  const Json whole = Json::parse(folder.read("whole.json")), parts = Json::parse(folder.read("parts.json"));
  for (const char* key : {"scene", "method", "sim_time", "events"}) EXPECT_EQ(whole[key], parts[key]) << key;
  EXPECT_EQ(whole["energy"]["initial"], parts["energy"]["initial"]);
  EXPECT_EQ(whole["energy"]["dissipated"], parts["energy"]["dissipated"]);
}

TEST(RunCommand, AFullStandardOutputIsFive) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const ProgramFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / ".out");
  EXPECT_EQ(folder.run({"methods"}).code, 5);
}

// Terminals

TEST(RunCommand, ProgressAndColoursAppearOnATerminalOnly) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult colored = folder.run_on_terminal({"run", "ball.yaml"}, false);
  EXPECT_EQ(colored.code, 0);
  for (const char* part : {"ETA", "x real time", "energy drift", "\x1b[32maudit passed\x1b[0m"})
    expect_contains(colored.out, part);
  const ProgramResult plain = folder.run_on_terminal({"run", "ball.yaml"}, true);
  expect_contains(plain.out, "ETA");
  expect_contains(plain.out, "audit passed");
  EXPECT_EQ(plain.out.find("\x1b[32m"), std::string::npos);
  const ProgramResult quiet = folder.run_on_terminal({"run", "ball.yaml", "--quiet"}, false);
  EXPECT_EQ(quiet.out, "");
}

}  // namespace
}  // namespace rigor::run_command_test
