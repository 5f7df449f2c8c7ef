#include "contracts/program.hpp"
#include "rigor/io/files/version.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

// What `rigor compare` promises: tables, files, exit codes, messages.

namespace rigor::compare_command_test {
namespace {

using Json = nlohmann::json;

/// An oscillator that explicit Euler feeds with energy.
const std::string spring = R"(rigor: 1
name: spring
run: {duration: 0.5, step: 0.01}
world: {gravity: [0, 0, 0]}
bodies: [{name: a, position: [1, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}]
forces: [{type: spring, between: [world, a], points: [[0, 0, 0], [0, 0, 0]], stiffness: 100, damping: 0, length: 0.5}]
)";

/// A piston presses a ball that lies on the floor, unless it is slow.
const std::string piston = R"(rigor: 1
name: piston
method: {scheme: event-driven}
run: {duration: 2, output_interval: 0.01}
world: {gravity: [0, 0, 0]}
materials: [{name: m, restitution: 0, friction: 0}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: m}]}
  - {name: ball, position: [0, 0, 0.5], mass: 1, velocity: [0, 0, -1], shapes: [{type: sphere, radius: 0.1, material: m}]}
  - {name: piston, motion: kinematic, position: [0, 0, 2], velocity: [0, 0, -1], shapes: [{type: box, size: [1, 1, 1], material: m}]}
)";

