#include "contracts/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

// What `rigor convert` promises: pieces that other commands read, the error stated, messages, exit codes.

namespace rigor::convert_command_test {
namespace {

using Json = nlohmann::json;

/// Prism of height 1 over an L of three unit squares: volume 3.
const std::string l_obj = R"(v 0 0 0
v 2 0 0
v 2 1 0
v 1 1 0
v 1 2 0
v 0 2 0
v 0 0 1
v 2 0 1
v 2 1 1
v 1 1 1
v 1 2 1
v 0 2 1
f 6 5 4 3 2 1
f 7 8 9 10 11 12
f 1 2 8 7
f 2 3 9 8
f 3 4 10 9
f 4 5 11 10
f 5 6 12 11
f 6 1 7 12
)";

/// A ball with waves on it, from triangles between meridians: far from convex everywhere.
std::string bumpy_obj(int stacks, int segments) {
  std::string text = "v 0 0 -1\nv 0 0 1\n";
  for (int k = 1; k < stacks; ++k) {
    for (int i = 0; i < segments; ++i) {
      const double u = 2 * std::numbers::pi * i / segments, v = std::numbers::pi * k / stacks;
      const double r = 1 + 0.2 * std::sin(5 * u) * std::sin(4 * v);
      text += "v " + std::to_string(r * std::sin(v) * std::cos(u)) + " " +
              std::to_string(r * std::sin(v) * std::sin(u)) + " " + std::to_string(-r * std::cos(v)) + "\n";
    }
  }
  const auto f = [&text](int a, int b, int c) {
    text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  };
  const auto vertex = [&](int k, int i) { return 3 + (k - 1) * segments + i % segments; };
  for (int i = 0; i < segments; ++i) {
    f(1, vertex(1, i + 1), vertex(1, i));
    f(2, vertex(stacks - 1, i), vertex(stacks - 1, i + 1));
    for (int k = 1; k + 1 < stacks; ++k) {
      f(vertex(k, i), vertex(k, i + 1), vertex(k + 1, i + 1));
      f(vertex(k, i), vertex(k + 1, i + 1), vertex(k + 1, i));
    }
  }
  return text;
}

TEST(ConvertCommand, AnLBecomesTwoExactPiecesThatOtherCommandsRead) {
  const ProgramFolder folder;
  folder.write("l.obj", l_obj);
  const ProgramResult result = folder.run({"convert", "l.obj", "l.yaml", "--exact", "--json", "l.json"});
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  expect_contains(result.out, "2 convex pieces");
  expect_contains(folder.read("l.yaml"), "# Error: none: the pieces are the solid, up to rounding.");
  const Json json = Json::parse(folder.read("l.json"));
  EXPECT_EQ(json["pieces"], 2);
  EXPECT_EQ(json["exact"], true);
  EXPECT_EQ(json["error"], 0);
  EXPECT_NEAR(json["pieces_volume"].get<double>(), 3, 1e-12);

  EXPECT_EQ(folder.run({"check", "l.yaml"}).code, 0);
  const ProgramResult run = folder.run({"run", "l.yaml"});
  EXPECT_EQ(run.code, 0) << run.error;
  const ProgramResult mass = folder.run({"mass", "l.yaml", "--density", "1", "--json", "-"});
  EXPECT_EQ(mass.code, 0) << mass.error;
  const ProgramResult whole = folder.run({"mass", "l.obj", "--density", "1", "--json", "-"});
  const Json of_pieces = Json::parse(mass.out)["solids"][0]["exact"];
  const Json of_mesh = Json::parse(whole.out)["solids"][0]["exact"];
  EXPECT_NEAR(of_pieces["mass"].get<double>(), 3, 1e-12);
  for (const char* key : {"mass", "center", "inertia"}) {
    const Json a = of_pieces[key].flatten(), b = of_mesh[key].flatten();
    for (auto i = a.begin(), k = b.begin(); i != a.end(); ++i, ++k) {
      EXPECT_NEAR(i->get<double>(), k->get<double>(), 1e-12) << key;
    }
  }
}

TEST(ConvertCommand, WithAToleranceTheErrorIsStatedAndWithin) {
  const ProgramFolder folder;
  folder.write("ball.obj", bumpy_obj(8, 16));
  const ProgramResult result =
      folder.run({"convert", "ball.obj", "ball.yaml", "--tolerance", "0.2", "--json", "-"});
  EXPECT_EQ(result.code, 0) << result.error;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["exact"], false);
  EXPECT_GT(json["error"].get<double>(), 0);
  EXPECT_LE(json["error"].get<double>(), 0.2);
  EXPECT_GE(json["pieces_volume"].get<double>(), json["volume"].get<double>());
  EXPECT_EQ(json["excess"].size(), json["pieces"].get<std::size_t>());
  expect_contains(folder.read("ball.yaml"), "# Error: no point of a piece is farther than");
  EXPECT_EQ(folder.run({"check", "ball.yaml"}).code, 0);
}

