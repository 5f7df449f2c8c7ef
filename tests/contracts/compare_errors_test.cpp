#include "contracts/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

// What `rigor compare` promises about errors, references, refused runs and work-precision data.

namespace rigor::compare_errors_test {
namespace {

using Json = nlohmann::json;

/// x'' = -100 (x - 1/2) from x = 0.8: x = 0.5 + 0.3 cos 10 t.
const std::string spring = R"(rigor: 1
name: spring
run: {duration: 0.5, step: 0.01, output_interval: 0.02}
world: {gravity: [0, 0, 0]}
bodies: [{name: a, position: [0.8, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}]
forces: [{type: spring, between: [world, a], points: [[0, 0, 0], [0, 0, 0]], stiffness: 100, damping: 0, length: 0.5}]
)";

struct ErrorFolder : ProgramFolder {
  ErrorFolder() {
    write("ball.yaml", ball_scene);
    write("spring.yaml", spring);
  }
  ProgramResult compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run(arguments);
  }
  /// The JSON of a comparison.
  Json table(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"-o", "table.json", "--quiet"});
    compare(arguments);
    return Json::parse(read("table.json"));
  }
};

double error_of(const Json& run) {
  return run["error"]["position"]["value"];
}

TEST(CompareErrors, AreAgainstAConvergedRunAndOfTheOrderOfEachMethod) {
  const ErrorFolder folder;
  const Json table = folder.table({"spring.yaml", "--vary", "method.integrator=euler,midpoint,rk4", "--vary",
                                   "run.step=0.02,0.01,0.005,0.0025"});
  ASSERT_EQ(table["references"].size(), 1u);
  const Json reference = table["references"][0];
  EXPECT_EQ(reference["is_run"], true);
  EXPECT_EQ(reference["end"], "ok");
  EXPECT_EQ(reference["name"], "event-driven, integrator exact, step 0.005 s, tolerance 1e-12");
  EXPECT_LT(reference["own_error"]["position"]["value"], 1e-8);
  const Json& runs = table["runs"];
  ASSERT_EQ(runs.size(), 12u);
  const double orders[] = {1, 2, 4};
  for (std::size_t method = 0; method < 3; ++method) {
    EXPECT_EQ(runs[4 * method]["order"], nullptr);
    // The next power of the step adds to the last error a part of about 10 h = 0.025 or 0.05.
    EXPECT_NEAR(runs[4 * method + 3]["order"].get<double>(), orders[method], 0.25) << runs[4 * method + 3];
    for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(error_of(runs[4 * method + i]), error_of(runs[4 * method]));
  }
  EXPECT_EQ(runs[0]["step"], 0.02);
  EXPECT_EQ(runs[0]["cpu_ratio"], 1);
}

TEST(CompareErrors, AreAgainstThePlacesThatTheSceneExpects) {
  const ErrorFolder folder;
  const double x = 0.5 + 0.3 * std::cos(5.0);
  folder.write("known.yaml",
               spring + "expect: [{body: a, time: 0.5, position: [" + std::to_string(x) + ", 0, 0]}]\n");
  const Json table =
      folder.table({"known.yaml", "--vary", "method.integrator=midpoint,dopri5", "--json", "whole.json"});
  ASSERT_EQ(table["references"].size(), 1u);
  EXPECT_EQ(table["references"][0]["is_run"], false);
  const Json whole = Json::parse(folder.read("whole.json"));
  for (std::size_t i = 0; i < 2; ++i) {
    const double end = whole["runs"][i]["audit"]["bodies"]["a"]["position"][0];
    EXPECT_NEAR(error_of(table["runs"][i]), std::abs(end - std::stod(std::to_string(x))), 1e-15);
    EXPECT_EQ(table["runs"][i]["error"]["position"]["time"], 0.5);
  }
  // std::to_string keeps six decimals.
  EXPECT_LT(error_of(table["runs"][1]), 1e-6);
  EXPECT_GT(error_of(table["runs"][0]), 1e-3);
  // Other mass: what the scene expects does not hold.
  const Json other =
      folder.table({"known.yaml", "--vary", "method.integrator=midpoint,dopri5", "--set", "bodies.a.mass=2"});
  EXPECT_EQ(other["references"][0]["is_run"], true);
  EXPECT_LT(error_of(other["runs"][1]), 1e-7);
}

