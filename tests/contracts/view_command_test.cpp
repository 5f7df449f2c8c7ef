#include "contracts/program.hpp"
#include "rigor/view/3d/png_file.hpp"

#include <gtest/gtest.h>

// What `rigor render`, `rigor plot` and the pictures of `rigor run` promise.

namespace rigor::view_command_test {
namespace {

/// A folder with a scene and its trajectory.
class ViewFolder : public ProgramFolder {
 public:
  ViewFolder() {
    write("ball.yaml", ball_scene);
    run({"run", "ball.yaml", "--quiet", "-o", "ball.h5"});
  }
};

TEST(RunPicture, IsASheetOfKeyMomentsWithTheSameBitsAgain) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult result = folder.run({"run", "ball.yaml", "--quiet", "-o", "a.png", "-o", "a.h5"});
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.out + result.error, "");
  const Image sheet = read_png(folder / "a.png");
  EXPECT_GT(sheet.width, 1000);
  // The same picture of the stored trajectory.
  EXPECT_EQ(folder.run({"render", "a.h5", "-o", "b.png"}).code, 0);
  EXPECT_EQ(folder.read("b.png"), folder.read("a.png"));
}

TEST(RunPicture, APlaceThatCannotBeWrittenIsFiveBeforeTheRun) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  const ProgramResult result = folder.run({"run", "ball.yaml", "--duration", "1e9", "-o", "missing/a.png"});
  EXPECT_EQ(result.code, 5);
  EXPECT_EQ(result.error, "error: cannot write 'missing/a.png': No such file or directory\n");
}

TEST(RunSparkline, IsPlottedOnATerminalOnly) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  ::setenv("LC_ALL", "C.UTF-8", 1);
  const ProgramResult blocks = folder.run_on_terminal({"run", "ball.yaml"}, true);
  expect_contains(blocks.out, "penetration   ");
  expect_contains(blocks.out, "█");
  EXPECT_EQ(blocks.out.find("\x1b[32m"), std::string::npos);
  expect_contains(folder.run_on_terminal({"run", "ball.yaml"}, false).out, "\x1b[32m");
  ::setenv("LC_ALL", "C", 1);
  const ProgramResult ascii = folder.run_on_terminal({"run", "ball.yaml"}, true);
  EXPECT_EQ(ascii.out.find("█"), std::string::npos);
  expect_contains(ascii.out, "energy        #");
  EXPECT_EQ(folder.run_on_terminal({"run", "ball.yaml", "--quiet"}, true).out, "");
  EXPECT_EQ(folder.run({"run", "ball.yaml"}).error, "");
}

TEST(RenderCommand, MakesPicturesOfScenesAndTrajectories) {
  const ViewFolder folder;
  EXPECT_EQ(folder.run({"render", "ball.yaml"}).code, 0);
  EXPECT_TRUE(folder.has("ball.png"));
  const ProgramResult one =
      folder.run({"render", "ball.h5", "--time", "0.5", "--size", "200x100", "-o", "one.png"});
  EXPECT_EQ(one.code, 0) << one.error;
  EXPECT_EQ(one.out, "");
  EXPECT_EQ(one.error, "wrote one.png: 200 x 100 pixels\n");
  EXPECT_EQ(read_png(folder / "one.png").width, 200);
  // A scene is simulated up to the time: the same motion, and the same picture if the camera is given.
  const std::vector<std::string> camera = {"--size", "200x100", "--eye", "0,-4,1", "--target", "0,0,0.5"};
  std::vector<std::string> scene = {"render", "ball.yaml", "--time", "0.5", "-o", "scene.png"};
  std::vector<std::string> run = {"render", "ball.h5", "--time", "0.5", "-o", "run.png"};
  scene.insert(scene.end(), camera.begin(), camera.end());
  run.insert(run.end(), camera.begin(), camera.end());
  EXPECT_EQ(folder.run(scene).code + folder.run(run).code, 0);
  EXPECT_EQ(folder.read("scene.png"), folder.read("run.png"));
}

