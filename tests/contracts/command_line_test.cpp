#include "contracts/program.hpp"
#include "rigor/io/files/version.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

// What the program promises to those who call it: commands, exit codes, messages. (Runs and their files:
// run_command_test.)

namespace rigor::command_line_test {
namespace {

using Json = nlohmann::json;

/// Spheres of radius 0.5 in a row; neighbours overlap by 1 - spacing.
std::string row_of_spheres(int count, double spacing) {
  std::string text = "rigor: 1\nrun: {duration: 0.1}\nworld: {gravity: [0, 0, 0]}\nbodies:\n";
  for (int i = 0; i < count; ++i) {
    text += "  - {name: s" + std::to_string(i) + ", position: [" + std::to_string(i * spacing) +
            ", 0, 0], shapes: [{type: sphere, radius: 0.5}]}\n";
  }
  return text;
}

// Usage

TEST(CommandLine, VersionAndHelpGoToStdout) {
  const ProgramFolder folder;
  const ProgramResult told = folder.run({"--version"});
  EXPECT_EQ(told.code, 0);
  EXPECT_EQ(told.out, "rigor " + std::string(version) + "\n");
  const ProgramResult help = folder.run({"--help"});
  EXPECT_EQ(help.code, 0);
  expect_contains(help.out, "Examples:");
  for (const char* command : {"run", "check", "mass", "distance", "methods"})
    expect_contains(help.out, command);
  const ProgramResult run_help = folder.run({"run", "--help"});
  EXPECT_EQ(run_help.code, 0);
  for (const char* option :
       {"--set", "--duration", "--threads", "--json", "--quiet", "--checkpoint", "--resume", "--separate"}) {
    expect_contains(run_help.out, option);
  }
}

TEST(CommandLine, WithoutACommandThereIsHelpOnStderrAndTwo) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run({});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  expect_contains(result.error, "Examples:");
}

TEST(CommandLine, UnknownNamesAreToldWithTheNearest) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult option = folder.run({"run", "--duratoin", "1", "ball.yaml"});
  EXPECT_EQ(option.code, 2);
  EXPECT_EQ(option.error, "error: unknown option '--duratoin'; did you mean '--duration'?\n");
  const ProgramResult command = folder.run({"rnu", "ball.yaml"});
  EXPECT_EQ(command.code, 2);
  EXPECT_EQ(command.error, "error: unknown command 'rnu'; did you mean 'run'?\n");
  const ProgramResult extra = folder.run({"run", "ball.yaml", "other.yaml"});
  EXPECT_EQ(extra.code, 2);
  expect_contains(extra.error, "unexpected argument 'other.yaml'");
  EXPECT_EQ(folder.run({"run", "--quiet=", "ball.yaml", "--qiuet"}).code, 2);
}

TEST(CommandLine, ValuesThatMakeNoSenseAreUsageErrors) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const std::vector<std::vector<std::string>> wrong = {
      {"run"},
      {"run", "ball.yaml", "--duration"},
      {"run", "ball.yaml", "--duration", "-1"},
      {"run", "ball.yaml", "--duration", "nan"},
      {"run", "ball.yaml", "--duration", "1e999"},
      {"run", "ball.yaml", "--duration", "1s"},
      {"run", "ball.yaml", "--threads", "0"},
      {"run", "ball.yaml", "--checkpoint-every", "1"},
      {"run", "ball.yaml", "--separate", "--resume", "a.cp"},
      {"run", "ball.yaml", "-o", "a.json", "--json", "a.json"},
      {"mass", "ball.yaml", "--density", "0"},
      {"mass", "ball.yaml", "--samples", "1"},
      {"distance", "ball.yaml", "ball"},
      {"distance", "ball.yaml", "ball", "ball"},
      {"distance", "ball.yaml", "ball", "flor"},
      {"distance", "ball.yaml", "--ray", "0,0,1"},
      {"distance", "ball.yaml", "--ray", "0,0,1 0,0,0"},
      {"distance", "ball.yaml", "--ray", "0,0,1 0,0,x"},
      {"distance", "ball.yaml", "--ray", "0,0,1 0,0,nan"},
      {"distance", "ball.yaml", "--ray", "0,0,1 0,0,1", "--point", "0,0,0"},
      {"distance", "ball.yaml", "ball", "--ray", "0,0,1 0,0,1"},
      {"distance", "ball.yaml", "ball", "floor", "--closest", "1"},
      {"distance", "ball.yaml", "--closest", "1"},
      {"distance", "ball.yaml", "--point", "0,0,0", "--closest", "0"},
      {"distance", "ball.yaml", "--push", "0,0,1"},
      {"distance", "ball.yaml", "ball", "--push", "0,0,0"},
      {"distance", "ball.yaml", "--point", "0,0,0", "--tolerance", "1"},
      {"check"},
  };
  for (const std::vector<std::string>& arguments : wrong) {
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 2) << testing::PrintToString(arguments) << result.error;
    EXPECT_EQ(result.error.rfind("error: ", 0), 0u) << result.error;
    EXPECT_EQ(line_count(result.error), 1u) << result.error;
  }
  expect_contains(folder.run({"distance", "ball.yaml", "ball", "flor"}).error, "did you mean 'floor'?");
}