TEST(CompareErrors, EachSceneWithOtherForcesHasAReferenceOfItsOwn) {
  const ErrorFolder folder;
  const Json table = folder.table(
      {"spring.yaml", "--vary", "bodies.a.mass=1,2", "--vary", "method.integrator=midpoint,dopri5"});
  ASSERT_EQ(table["references"].size(), 2u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(table["runs"][i]["reference"], i / 2);
  EXPECT_LT(error_of(table["runs"][1]), 1e-7);
  EXPECT_LT(error_of(table["runs"][3]), 1e-7);
}

TEST(CompareErrors, TheReferenceMayBeChosenOrLeftOut) {
  const ErrorFolder folder;
  const Json chosen = folder.table({"spring.yaml", "--vary", "method.integrator=midpoint,rk4", "--reference",
                                    "method.integrator=midpoint", "--bound", "1"});
  EXPECT_EQ(chosen["references"][0]["name"], "auto, integrator midpoint, step 0.01 s, tolerance 1e-10");
  EXPECT_EQ(error_of(chosen["runs"][0]), 0);
  EXPECT_GT(error_of(chosen["runs"][1]), 1e-3);
  // With twice the step midpoint is three times as wrong again as it is: its estimate is of that size.
  const double own = chosen["references"][0]["own_error"]["position"]["value"];
  EXPECT_NEAR(own / error_of(chosen["runs"][1]), 3, 0.5);
  const Json none =
      folder.table({"spring.yaml", "--vary", "method.integrator=midpoint,rk4", "--reference", "none"});
  EXPECT_EQ(none["references"], Json::array());
  EXPECT_EQ(none["runs"][0]["error"], nullptr);
  // What happens is varied, not how it is computed: there is nothing to be wrong against.
  EXPECT_EQ(folder.table({"ball.yaml", "--vary", "method.impact=newton,stronge"})["references"],
            Json::array());
}

TEST(CompareErrors, UsageOfTheReferenceIsChecked) {
  const ErrorFolder folder;
  const auto refused = [&](std::vector<std::string> references) {
    std::vector<std::string> arguments = {"ball.yaml", "--vary", "method.toi=ratio"};
    for (const std::string& reference : references)
      arguments.insert(arguments.end(), {"--reference", reference});
    return folder.compare(arguments);
  };
  EXPECT_EQ(refused({"exact"}).code, 2);
  expect_contains(refused({"exact"}).error, "--reference 'exact': must be KEY=VALUE or none");
  EXPECT_EQ(refused({"none", "run.step=1"}).code, 2);
  EXPECT_EQ(refused({"method.toi=rato"}).code, 3);
  expect_contains(refused({"method.toi=rato"}).error, "did you mean 'ratio'?");
}

TEST(CompareErrors, TheTableTellsThemAndUntilWhenTheMotionIsGood) {
  const ErrorFolder folder;
  // Euler's method feeds the oscillator: it is soon off by more than the bound.
  const ProgramResult result =
      folder.compare({"spring.yaml", "--vary", "method.integrator=dopri5,euler", "--bound", "0.05"});
  for (const char* part : {"error", "angle", "good", "until [s]", "rise of", "CPU", "ratio", "0.5 (end)",
                           "runs 1 to 2: errors against a run of its own: event-driven, "})
    expect_contains(result.out, part);
  const Json table =
      folder.table({"spring.yaml", "--vary", "method.integrator=dopri5,euler", "--bound", "0.05"});
  EXPECT_EQ(table["runs"][0]["error"]["is_good_throughout"], true);
  const Json euler = table["runs"][1]["error"];
  EXPECT_EQ(euler["is_good_throughout"], false);
  EXPECT_LT(euler["good_until"], 0.5);
  // Each step of h = 0.01 multiplies the amplitude by √(1 + (10 h)²): the error is about 0.3 (exp(t/2) - 1)
  // |cos 10 t|, 0.0475 at 0.3 s and 0.0517 at 0.32 s.
  EXPECT_DOUBLE_EQ(euler["good_until"].get<double>(), 0.3);
}

TEST(CompareErrors, AMotionThatTheReferenceDoesNotKnowIsNotMeasured) {
  const ErrorFolder folder;
  // The reference of Euler's method is itself not good for long.
  const Json table = folder.table({"spring.yaml", "--vary", "method.integrator=dopri5,euler", "--bound",
                                   "0.05", "--reference", "method.integrator=euler"});
  const Json own = table["references"][0]["own_error"];
  EXPECT_EQ(own["is_good_throughout"], false);
  const double horizon = own["good_until"];
  EXPECT_LT(horizon, 0.5);
  for (const Json& run : table["runs"]) EXPECT_EQ(run["error"]["compared_until"], horizon);
}

TEST(CompareErrors, ARunThatTheMethodRefusesIsALineOfTheTable) {
  const ErrorFolder folder;
  // The matrix goes with explicit Runge-Kutta methods alone.
  const ProgramResult result =
      folder.compare({"spring.yaml", "--set", "method.orientation=matrix", "--vary",
                      "method.integrator=lie-rk4,dopri5,rk4", "-o", "a.json", "-o", "a.csv", "-o", "a.html"});
  EXPECT_EQ(result.code, 3);
  expect_contains(result.out, "1  lie-rk4     refused");
  expect_contains(result.out, "2  dopri5      ok");
  expect_contains(result.out, "Δ: difference from run 2 at the end");
  expect_contains(result.error,
                  "error: method.integrator=lie-rk4: refused: method: orientation 'matrix' does not go");
  const Json runs = Json::parse(folder.read("a.json"))["runs"];
  EXPECT_EQ(runs[0]["end"], "refused");
  expect_contains(runs[0]["reason"].get<std::string>(), "orientation 'matrix' does not go with");
  EXPECT_EQ(runs[0]["error"], nullptr);
  EXPECT_EQ(runs[0]["cpu_ratio"], nullptr);
  EXPECT_EQ(runs[1]["cpu_ratio"], 1);
  EXPECT_EQ(runs[1]["difference"], nullptr);
  EXPECT_NE(runs[2]["difference"], nullptr);
  const std::string page = folder.read("a.html");
  EXPECT_EQ(page.find("data-run=\"2\""), std::string::npos);
  // Where every run is refused, and where a name is wrong, it is a mistake.
  EXPECT_EQ(folder
                .compare({"spring.yaml", "--set", "method.orientation=matrix", "--vary",
                          "method.integrator=lie-rk4,exact"})
                .code,
            3);
  const ProgramResult misspelt = folder.compare({"spring.yaml", "--vary", "method.integrator=dopri5,rk5"});
  EXPECT_EQ(misspelt.code, 3);
  EXPECT_EQ(misspelt.out, "");
}

TEST(CompareErrors, ARunThatTakesTooLongIsEndedAndTheOthersGoOn) {
  const ErrorFolder folder;
  const ProgramResult result =
      folder.compare({"ball.yaml", "--vary", "run.duration=1e6,0.5", "--cpu-limit", "0.05", "-o", "a.json"});
  EXPECT_EQ(result.code, 4);
  expect_contains(result.out, "1  1e6       out of time at ");
  const Json runs = Json::parse(folder.read("a.json"))["runs"];
  EXPECT_EQ(runs[0]["end"], "out of time");
  EXPECT_LT(runs[0]["cpu_time"], 1);
  EXPECT_GT(runs[0]["end_time"], 0);
  EXPECT_EQ(runs[1]["end"], "ok");
  // What a simulated second costs, though the runs are not of one length.
  const auto cost = [](const Json& run) {
    return run["cpu_time"].get<double>() / run["end_time"].get<double>();
  };
  EXPECT_NEAR(runs[1]["cpu_ratio"].get<double>(), cost(runs[1]) / cost(runs[0]),
              1e-9 * cost(runs[1]) / cost(runs[0]));
}

TEST(CompareErrors, WorkAndPrecisionAreInTheCsvAndOnThePage) {
  const ErrorFolder folder;
  folder.compare({"spring.yaml", "--vary", "method.integrator=midpoint", "--vary", "run.step=0.02,0.01", "-o",
                  "a.csv", "-o", "a.html", "--quiet"});
  const std::string csv = folder.read("a.csv"), page = folder.read("a.html");
  expect_contains(
      csv,
      ",cpu_time [s],step [s],error [m],error_body,error_time [s],angle_error [rad],good_until [s],"
      "reference,reference_error [m],order,cpu_ratio,relative_rise,max_joint_drift,steps,");
  expect_contains(page, "data-run=\"0\" data-kind=\"precision\"");
  folder.compare({"ball.yaml", "--vary", "method.impact=newton,stronge", "-o", "b.html", "--quiet"});
  EXPECT_EQ(folder.read("b.html").find("data-kind=\"precision\""), std::string::npos);
}

TEST(CompareErrors, ShippedScenesMeetWhatTheyExpect) {
  const ErrorFolder folder;
  const std::string scenes = std::string(RIGOR_SOURCE_DIR) + "/scenes/";
  // Numerical: to the tolerance of the integrator along the run.
  for (const char* name :
       {"bouncing_ball", "bouncing_ball_e05", "ramp_slide", "ramp_stick", "slide_to_roll", "turntable",
        "wedge", "pendulum", "double_pendulum", "slider_crank", "andrews", "four_bar", "heavy_top"}) {
    const Json table = folder.table({scenes + name + ".yaml", "--vary", "method.scheme=event-driven"});
    EXPECT_EQ(table["references"][0]["is_run"], false) << name;
    EXPECT_LT(error_of(table["runs"][0]), 1e-9) << name;
    EXPECT_LT(table["runs"][0]["error"]["angle"]["value"], 1e-9) << name;
  }
  // Its own tolerance is 1e-9, and the bars pass the line ten times.
  const Json linkages = folder.table({scenes + "n_four_bar.yaml", "--vary", "method.scheme=event-driven"});
  EXPECT_EQ(linkages["references"][0]["is_run"], false);
  EXPECT_LT(error_of(linkages["runs"][0]), 1e-6);
}

TEST(CheckCommand, TellsWhatAutoChoosesAndWhy) {
  const ErrorFolder folder;
  folder.write("auto.yaml", ball_scene + "method: {scheme: auto}\n");
  const ProgramResult result = folder.run({"check", "auto.yaml"});
  EXPECT_EQ(result.code, 0);
  expect_contains(result.out,
                  " in event-driven\n  scheme auto: event-driven, since at most 40 bodies collide: ");
  folder.run({"run", "auto.yaml", "--json", "audit.json"});
  const Json audit = Json::parse(folder.read("audit.json"));
  EXPECT_EQ(audit["method"]["scheme"], "event-driven");
  EXPECT_EQ(audit["scheme_reason"].get<std::string>().rfind("event-driven, since ", 0), 0u);
  expect_contains(folder.run({"run", "auto.yaml"}).out, "scheme: auto  event-driven, since ");
  // A scene that names no scheme is left to `auto`; one that names its scheme is not.
  expect_contains(folder.run({"check", "ball.yaml"}).out, "scheme auto: event-driven");
  folder.write("named.yaml", ball_scene + "method: {scheme: event-driven}\n");
  EXPECT_EQ(folder.run({"check", "named.yaml"}).out.find("scheme auto"), std::string::npos);
}

TEST(SceneErrors, ExpectationsNameDynamicBodiesAndExpectSomething) {
  const ErrorFolder folder;
  folder.write("who.yaml", spring + "expect: [{body: b, time: 1, position: [0, 0, 0]}]\n");
  folder.write("what.yaml", spring + "expect: [{body: a, time: 1}]\n");
  expect_contains(folder.run({"check", "who.yaml"}).error, "expectation 0: there is no dynamic body 'b'");
  expect_contains(folder.run({"check", "what.yaml"}).error,
                  "expectation 0: it expects nothing; give 'position', 'orientation' or both");
}

}  // namespace
}  // namespace rigor::compare_errors_test
