#include "contracts/program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

// What tools/compare_schemes.py promises: a line a run, kept from one start to the next, and the table.

namespace rigor {
namespace {

const std::string spring = R"(rigor: 1
name: spring
run: {duration: 0.4, step: 0.01, output_interval: 0.01}
world: {gravity: [0, 0, 0]}
method: {integrator: midpoint}
bodies: [{name: a, position: [1, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}]
forces: [{type: spring, between: [world, a], points: [[0, 0, 0], [0, 0, 0]], stiffness: 100, damping: 0, length: 0.5}]
)";

struct SchemesFolder : ProgramFolder {
  /// Exit status of the tool with these arguments; what it says goes to out.txt and error.txt.
  int compare(const std::string& arguments) const {
    const std::string tool = std::string(RIGOR_SOURCE_DIR) + "/tools/compare_schemes.py";
    const std::string command = "cd '" + (*this / "").string() + "' && python3 '" + tool + "' --rigor '" +
                                RIGOR_PROGRAM + "' --csv rows.csv " + arguments + " > out.txt 2> error.txt";
    return std::system(command.c_str());
  }
};

TEST(CompareSchemes, WritesALineARunAndGoesOnWhereItStopped) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("spring.yaml", spring);
  folder.write("ball.yaml", ball);
  ASSERT_EQ(folder.compare("--schemes event-driven --factors 2,1 spring.yaml"), 0)
      << folder.read("error.txt");
  const std::string rows = folder.read("rows.csv");
  EXPECT_EQ(rows.rfind("scene,scheme,factor,step,end,", 0), 0u);
  EXPECT_EQ(line_count(rows), 3u) << rows;
  expect_contains(rows, "\nspring,event-driven,2,0.02,");
  // The error of the midpoint rule falls to a fourth with half the step, and the table says so.
  expect_contains(folder.read("out.txt"), "| event-driven | 1 | 1 | 1 | 0 | 0 | ");
  expect_contains(folder.read("out.txt"), " | 2 | ");
  expect_contains(folder.read("error.txt"), "spring event-driven: ");
  // What is there is kept and not run again.
  ASSERT_EQ(folder.compare("--schemes event-driven --factors 2,1 spring.yaml ball.yaml"), 0);
  EXPECT_EQ(folder.read("rows.csv").rfind(rows, 0), 0u);
  EXPECT_EQ(line_count(folder.read("rows.csv")), 5u);
  EXPECT_EQ(folder.read("error.txt").find("spring"), std::string::npos);
}

TEST(CompareSchemes, PutsItsTableBetweenTheMarks) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("ball.yaml", ball);
  folder.write("a.md", "before\n<!-- measured: begin -->\nold\n<!-- measured: end -->\nafter\n");
  ASSERT_EQ(folder.compare("--schemes event-driven --factors 1 --docs a.md ball.yaml"), 0);
  const std::string text = folder.read("a.md");
  EXPECT_EQ(text.rfind("before\n<!-- measured: begin -->\n| scheme |", 0), 0u) << text;
  EXPECT_TRUE(text.ends_with("|\n<!-- measured: end -->\nafter\n")) << text;
  EXPECT_EQ(text.find("old"), std::string::npos);
  folder.write("none.md", "no marks\n");
  EXPECT_NE(folder.compare("--schemes event-driven --factors 1 --docs none.md ball.yaml"), 0);
  expect_contains(folder.read("error.txt"), "none.md: must have the lines");
}

TEST(CompareSchemes, ASchemeThatIsRefusedIsALineThatSaysWhy) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("ball.yaml", ball);
  ASSERT_EQ(folder.compare("--schemes no-such-scheme --factors 2,1 ball.yaml"), 0)
      << folder.read("error.txt");
  expect_contains(folder.read("rows.csv"), "ball,no-such-scheme,2,,refused,");
  expect_contains(folder.read("rows.csv"), "unknown scheme 'no-such-scheme'");
  expect_contains(folder.read("out.txt"), "| no-such-scheme | 2 | 0 | 0 | 2 | 0 | 0 |");
  expect_contains(folder.read("out.txt"), "| ball | refuses (1) |\n\n1. ");
}

TEST(CompareSchemes, ARunThatTakesTooLongIsCountedAsTooSlow) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  std::string endless = spring;
  endless.replace(endless.find("duration: 0.4"), 13, "duration: 1e6");
  folder.write("endless.yaml", endless);
  ASSERT_EQ(folder.compare("--schemes event-driven --factors 1 --duration 1e6 --cpu-limit 0.05 endless.yaml"),
            0)
      << folder.read("error.txt");
  expect_contains(folder.read("out.txt"), "| event-driven | 1 | 0 | 0 | 0 | 1 | 0 |");
  expect_contains(folder.read("out.txt"), "| endless | too slow |");
}

}  // namespace
}  // namespace rigor