TEST(CommandLine, OutputsOfUnknownFormatsAreRefusedWithTheAvailableOnes) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  for (const std::string name : {"run.urdf", "solid.stl"}) {
    const ProgramResult result = folder.run({"run", "ball.yaml", "-o", name});
    EXPECT_EQ(result.code, 2);
    expect_contains(result.error,
                    "is no format that Rigor writes; available: .csv .h5 .json .html .png .mp4");
    EXPECT_FALSE(folder.has(name));
  }
}

TEST(CommandLine, FilesThatAreNoScenesAreToldAsWhatTheyAre) {
  const ProgramFolder folder;
  for (const auto& [name, told] :
       {std::pair{"run.urdf", "run.urdf: .urdf is no format that Rigor reads; scenes are .yaml or .json"},
        {"arm.XML", "arm.XML: .xml is no format that Rigor reads"},
        {"run.h5", "run.h5: .h5 is a stored motion, no scene: 'rigor view'"},
        {"part.stl", "part.stl: .stl is a mesh, no scene: 'rigor convert'"}}) {
    folder.write(name, "<robot name=\"a\"/>\n");
    const ProgramResult result = folder.run({"run", name});
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(line_count(result.error), 1u) << result.error;
    expect_contains(result.error, told);
  }
  // A file that is not there is told as that, whatever its name.
  expect_contains(folder.run({"run", "none.urdf"}).error, "there is no such file");
}

TEST(CommandLine, TheSceneIsNeverOverwritten) {
  const ProgramFolder folder;
  folder.write("scene.json", ball_scene);
  EXPECT_EQ(folder.run({"run", "scene.json", "-o", "./scene.json"}).code, 2);
  EXPECT_EQ(folder.run({"run", "scene.json", "--json", "scene.json"}).code, 2);
  EXPECT_EQ(folder.read("scene.json"), ball_scene);
}

TEST(CommandLine, AFileNamedTwiceIsRefusedHoweverItIsSpelt) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  for (const std::string again : {"a.csv", "./a.csv"}) {
    const ProgramResult result = folder.run({"run", "ball.yaml", "-o", "a.csv", "-o", again});
    EXPECT_EQ(result.code, 2);
    expect_contains(result.error, "is given twice");
  }
  EXPECT_FALSE(folder.has("a.csv"));
}

// Scenes

TEST(CommandLine, BadScenesAreThreeWithTheirPlaces) {
  const ProgramFolder folder;
  folder.write("bad.yaml", "rigor: 1\nbodeis: []\nworld: {gravity: 9.81}\n");
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = folder.run({command, "bad.yaml"});
    EXPECT_EQ(result.code, 3);
    expect_contains(result.error, "error: bad.yaml:2:1: unknown key 'bodeis'");
    expect_contains(result.error, "did you mean 'bodies'?");
    expect_contains(result.error, "bad.yaml:3:");
  }
  const ProgramResult missing = folder.run({"run", "missing.yaml"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_EQ(missing.error, "error: missing.yaml: there is no such file\n");
  const ProgramResult directory = folder.run({"run", "."});
  EXPECT_EQ(directory.code, 3);
  EXPECT_EQ(line_count(directory.error), 1u);
}

TEST(CommandLine, OverridesAreCheckedLikeTheScene) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  EXPECT_EQ(folder.run({"run", "ball.yaml", "--set", "materials.rubber.restitution=2"}).code, 3);
  const ProgramResult result =
      folder.run({"run", "ball.yaml", "--set", "materials.rubber.restitution=0", "--json", "-"});
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(Json::parse(result.out)["events"]["resting"], 1) << result.out;
}

TEST(CommandLine, OverlapsAreThreeWithNamesAndDepth) {
  const ProgramFolder folder;
  folder.write("two.yaml", row_of_spheres(2, 0.75));
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = folder.run({command, "two.yaml"});
    EXPECT_EQ(result.code, 3);
    expect_contains(result.error, "two.yaml: bodies 's0' and 's1' overlap by 0.25 m at t = 0");
    expect_contains(result.error, "--separate");
  }
  folder.write("many.yaml", row_of_spheres(15, 0.75));
  expect_contains(folder.run({"run", "many.yaml"}).error, "and 4 more pairs overlap");
}