TEST(ConvertCommand, TooFewPiecesAreToldByTheExitCode) {
  const ProgramFolder folder;
  folder.write("ball.obj", bumpy_obj(8, 16));
  const ProgramResult exact =
      folder.run({"convert", "ball.obj", "ball.yaml", "--exact", "--max-pieces", "4"});
  EXPECT_EQ(exact.code, 3);
  expect_contains(exact.error, "error: ball.obj: more than 4 convex pieces are needed to be exact");
  EXPECT_FALSE(folder.has("ball.yaml"));
  const ProgramResult rough =
      folder.run({"convert", "ball.obj", "ball.yaml", "--tolerance", "0.001", "--max-pieces", "4"});
  EXPECT_EQ(rough.code, 1);
  expect_contains(rough.error, "warning: 4 pieces are not enough for an error of 0.001 m");
  EXPECT_EQ(folder.run({"check", "ball.yaml"}).code, 0);
}

TEST(ConvertCommand, MeshesAreRewrittenAsObj) {
  const ProgramFolder folder;
  folder.write("l.obj", l_obj);
  const ProgramResult result = folder.run({"convert", "l.obj", "copy.obj"});
  EXPECT_EQ(result.code, 0) << result.error;
  expect_contains(result.out, "12 vertices and 8 faces");
  EXPECT_EQ(folder.read("copy.obj"), l_obj);
}

TEST(ConvertCommand, WhatMakesNoSenseIsRefused) {
  const ProgramFolder folder;
  folder.write("l.obj", l_obj);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"convert", "l.obj"},
           {"convert", "l.obj", "l.stl"},
           {"convert", "l.obj", "l.obj"},
           {"convert", "l.obj", "l.yaml", "--exact", "--tolerance", "0.1"},
           {"convert", "l.obj", "m.obj", "--exact"},
           {"convert", "l.obj", "l.yaml", "--max-pieces", "0"},
           {"convert", "l.obj", "l.yaml", "--tolerance", "-1"},
           {"convert", "l.obj", "l.yaml", "--exakt"},
       }) {
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 2) << testing::PrintToString(arguments) << result.error;
    EXPECT_EQ(line_count(result.error), 1u) << result.error;
  }
  EXPECT_EQ(folder.run({"convert", "none.obj", "l.yaml"}).code, 3);
  folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  const ProgramResult open = folder.run({"convert", "open.obj", "l.yaml"});
  EXPECT_EQ(open.code, 3);
  expect_contains(open.error, "open.obj: the surface is not closed");
  EXPECT_EQ(folder.run({"convert", "l.obj", "no/such/folder.yaml"}).code, 5);
  EXPECT_FALSE(folder.has("l.yaml"));
}

TEST(ConvertCommand, ShowsABarOnATerminalOnly) {
  const ProgramFolder folder;
  folder.write("ball.obj", bumpy_obj(8, 16));
  const ProgramResult shown =
      folder.run_on_terminal({"convert", "ball.obj", "ball.yaml", "--tolerance", "0.2"}, true);
  expect_contains(shown.out, "ball.obj [");
  EXPECT_EQ(folder.run({"convert", "ball.obj", "ball.yaml", "--tolerance", "0.2"}).error, "");
}

}  // namespace
}  // namespace rigor::convert_command_test