/// The folder with the scenes in it.
struct CompareFolder : ProgramFolder {
  CompareFolder() {
    write("ball.yaml", ball_scene);
    write("spring.yaml", spring);
    write("piston.yaml", piston);
  }
  ProgramResult compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run(arguments);
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The line that begins so, or nothing.
std::string line_with(const std::string& text, const std::string& begin) {
  for (const std::string& line : lines_of(text)) {
    if (line.rfind(begin, 0) == 0) return line;
  }
  return "";
}

/// Processor time of a running program [s]: fields 14 and 15 of its status; the second is its name in
/// parentheses.
double processor_time(pid_t child) {
  std::ifstream file("/proc/" + std::to_string(child) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string field;
  for (int i = 3; i < 14; ++i) fields >> field;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

// Tables

TEST(CompareCommand, ATableOfTheRunsGoesToStdoutAndNothingElse) {
  const CompareFolder folder;
  const ProgramResult result =
      folder.compare({"ball.yaml", "--vary", "method.toi=conservative, ratio,bisection"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.out.rfind("ball: 3 runs", 0), 0u) << result.out;
  const std::vector<std::string> starts = {"1  conservative  ok", "2  ratio         ok",
                                           "3  bisection     ok"};
  for (const std::string& start : starts) EXPECT_NE(line_with(result.out, start), "") << result.out;
  for (const char* part : {"impacts", "dissipated", "unexplained", "penetration", "CPU time", "reference"})
    expect_contains(result.out, part);
  // But for the sentence that says what `auto` chose.
  for (const std::string& line : lines_of(result.out)) {
    if (line.find(": scheme auto: ") == std::string::npos) {
      EXPECT_LE(line.size(), 102u) << line;
    }
  }
  EXPECT_EQ(result.out.find('\x1b'), std::string::npos);
  EXPECT_EQ(folder.compare({"ball.yaml", "--vary", "method.toi=ratio", "--quiet"}).out, "");
}

TEST(CompareCommand, TheNumbersAreThoseOfTheRunsAlone) {
  const CompareFolder folder;
  folder.run({"run", "ball.yaml", "--json", "one.json", "--quiet"});
  folder.run(
      {"run", "ball.yaml", "--set", "materials.rubber.restitution=0.5", "--json", "two.json", "--quiet"});
  const ProgramResult result = folder.compare({"ball.yaml", "--vary", "materials.rubber.restitution=0.8,0.5",
                                               "--json", "-", "-o", "table.json", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.error;
  const Json whole = Json::parse(result.out), table = Json::parse(folder.read("table.json"));
  EXPECT_EQ(whole["rigor"], version);
  EXPECT_EQ(whole["scene"], "ball");
  EXPECT_EQ(whole["varied"], Json::array({"materials.rubber.restitution"}));
  EXPECT_EQ(whole["not_run"], Json::array());
  const Json alone[] = {Json::parse(folder.read("one.json")), Json::parse(folder.read("two.json"))};
  for (std::size_t i = 0; i < 2; ++i) {
    Json run = whole["runs"][i], audit = run["audit"], same = alone[i];
    EXPECT_EQ(run["label"], i == 0 ? "materials.rubber.restitution=0.8" : "materials.rubber.restitution=0.5");
    EXPECT_EQ(run["values"]["materials.rubber.restitution"], i == 0 ? "0.8" : "0.5");
    EXPECT_EQ(run["end"], "ok");
    EXPECT_EQ(run["reason"], nullptr);
    EXPECT_EQ(run["end_time"], 1);
    EXPECT_EQ(run["impacts"], same["events"]["impacts"]);
    EXPECT_EQ(run["resting"], same["events"]["resting"]);
    EXPECT_EQ(run["dissipated"], same["energy"]["dissipated"]);
    EXPECT_EQ(run["max_increase"], same["energy"]["max_increase"]);
    EXPECT_EQ(run["max_penetration"], same["penetration"]["max"]);
    EXPECT_GT(run["cpu_time"], 0);
    audit.erase("wall_time"), same.erase("wall_time");
    EXPECT_EQ(audit, same);
    run.erase("audit");
    EXPECT_EQ(run, table["runs"][i]);
  }
  // The differences are those of the ends.
  const auto ball_of = [&](std::size_t i, const char* key) { return alone[i]["bodies"]["ball"][key]; };
  const auto distance = [&](const char* key) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
      sum += std::pow(ball_of(0, key)[c].get<double>() - ball_of(1, key)[c].get<double>(), 2);
    return std::sqrt(sum);
  };
  EXPECT_EQ(whole["runs"][0]["difference"], nullptr);
  const Json difference = whole["runs"][1]["difference"];
  EXPECT_EQ(difference["time"], 1);
  // Two ways to add three squares.
  EXPECT_NEAR(difference["position"]["value"].get<double>(), distance("position"), 1e-15);
  EXPECT_NEAR(difference["velocity"]["value"].get<double>(), distance("velocity"), 1e-14);
  EXPECT_EQ(difference["position"]["body"], "ball");
  EXPECT_GT(distance("position"), 0.01);
}

TEST(CompareCommand, TheEnergyThatAnImpactAddsIsTold) {
  const CompareFolder folder;
  // A slanted rod that slips towards its lower end: Newton's law with friction gains energy, without friction
  // it does not.
  folder.write(
      "rod.yaml",
      "rigor: 1\nname: rod\nworld: {gravity: [0, 0, 0]}\nrun: {duration: 0.4}\nmethod: {impact: newton}\n"
      "materials: [{name: m, restitution: 0.9, friction: 0}]\nbodies:\n"
      "  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: "
      "m}]}\n"
      "  - {name: rod, position: [0, 0, 1], axis_angle: {axis: [0, 1, 0], angle: 30 deg}, velocity: [3, 0, "
      "-3], "
      "mass: 1, shapes: [{type: capsule, radius: 0.02, length: 1, material: m}]}\n");
  const ProgramResult result =
      folder.compare({"rod.yaml", "--vary", "materials.m.friction=0,0.8", "--json", "a.json"});
  EXPECT_EQ(result.code, 1);
  expect_contains(result.out, "materials.m.friction=0.8: warning: impacts added ");
  const Json runs = Json::parse(folder.read("a.json"))["runs"];
  EXPECT_EQ(runs[0]["impact_gain"], 0);
  // Nothing but the one impact changes the energy.
  const Json run = runs[1], energy = run["audit"]["energy"];
  EXPECT_EQ(run["impacts"], 1);
  const double gain = energy["final"].get<double>() - energy["initial"].get<double>();
  EXPECT_GT(gain, 0.1);
  // Energies of about 10 J, each a sum of rounded squares.
  EXPECT_NEAR(run["impact_gain"].get<double>(), gain, 1e-13);
}

TEST(CompareCommand, SeveralKeysGiveAllCombinationsTheLastFastest) {
  const CompareFolder folder;
  const ProgramResult result =
      folder.compare({"ball.yaml", "--vary", "method.toi=ratio,bisection", "--vary",
                      "bodies.ball.velocity=[0, 0, 0],[1, 0, 0]", "-o", "a.json", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.error;
  std::vector<std::string> labels;
  const Json json = Json::parse(folder.read("a.json"));
  for (const Json& run : json["runs"]) labels.push_back(run["label"]);
  EXPECT_EQ(labels, (std::vector<std::string>{"method.toi=ratio, bodies.ball.velocity=[0, 0, 0]",
                                              "method.toi=ratio, bodies.ball.velocity=[1, 0, 0]",
                                              "method.toi=bisection, bodies.ball.velocity=[0, 0, 0]",
                                              "method.toi=bisection, bodies.ball.velocity=[1, 0, 0]"}));
}

TEST(CompareCommand, OneValueIsOneRunWithoutDifferences) {
  const CompareFolder folder;
  const ProgramResult result = folder.compare(
      {"ball.yaml", "--vary", "method.toi=ratio", "--set", "run.step=0.02", "--duration", "0.3"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out.rfind("ball: one run\n", 0), 0u) << result.out;
  EXPECT_EQ(result.out.find("reference"), std::string::npos);
}

TEST(CompareCommand, TheTableAsCsvHasARowARun) {
  const CompareFolder folder;
  folder.compare(
      {"ball.yaml", "--vary", "bodies.ball.velocity=[0, 0, 0],[1, 0, 0]", "-o", "a.csv", "--quiet"});
  const std::vector<std::string> lines = lines_of(folder.read("a.csv"));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(
      lines[0],
      "run,bodies.ball.velocity,end,reason,end_time [s],impacts,resting,dissipated [J],max_increase [J],"
      "impact_gain [J],max_penetration [m],cpu_time [s],step [s],error [m],error_body,error_time [s],"
      "angle_error [rad],good_until [s],reference,reference_error [m],order,cpu_ratio,relative_rise,"
      "max_joint_drift,steps,compared_at [s],position_difference "
      "[m],position_body,"
      "velocity_difference [m/s],velocity_body,orientation_difference [rad],orientation_body,"
      "angular_velocity_difference [rad/s],angular_velocity_body");
  EXPECT_EQ(lines[1].rfind("1,\"[0, 0, 0]\",ok,,1,", 0), 0u) << lines[1];
  EXPECT_TRUE(lines[1].ends_with(",,,,,,,,,")) << lines[1];
  EXPECT_EQ(lines[2].rfind("2,\"[1, 0, 0]\",ok,,1,", 0), 0u) << lines[2];
  expect_contains(lines[2], ",1,");
  expect_contains(lines[2], ",ball,");
}

TEST(CompareCommand, WarningsAreToldOnceWithTheirRuns) {
  const CompareFolder folder;
  const ProgramResult result =
      folder.compare({"spring.yaml", "--vary", "method.integrator=dopri5,euler", "--vary", "run.seed=1,2"});
  EXPECT_EQ(result.code, 1);
  // The seed changes nothing: both runs of Euler's method break the tolerance in the same way.
  expect_contains(result.out,
                  "  method.integrator=euler, run.seed=1; method.integrator=euler, run.seed=2: violated: "
                  "unexplained rise of energy is ");
  const std::size_t first = result.out.find("unexplained rise of energy");
  EXPECT_EQ(result.out.find("unexplained rise of energy", first + 1), std::string::npos);
}

// Ends

TEST(CompareCommand, TheWorstRunGivesTheExitCode) {
  const CompareFolder folder;
  EXPECT_EQ(folder.compare({"spring.yaml", "--vary", "method.integrator=dopri5,euler"}).code, 1);
  const ProgramResult stopped =
      folder.compare({"piston.yaml", "--vary", "bodies.piston.velocity=[0, 0, -1],[0, 0, -0.1]"});
  EXPECT_EQ(stopped.code, 4);
  expect_contains(stopped.out, "1  [0, 0, -1]      stopped: ");
  expect_contains(stopped.out, "2  [0, 0, -0.1]    ok");
  expect_contains(stopped.error,
                  "error: bodies.piston.velocity=[0, 0, -1]: the simulation stopped at t = 1.");
  expect_contains(stopped.error, "what to try: ");
  // A spring that is fed with energy beside the ball under the piston: both kinds of failure.
  folder.write("both.yaml",
               piston +
                   "forces: [{type: spring, between: [world, ball], points: [[0, 0, 0.6], [0, 0, "
                   "0]], stiffness: 100, damping: 0, length: 0}]\n");
  const ProgramResult both =
      folder.compare({"both.yaml", "--vary", "bodies.piston.velocity=[0, 0, 0],[0, 0, -1]", "--set",
                      "method.integrator=euler"});
  expect_contains(both.out, "audit failed");
  expect_contains(both.out, "stopped: ");
  EXPECT_EQ(both.code, 4) << both.out;
}

TEST(CompareCommand, ARunThatStoppedIsComparedWhereBothHaveAnOutputTime) {
  const CompareFolder folder;
  for (const char* values : {"[0, 0, -1],[0, 0, -0.1]", "[0, 0, -0.1],[0, 0, -1]"}) {
    const ProgramResult result = folder.compare(
        {"piston.yaml", "--vary", std::string("bodies.piston.velocity=") + values, "-o", "a.json"});
    const Json runs = Json::parse(folder.read("a.json"))["runs"];
    const double stop = std::min(runs[0]["end_time"].get<double>(), runs[1]["end_time"].get<double>());
    const double time = runs[1]["difference"]["time"];
    // Output times carry a rounding.
    EXPECT_LE(time, stop * (1 + 1e-14));
    EXPECT_GT(time, stop - 0.0101);
    EXPECT_LT(stop, 1.9);
    expect_contains(result.out, "compared with run 1 at t = 1.");
  }
}

TEST(CompareCommand, AnInterruptPrintsWhatIsDoneAndIs130) {
  const CompareFolder folder;
  const pid_t child = folder.start({"compare", "ball.yaml", "--vary", "run.duration=0.5,1e6,1", "-o",
                                    "a.json", "-o", "a.html", "-o", "a.svg"});
  // The first run takes milliseconds.
  while (processor_time(child) < 0.3) ::usleep(1000);
  ::kill(child, SIGINT);
  const ProgramResult result = folder.wait(child);
  EXPECT_EQ(result.code, 130);
  expect_contains(result.out, "1  0.5       ok");
  expect_contains(result.out, "2  1e6       interrupted");
  EXPECT_EQ(line_with(result.out, "3"), "");
  expect_contains(result.error, "interrupted in run 2 of 3 (run.duration=1e6) at t = ");
  const Json json = Json::parse(folder.read("a.json"));
  EXPECT_EQ(json["runs"][1]["end"], "interrupted");
  EXPECT_EQ(json["not_run"], Json::array({"run.duration=1"}));
  EXPECT_TRUE(folder.read("a.html").ends_with("</html>\n"));
  EXPECT_TRUE(folder.read("a.svg").ends_with("</svg>\n"));
}

// Files

TEST(CompareCommand, APageHoldsEachRunWithItsName) {
  const CompareFolder folder;
  const ProgramResult result = folder.compare(
      {"ball.yaml", "--vary", "method.toi=conservative,ratio,bisection", "-o", "a.html", "--quiet"});
  EXPECT_EQ(result.code, 0) << result.error;
  const std::string page = folder.read("a.html");
  EXPECT_EQ(page.rfind("<!doctype html>", 0), 0u);
  for (const char* run : {"0", "1", "2"}) {
    expect_contains(page, std::string("data-run=\"") + run + "\" data-kind=\"header\"");
    expect_contains(page, std::string("data-run=\"") + run + "\" data-kind=\"frames\"");
  }
  EXPECT_EQ(page.find("data-run=\"3\""), std::string::npos);
}

TEST(CompareCommand, ThePlotHasALineAndANameForEachRun) {
  const CompareFolder folder;
  folder.compare({"ball.yaml", "--vary", "materials.rubber.restitution=0.8,0.2", "-o", "a.svg", "-o", "a.png",
                  "--quiet"});
  const std::string svg = folder.read("a.svg");
  for (const char* part : {"materials.rubber.restitution=0.8", "materials.rubber.restitution=0.2",
                           "total energy [J]", "#0072b2", "#e69f00"})
    expect_contains(svg, part);
  EXPECT_EQ(folder.read("a.png").substr(1, 3), "PNG");
}

TEST(CompareCommand, FilesThatCannotBeWrittenAreFiveBeforeTheRuns) {
  const CompareFolder folder;
  for (const char* option : {"-o", "--json"}) {
    const ProgramResult result = folder.compare(
        {"ball.yaml", "--vary", "method.toi=ratio,bisection", "--duration", "1e9", option, "missing/a.json"});
    EXPECT_EQ(result.code, 5);
    EXPECT_EQ(result.error.rfind("error: cannot write 'missing/a.json'", 0), 0u) << result.error;
  }
}

TEST(CompareCommand, ADiskThatFillsUpIsFiveWithTheTable) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const CompareFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "full.html");
  const ProgramResult result = folder.compare(
      {"ball.yaml", "--vary", "method.toi=ratio,bisection", "-o", "full.html", "-o", "a.json"});
  EXPECT_EQ(result.code, 5);
  expect_contains(result.error, "No space left on device");
  expect_contains(result.out, "2  bisection  ok");
  EXPECT_EQ(Json::parse(folder.read("a.json"))["runs"].size(), 2u);
}

// Messages

TEST(CompareCommand, CommandLinesThatMakeNoSenseAreTwo) {
  const CompareFolder folder;
  std::string many = "run.seed=0";
  for (int i = 1; i < 65; ++i) many += "," + std::to_string(i);
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{}, "--vary is required"},
      {{"--vary", "method.toi"}, "--vary 'method.toi': must be KEY=a,b,c"},
      {{"--vary", "=1"}, "--vary '=1': the key is empty; must be KEY=a,b,c"},
      {{"--vary", "run.seed=1,,2"}, "--vary 'run.seed=1,,2': value 2 is empty; must be KEY=a,b,c"},
      {{"--vary", "run.seed=1, 1"}, "--vary 'run.seed=1, 1': value '1' is given twice"},
      {{"--vary", "run.seed=1,1.0"}, "--vary 'run.seed=1,1.0': values '1' and '1.0' are the same number"},
      {{"--vary", "run.seed=[1,2"}, "--vary 'run.seed=[1,2': a [ is not closed"},
      {{"--vary", many}, "--vary asks for 65 runs, must be at most 64"},
      {{"--vary", "run.seed=1", "--vary", "run.seed=2"},
       "--vary run.seed is given twice; give all its values at once"},
      {{"--vary", "run.seed=1", "--set", "run.seed=2"},
       "--set run.seed=2 has no effect beside --vary run.seed; leave one of them out"},
      {{"--vary", "run.duration=1", "--duration", "2"},
       "--duration does not go with --vary run.duration; leave one of them out"},
      {{"--vary", "run.seed=1,2,3,4,5,6,7,8,9", "-o", "a.svg"},
       "output 'a.svg' shows at most 8 runs, and these are 9; .json, .csv and .html take them all"},
      {{"--vary", "run.seed=1", "-o", "a.h5"},
       "output 'a.h5': a comparison is written to .html, .json, .csv, .svg or .png"},
      {{"--vary", "run.seed=1", "-o", "a.json", "--json", "./a.json"}, "output './a.json' is given twice"},
      {{"--vary", "run.seed=1", "--json", "ball.yaml"},
       "output 'ball.yaml' is the scene file; give it another name"},
      {{"--vary", "run.seed=1", "--vray", "run.seed=2"}, "unknown option '--vray'; did you mean '--vary'?"},
  };
  for (auto [arguments, message] : wrong) {
    arguments.insert(arguments.begin(), "ball.yaml");
    const ProgramResult result = folder.compare(arguments);
    EXPECT_EQ(result.code, 2) << testing::PrintToString(arguments);
    EXPECT_EQ(result.error, "error: " + message + "\n");
  }
  EXPECT_EQ(folder.read("ball.yaml"), ball_scene);
}

TEST(CompareCommand, AMistakeInTheLastValueIsToldBeforeTheFirstRun) {
  const CompareFolder folder;
  // So long that the test would not end if a run began.
  const ProgramResult result =
      folder.compare({"ball.yaml", "--duration", "1e9", "--vary", "method.toi=conservative,bisektion"});
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.out, "");
  expect_contains(result.error, "error: --vary method.toi=bisektion: ");
  expect_contains(result.error, "did you mean 'bisection'?");
  EXPECT_EQ(line_count(result.error), 1u);
}

TEST(CompareCommand, MistakesOfSomeRunsNameTheirValuesAndThoseOfAllDoNot) {
  const CompareFolder folder;
  // Both may not be given: told at the body, which is in the file.
  const ProgramResult one = folder.compare(
      {"ball.yaml", "--vary", "method.toi=ratio,bisection", "--vary", "bodies.ball.density=2,3"});
  EXPECT_EQ(one.code, 3);
  EXPECT_EQ(one.error,
            "error: ball.yaml:8:5: body 'ball': only one of 'mass', 'density' and 'inertia' may be given\n");
  const ProgramResult some = folder.compare(
      {"ball.yaml", "--vary", "method.toi=ratio,bisection", "--vary", "bodies.ball.position.2=1,0.05"});
  EXPECT_EQ(some.code, 3);
  expect_contains(some.error, "bodies 'floor' and 'ball' overlap by 0.05 m at t = 0");
  expect_contains(some.error, "(with method.toi=ratio, bodies.ball.position.2=0.05 and 1 more run)");
  EXPECT_EQ(folder.compare({"missing.yaml", "--vary", "run.seed=1,2"}).error,
            "error: missing.yaml: there is no such file\n");
}

TEST(CompareCommand, OverlapsCanBePushedApart) {
  const CompareFolder folder;
  const ProgramResult result =
      folder.compare({"ball.yaml", "--vary", "bodies.ball.position.2=1,0.05", "--separate"});
  EXPECT_EQ(result.code, 0) << result.error;
  expect_contains(result.out,
                  "  bodies.ball.position.2=0.05: warning: bodies overlapped at t = 0: 1 were pushed apart");
}

TEST(CompareCommand, WarningsOfTheSceneAreToldOnce) {
  const CompareFolder folder;
  folder.write("bare.yaml", ball_scene + "  - {name: bare, motion: static}\n");
  const ProgramResult result = folder.compare({"bare.yaml", "--vary", "run.seed=1,2,3", "--quiet"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.error, "warning: bare.yaml:9:5: body 'bare': it has no shapes, so it touches nothing\n");
}

// Terminals

TEST(CompareCommand, ProgressAndColoursAppearOnATerminalOnly) {
  const CompareFolder folder;
  const std::vector<std::string> arguments = {"compare", "ball.yaml", "--vary", "method.toi=ratio,bisection"};
  const ProgramResult colored = folder.run_on_terminal(arguments, false);
  EXPECT_EQ(colored.code, 0);
  for (const char* part : {"run 2 of 2 (method.toi=bisection): ", "\x1b[32mok\x1b[0m"})
    expect_contains(colored.out, part);
  const ProgramResult plain = folder.run_on_terminal(arguments, true);
  EXPECT_EQ(plain.out.find("\x1b[32m"), std::string::npos);
  expect_contains(plain.out, "2  bisection  ok");
}

TEST(CompareCommand, TheHelpShowsTheCommandWithAnExample) {
  const CompareFolder folder;
  expect_contains(folder.run({"--help"}).out, "rigor compare ball.yaml --vary method.");
  const std::string help = folder.run({"compare", "--help"}).out;
  for (const char* option : {"--vary KEY=a,b,c", "-o, --output", "--set", "--duration", "--json", "--quiet"})
    expect_contains(help, option);
  expect_contains(help, "rigor compare ball.yaml --vary method.toi=");
}

}  // namespace
}  // namespace rigor::compare_command_test