TEST(CommandLine, SeparatePushesOverlappingBodiesApartAndSaysSo) {
  const ProgramFolder folder;
  folder.write("two.yaml", row_of_spheres(2, 0.75));
  const ProgramResult result = folder.run({"run", "two.yaml", "--separate", "--json", "-"});
  EXPECT_EQ(result.code, 0) << result.error;
  const Json audit = Json::parse(result.out);
  expect_contains(audit["warnings"].dump(), "2 were pushed apart");
  const double distance =
      audit["bodies"]["s1"]["position"][0].get<double>() - audit["bodies"]["s0"]["position"][0].get<double>();
  EXPECT_NEAR(distance, 1, 2e-6);
}

TEST(CommandLine, CheckTellsOfEveryFile) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  folder.write("bad.yaml", "rigor: 1\nbodeis: []\n");
  const ProgramResult good = folder.run({"check", "ball.yaml"});
  EXPECT_EQ(good.code, 0);
  EXPECT_EQ(
      good.out.rfind(
          "ball.yaml: ok: 2 bodies (1 dynamic, 0 kinematic, 1 static), 2 shapes, 0 joints, 0 forces", 0),
      0u)
      << good.out;
  const ProgramResult both = folder.run({"check", "bad.yaml", "ball.yaml", "missing.yaml"});
  EXPECT_EQ(both.code, 3);
  expect_contains(both.out, "ball.yaml: ok:");
  expect_contains(both.error, "bad.yaml:2:1:");
  expect_contains(both.error, "missing.yaml: there is no such file");
}

// Questions about bodies

TEST(CommandLine, MassIsExactAndSampledSideBySide) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult result =
      folder.run({"mass", "ball.yaml", "--density", "500", "--samples", "20000", "--json", "-"});
  ASSERT_EQ(result.code, 0) << result.error;
  const Json solid = Json::parse(result.out)["solids"][0];
  const double volume = 4.0 / 3 * 3.14159265358979323846 * 1e-3;
  EXPECT_NEAR(solid["volume"].get<double>(), volume, 1e-15 * volume);
  EXPECT_NEAR(solid["exact"]["mass"].get<double>(), 500 * volume, 1e-12);
  // Six deviations: one in a billion.
  const double deviation = solid["sampled"]["deviation"]["volume"].get<double>();
  EXPECT_GT(deviation, 0);
  EXPECT_NEAR(solid["sampled"]["volume"].get<double>(), volume, 6 * deviation);
  EXPECT_EQ(solid["simulated"]["mass"], 1.0);
  const ProgramResult text = folder.run({"mass", "ball.yaml", "--samples", "20000"});
  for (const char* part : {"volume [m³]", "inertia xx", "principal moments", "dev", "as simulated"})
    expect_contains(text.out, part);
}

TEST(CommandLine, MassReadsMeshesAndRefusesOpenOnes) {
  const ProgramFolder folder;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  folder.write("tetrahedron.obj", vertices + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  folder.write("open.obj", vertices + "f 1 3 2\nf 1 2 4\nf 2 3 4\n");
  const ProgramResult closed = folder.run({"mass", "tetrahedron.obj", "--density", "6", "--json", "-"});
  ASSERT_EQ(closed.code, 0) << closed.error;
  const Json solid = Json::parse(closed.out)["solids"][0];
  // Volume 1/6, centre at the mean of the corners.
  EXPECT_NEAR(solid["exact"]["mass"].get<double>(), 1, 1e-15);
  EXPECT_NEAR(solid["exact"]["center"][0].get<double>(), 0.25, 1e-15);
  const ProgramResult open = folder.run({"mass", "open.obj"});
  EXPECT_EQ(open.code, 3);
  expect_contains(open.error, "open.obj");
  EXPECT_EQ(folder.run({"mass", "missing.stl"}).code, 3);
}

TEST(CommandLine, DistanceTellsBoundsWitnessesAndContacts) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult apart = folder.run({"distance", "ball.yaml", "floor", "ball", "--json", "-"});
  ASSERT_EQ(apart.code, 0) << apart.error;
  const Json json = Json::parse(apart.out);
  // The ball's centre is 1 m above the floor, its radius 0.1 m.
  EXPECT_NEAR(json["distance"].get<double>(), 0.9, 1e-15);
  EXPECT_LE(json["lower"].get<double>(), 0.9);
  EXPECT_GE(json["upper"].get<double>(), 0.9 - 1e-15);
  EXPECT_EQ(json["normal"], (Json{0.0, 0.0, 1.0}));
  EXPECT_EQ(json["contacts"].size(), 0u);
  const ProgramResult near = folder.run({"distance", "ball.yaml", "floor", "ball", "--tolerance", "1"});
  EXPECT_EQ(near.code, 0);
  expect_contains(near.out, "contacts    1 closer than 1 m");
  folder.write(
      "none.yaml",
      "rigor: 1\nbodies: [{name: a, inertia: {mass: 1, moments: [1, 1, 1]}}, {name: b, position: [1, 0, 0], "
      "inertia: {mass: 1, moments: [1, 1, 1]}}]\n");
  EXPECT_EQ(folder.run({"distance", "none.yaml", "a", "b"}).code, 3);
}