TEST(RenderCommand, WritesSequences) {
  const ViewFolder folder;
  const ProgramResult result =
      folder.run({"render", "ball.h5", "--frames", "3", "--size", "64x36", "-o", "a.png"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.error, "wrote a_0001.png to a_0003.png: 3 pictures\n");
  EXPECT_TRUE(folder.has("a_0001.png") && folder.has("a_0003.png") && !folder.has("a_0004.png"));
  EXPECT_NE(folder.read("a_0001.png"), folder.read("a_0002.png"));
}

TEST(RenderCommand, WithoutFfmpegAFilmIsAnErrorBeforeTheRun) {
  const ViewFolder folder;
  folder.write("long.yaml", ball_scene);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"render", "ball.h5", "--mp4", "film.mp4"},
                                             {"render", "ball.h5", "-o", "film.mp4"},
                                             {"run", "long.yaml", "--duration", "1e6", "-o", "film.mp4"}}) {
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 5);
    EXPECT_EQ(result.out, "");
    expect_contains(
        result.error,
        "cannot write 'film.mp4': films are encoded by the program ffmpeg, which is not installed");
    EXPECT_EQ(line_count(result.error), 1u) << result.error;
    EXPECT_FALSE(folder.has("film.mp4"));
  }
  ::setenv("PATH", path.c_str(), 1);
}

/// Runs with a stand-in for ffmpeg on the PATH.
ProgramResult run_with_ffmpeg(const ProgramFolder& folder, const std::string& script,
                              const std::vector<std::string>& arguments) {
  folder.write("ffmpeg", "#!/bin/sh\n" + script);
  std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", ((folder / "").string() + ":" + path).c_str(), 1);
  const ProgramResult result = folder.run(arguments);
  ::setenv("PATH", path.c_str(), 1);
  return result;
}

TEST(RenderCommand, FfmpegGetsTheFilesNameAsItIsAndAllPictures) {
  const ViewFolder folder;
  const ProgramResult result = run_with_ffmpeg(
      folder, "printf '%s\\n' \"$@\" > arguments\ncat > bytes\n",
      {"render", "ball.h5", "--mp4", "a b;$(touch x).mp4", "--frames", "3", "--size", "64x36"});
  EXPECT_EQ(result.code, 0) << result.error;
  expect_contains(folder.read("arguments"), "\nfile:a b;$(touch x).mp4\n");
  expect_contains(folder.read("arguments"), "\n64x36\n");
  EXPECT_EQ(folder.read("bytes").size(), 3u * 64 * 36 * 3);
  EXPECT_FALSE(folder.has("x"));
  EXPECT_FALSE(folder.has("a b;$(touch x)_0001.png"));
}

TEST(RunCommand, AnOutputMp4IsTheFilmOfTheRun) {
  const ViewFolder folder;
  folder.write("short.yaml", ball_scene);
  const std::string script = "printf '%s\\n' \"$@\" > arguments\nwc -c > bytes\n";
  const ProgramResult result = run_with_ffmpeg(
      folder, script, {"run", "short.yaml", "--duration", "0.2", "-o", "a.mp4", "-o", "a.csv"});
  EXPECT_EQ(result.code, 0) << result.error;
  expect_contains(folder.read("arguments"), "\nfile:a.mp4\n");
  expect_contains(folder.read("arguments"), "\n1280x720\n");
  // A short run is shown for four seconds.
  EXPECT_EQ(std::stol(folder.read("bytes")), 4L * 30 * 1280 * 720 * 3);
  EXPECT_TRUE(folder.has("a.csv"));
}

TEST(RenderCommand, AnFfmpegThatFailsIsFive) {
  const ViewFolder folder;
  for (const char* script : {"exit 3\n", "cat > /dev/null; exit 3\n"}) {
    const ProgramResult result =
        run_with_ffmpeg(folder, script, {"render", "ball.h5", "--mp4", "a.mp4", "--size", "640x360"});
    EXPECT_EQ(result.code, 5);
    expect_contains(result.error, "cannot write 'a.mp4': ffmpeg ended too early, with code 3");
  }
}

