#include "contracts/program.hpp"
#include "rigor/sim/method/method.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

// What the tools that measure promise, tools/compare_schemes.py and tools/measure_piles.py: a line a run,
// kept from one start to the next, in an order that does not depend on the number of jobs, and the table.

namespace rigor::compare_schemes_test {
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
  /// Exit status of compare_schemes.py with these arguments; what it says goes to out.txt and error.txt.
  int compare(const std::string& arguments, const std::string& program = RIGOR_PROGRAM) const {
    return call("compare_schemes.py", "--program '" + program + "' --csv rows.csv " + arguments);
  }

  int call(const std::string& tool, const std::string& arguments) const {
    const std::string command = "cd '" + (*this / "").string() + "' && python3 '" RIGOR_SOURCE_DIR "/tools/" +
                                tool + "' " + arguments + " > out.txt 2> error.txt";
    return std::system(command.c_str());
  }
};

TEST(CompareSchemes, WritesALineARunAndGoesOnWhereItStopped) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("spring.yaml", spring);
  folder.write("ball.yaml", ball_scene);
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
  const std::string more = folder.read("rows.csv");
  EXPECT_EQ(line_count(more), 5u);
  EXPECT_TRUE(more.ends_with(rows.substr(rows.find('\n'))));  // In the order of the scenes.
  EXPECT_EQ(folder.read("error.txt").find("spring"), std::string::npos);
  // The table can be made again without the program.
  const std::string table = folder.read("out.txt");
  ASSERT_EQ(folder.compare("--table", "/no/such/program"), 0) << folder.read("error.txt");
  EXPECT_EQ(folder.read("out.txt"), table);
}

TEST(CompareSchemes, TheOrderOfRowsDoesNotDependOnTheNumberOfJobs) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("spring.yaml", spring);
  folder.write("ball.yaml", ball_scene);
  const std::vector<std::string> schemes = {"event-driven", "time-stepping", "penalty", "impulse-based",
                                            "hybrid"};
  std::string start;  // What the rows must begin with, line by line.
  for (const std::string scene : {"ball", "spring"})
    for (const std::string& scheme : schemes)
      for (const std::string factor : {"2", "1"}) start += scene + "," + scheme + "," + factor + ",\n";
  for (const std::string jobs : {"1", "4"}) {
    std::filesystem::remove(folder / "rows.csv");
    ASSERT_EQ(folder.compare("--duration 0.1 --factors 1,2 --jobs " + jobs + " spring.yaml ball.yaml"), 0)
        << folder.read("error.txt");
    std::istringstream rows(folder.read("rows.csv")), expected(start);
    std::string row, begin;
    std::getline(rows, row);
    while (std::getline(expected, begin)) {
      ASSERT_TRUE(std::getline(rows, row));
      EXPECT_EQ(row.rfind(begin, 0), 0u) << row;
    }
    EXPECT_FALSE(std::getline(rows, row)) << row;
  }
}

TEST(CompareSchemes, RunsManyBodiesByTimeSteppingOnly) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("ball.yaml", ball_scene);
  ASSERT_EQ(folder.compare("--most-bodies 0 --factors 1 ball.yaml"), 0) << folder.read("error.txt");
  expect_contains(folder.read("rows.csv"),
                  "\nball,event-driven,1,,not tried,not tried with 1 dynamic bodies,");
  expect_contains(folder.read("rows.csv"), "\nball,time-stepping,1,0.01,ok,");
  expect_contains(folder.read("out.txt"), "| ball | too slow | runs | too slow | too slow | too slow |");
}

TEST(CompareSchemes, KnowsEverySchemeThatTheProgramOffers) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  const std::string tool = text_of(RIGOR_SOURCE_DIR "/tools/compare_schemes.py");
  const std::size_t begin = tool.find("\nSCHEMES = [");
  const std::string named = tool.substr(begin, tool.find(']', begin) - begin);
  for (const MethodChoice& choice : method_choices())
    if (choice.key == "scheme" && choice.value != "auto")
      expect_contains(named, '"' + std::string(choice.value) + '"');
}

TEST(MeasurePiles, KeepsItsRowsInTheOrderOfSchemesAndSeeds) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  // Stands for rigor_scene_runs: the later the seed, the earlier it is done.
  folder.write("program.sh", R"sh(#!/bin/sh
name=$(basename "$1" .yaml)
sleep "0.$((9 - ${name#pile-}))"
echo scene,scheme,end,end_time,relative_rise,overlap,last_overlap,fallbacks,residual,cpu_time
echo "$name,${5#method.scheme=},ok,5,1e-12,2e-7,1e-7,0,1e-14,1"
)sh");
  std::filesystem::permissions(folder / "program.sh", std::filesystem::perms::owner_all);
  ASSERT_EQ(folder.call("measure_piles.py",
                        "--program ./program.sh --jobs 4 --seeds 7-8 --csv rows.csv hybrid time-stepping"),
            0)
      << folder.read("error.txt");
  const std::string rows = folder.read("rows.csv");
  const std::vector<std::string> begins = {"\npile-7,time-stepping,ok,", "\npile-8,time-stepping,ok,",
                                           "\npile-7,hybrid,ok,", "\npile-8,hybrid,ok,"};
  for (std::size_t i = 0, at = 0; i < begins.size(); ++i) {
    EXPECT_NE(rows.find(begins[i], at), std::string::npos) << rows;
    at = rows.find(begins[i]);
  }
  expect_contains(folder.read("out.txt"), "| hybrid | 2 of 2 | 1e-12 | 2e-07 |");
  const std::string table = folder.read("out.txt");
  ASSERT_EQ(folder.call("measure_piles.py", "--table --csv rows.csv hybrid time-stepping"), 0);
  EXPECT_EQ(folder.read("out.txt"), table);
}

TEST(CompareSchemes, PutsItsTableBetweenTheMarks) {
  const SchemesFolder folder;
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  folder.write("ball.yaml", ball_scene);
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
  folder.write("ball.yaml", ball_scene);
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
}  // namespace rigor::compare_schemes_test