TEST(CommandLine, DistanceAnswersQuestionsAboutTheScene) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const auto answer = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"distance", "ball.yaml"});
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 0) << result.error;
    return Json::parse(result.out);
  };
  // The ball's centre is 1 m above the floor, its radius 0.1 m: a ray from 3 m goes in, out, and into the
  // floor.
  const Json ray = answer({"--ray", "0,0,3 0,0,-2"});
  ASSERT_EQ(ray["hits"].size(), 3u);
  EXPECT_NEAR(ray["hits"][0]["distance"].get<double>(), 1.9, 1e-15);
  EXPECT_NEAR(ray["hits"][1]["fraction"].get<double>(), 1.05, 1e-15);
  EXPECT_EQ(ray["hits"][1]["enters"], false);
  EXPECT_EQ(ray["hits"][2]["body"], "floor");
  const Json point = answer({"--point", "0.4,0,1", "--closest", "5"});
  ASSERT_EQ(point["closest"].size(), 2u);
  EXPECT_NEAR(point["closest"][0]["distance"].get<double>(), 0.3, 1e-15);
  EXPECT_EQ(point["closest"][1]["body"], "floor");
  EXPECT_TRUE(point["inside"].empty());
  EXPECT_EQ(answer({"--point", "0,0,-1"})["inside"], (Json{"floor"}));
  const Json closest = answer({"floor", "--closest", "1"});
  EXPECT_EQ(closest["closest"][0]["body"], "ball");
  EXPECT_NEAR(closest["closest"][0]["distance"].get<double>(), 0.9, 1e-15);
  const Json push = answer({"ball", "--push", "5,0,-2"});
  EXPECT_NEAR(push["meets"]["fraction"].get<double>(), 0.45, 2e-12);
  EXPECT_EQ(push["meets"]["body"], "floor");
  EXPECT_TRUE(answer({"ball", "--push", "5,0,2"})["meets"].is_null());
  expect_contains(folder.run({"distance", "ball.yaml", "--ray", "0,0,3 0,0,-2"}).out, "into ball.shapes[0]");
  const ProgramResult near = folder.run({"distance", "ball.yaml", "floor", "ball", "--tolerance", "1"});
  expect_contains(near.out, "face 0 on side 0");
}

TEST(CommandLine, MethodsListsEveryChoiceWithItsSource) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run({"methods"});
  EXPECT_EQ(result.code, 0);
  for (const char* part :
       {"event-driven", "stronge", "later", "default", "Baraff", "contact_tolerance", "PQP"}) {
    expect_contains(result.out, part);
  }
}

TEST(CommandLine, MethodsFindsEveryWordOfTheCourses) {
  const ProgramFolder folder;
  // Rows "| name, name | what stands for it | ... |" of the table of the docs.
  std::istringstream page(text_of(RIGOR_SOURCE_DIR "/docs/methods.md"));
  std::string line;
  while (std::getline(page, line) && line != "## The course's words") continue;
  int count = 0;
  while (std::getline(page, line) && !line.starts_with("## ")) {
    if (!line.starts_with("| ") || line.starts_with("| word")) continue;
    const std::size_t end = line.find(" | "), next = line.find(" | ", end + 3);
    std::istringstream names(line.substr(2, end - 2));
    for (std::string name; std::getline(names, name, ','); ++count) {
      const ProgramResult result = folder.run({"methods", name});
      EXPECT_EQ(result.code, 0) << name;
      expect_contains(result.out, line.substr(end + 3, next - end - 3));
    }
  }
  EXPECT_GE(count, 100);
  const ProgramResult choice = folder.run({"methods", "Dormand"});
  expect_contains(choice.out, "dopri5");
  EXPECT_EQ(choice.out.find("gjk"), std::string::npos);
  expect_contains(folder.run({"methods", "contact", "region"}).out, "each with its normal and gap");
}

TEST(CommandLine, MethodsTellsTheNearestOfAMisspeltWord) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run({"methods", "projecton", "on", "velocites"});
  EXPECT_EQ(result.code, 2);
  expect_contains(result.error, "did you mean 'projection on velocities'?");
  EXPECT_EQ(result.out, "");
  const ProgramResult nothing = folder.run({"methods", "zzzzzzzzzz"});
  EXPECT_EQ(nothing.code, 2);
  expect_contains(nothing.error, "'rigor methods' lists all");
}

}  // namespace
}  // namespace rigor::command_line_test