TEST(RenderCommand, WhatMakesNoSenseIsTwo) {
  const ViewFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"-o", "a.jpg"}, "output 'a.jpg': its name must end in .png"},
      {{"--size", "0x0"}, "--size '0x0': width and height must be from 16 to 16384 pixels"},
      {{"--size", "1000000000x1000000000"}, "width and height must be from 16 to 16384 pixels"},
      {{"--size", "16384x16384"}, "together at most 33554432"},
      {{"--size", "99999999999x5"}, "not a size such as 1280x720"},
      {{"--size", "640"}, "--size '640': not a size such as 1280x720"},
      {{"--size", "640x360x"}, "not a size such as 1280x720"},
      {{"--size", "-640x360"}, "width and height must be from 16"},
      {{"--time", "5"}, "--time 5 s is outside the run, which is from 0 s to 1 s"},
      {{"--time", "-0.1"}, "--time -0.1 s is outside the run"},
      {{"--time", "0.5", "--sheet"}, "do not go together"},
      {{"--frames", "2", "--sheet"}, "do not go together"},
      {{"--frames", "0"}, "--frames"},
      {{"--eye", "1,2"}, "--eye '1,2': not a point such as 1,-2,0.5"},
      {{"--eye", "1,2,nan"}, "not a point"},
      {{"--target", "a,b,c"}, "--target 'a,b,c': not a point"},
      {{"--eye", "1,2,3", "--target", "1,2,3"}, "the same point"},
      {{"--field-of-view", "0"}, "--field-of-view"},
      {{"--mp4", "a.avi"}, "output 'a.avi': its name must end in .mp4"},
      {{"--mp4", "a.mp4", "--size", "641x360"}, "must be even numbers"},
      {{"--mp4", "a.mp4", "-o", "b.mp4"}, "-o and --mp4 name two outputs"},
      {{"--set", "bodies.ball.mass=2"}, "--set needs a scene"},
  };
  for (auto [arguments, message] : wrong) {
    arguments.insert(arguments.begin(), {"render", "ball.h5"});
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 2) << testing::PrintToString(arguments);
    expect_contains(result.error, message);
    EXPECT_EQ(line_count(result.error), 1u) << result.error;
  }
}

TEST(RenderCommand, InputsThatCannotBeReadAreThreeAndPlacesThatCannotBeWrittenFive) {
  const ViewFolder folder;
  folder.write("text.h5", "no trajectory");
  EXPECT_EQ(folder.run({"render", "missing.h5"}).code, 3);
  EXPECT_EQ(folder.run({"render", "text.h5"}).code, 3);
  EXPECT_EQ(folder.run({"render", "missing.yaml"}).code, 3);
  EXPECT_EQ(folder.run({"plot", "text.h5", "energy.total", "-o", "a.svg"}).code, 3);
  EXPECT_EQ(folder.run({"render", "ball.h5", "-o", "missing/a.png"}).code, 5);
  EXPECT_EQ(folder.run({"plot", "ball.h5", "energy.total", "-o", "missing/a.svg"}).code, 5);
}

TEST(PlotCommand, WritesSvgAndPng) {
  const ViewFolder folder;
  const std::vector<std::string> keys = {"energy.kinetic", "energy.total", "body.ball.position.z",
                                         "penetration"};
  for (const char* name : {"a.svg", "a.png"}) {
    std::vector<std::string> arguments = {"plot", "ball.h5", "-o", name};
    arguments.insert(arguments.end(), keys.begin(), keys.end());
    const ProgramResult result = folder.run(arguments);
    EXPECT_EQ(result.code, 0) << result.error;
    EXPECT_EQ(result.out + result.error, "");
  }
  expect_contains(folder.read("a.svg"), "body.ball.position.z");
  EXPECT_EQ(read_png(folder / "a.png").width, 1280);
}

TEST(PlotCommand, UnknownKeysAreTwoAndNameTheNearest) {
  const ViewFolder folder;
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"energy.kinetik", "error: unknown key 'energy.kinetik'; did you mean 'energy.kinetic'?\n"},
      {"body.bal.position.x", "error: the run has no body 'bal'; did you mean 'ball'?\n"},
      {"body.ball.positon.x",
       "error: unknown key 'body.ball.positon.x'; did you mean 'body.ball.position.x'?\n"},
  };
  for (const auto& [key, message] : wrong) {
    const ProgramResult result = folder.run({"plot", "ball.h5", key, "-o", "a.svg"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.error, message);
    EXPECT_FALSE(folder.has("a.svg"));
  }
  EXPECT_EQ(folder.run({"plot", "ball.h5", "-o", "a.svg"}).code, 2);
  EXPECT_EQ(folder.run({"plot", "ball.h5", "energy.total"}).code, 2);
  expect_contains(folder.run({"plot", "ball.h5", "energy.total", "-o", "a.pdf"}).error,
                  "output 'a.pdf': its name must end in .svg or .png");
}

}  // namespace
}  // namespace rigor::view_command_test
