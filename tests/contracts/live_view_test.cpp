#include "contracts/program.hpp"
#include "view/live_client.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace rigor::live_view_test {
namespace {

using namespace std::chrono_literals;

/// `rigor view` in a folder, from the address on its stdout to its end.
class Viewing {
 public:
  Viewing(const ProgramFolder& folder, std::vector<std::string> arguments) : folder_(folder) {
    arguments.insert(arguments.begin(), "view");
    child_ = folder.start(arguments);
    for (int i = 0; i < 500 && folder.read(".out").find('\n') == std::string::npos; ++i)
      std::this_thread::sleep_for(20ms);
    address = test::address_of(folder.read(".out"));
  }
  /// Ends it by a signal, once.
  ProgramResult end(int signal) {
    ::kill(child_, signal);
    return folder_.wait(child_);
  }

  test::LiveAddress address;

 private:
  const ProgramFolder& folder_;
  pid_t child_;
};

TEST(ViewCommand, ServesASceneUntilItIsInterrupted) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  Viewing viewing(folder, {"ball.yaml", "--set", "world.gravity=[0, 0, -3]"});
  const std::string page = test::get(viewing.address, "/?token=" + viewing.address.token);
  EXPECT_EQ(test::status_of(page), 200);
  expect_contains(page, "rigor-live");
  test::LiveSocket socket(viewing.address);
  EXPECT_EQ(socket.status, 101);
  expect_contains(socket.next([](const auto& message) { return message.opcode == 1; }).bytes, "-3");
  socket.send(R"({"do": "run"})");
  const ProgramResult result = viewing.end(SIGINT);
  EXPECT_EQ(result.code, 130);
  expect_contains(result.out, "http://127.0.0.1:");
  EXPECT_EQ(line_count(result.out), 1u);
}

TEST(ViewCommand, ServesATrajectoryAsAReplayWithoutASocket) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  ASSERT_EQ(folder.run({"run", "ball.yaml", "-o", "ball.h5", "--quiet"}).code, 0);
  Viewing viewing(folder, {"ball.h5"});
  const std::string page = test::get(viewing.address, "/?token=" + viewing.address.token);
  EXPECT_EQ(test::status_of(page), 200);
  expect_contains(page, "data-kind=\"frames\"");
  EXPECT_EQ(page.find("rigor-live"), std::string::npos);
  EXPECT_EQ(test::LiveSocket(viewing.address).status, 404);
  EXPECT_EQ(viewing.end(SIGTERM).code, 130);
}

TEST(ViewCommand, OpeningABrowserNeitherWaitsNorTellsTheTokenToOthers) {
  const ProgramFolder folder;
  folder.write("ball.yaml", ball_scene);
  // An opener that notes what it was given and what that is, and then takes its time.
  folder.write("xdg-open",
               "#!/bin/sh\nstat -c '%a %n' \"$1\" \"${1%/*}\" > opened.part\ncat \"$1\" >> opened.part\n"
               "mv opened.part opened\nexec sleep 5\n");
  std::filesystem::permissions(folder / "xdg-open", std::filesystem::perms::owner_all);
  const std::string old_path = std::getenv("PATH");
  ::setenv("PATH", ((folder / "").string() + ":" + old_path).c_str(), 1);
  ::setenv("DISPLAY", ":99", 1);
  Viewing viewing(folder, {"ball.yaml", "--open"});
  ::setenv("PATH", old_path.c_str(), 1);
  ::unsetenv("DISPLAY");
  EXPECT_EQ(test::status_of(test::get(viewing.address, "/?token=" + viewing.address.token)), 200);
  for (int i = 0; i < 200 && !folder.has("opened"); ++i) std::this_thread::sleep_for(20ms);
  const std::string opened = folder.read("opened");
  const std::string page = opened.substr(4, opened.find('\n') - 4);
  EXPECT_EQ(page.find(viewing.address.token), std::string::npos);
  EXPECT_TRUE(opened.starts_with("600 ")) << opened;
  expect_contains(opened, "\n700 ");
  expect_contains(opened, "url=http://127.0.0.1:" + std::to_string(viewing.address.port) +
                              "/?token=" + viewing.address.token);
  EXPECT_EQ(viewing.end(SIGTERM).code, 130);
  EXPECT_FALSE(std::filesystem::exists(page)) << page;
}

TEST(ViewCommand, APortInUseIsAnErrorOfTheSystem) {
  const ProgramFolder folder, other;
  folder.write("ball.yaml", ball_scene);
  other.write("ball.yaml", ball_scene);
  Viewing viewing(folder, {"ball.yaml"});
  const ProgramResult second =
      other.run({"view", "ball.yaml", "--port", std::to_string(viewing.address.port)});
  EXPECT_EQ(second.code, 5);
  expect_contains(second.error, "cannot serve on port");
  EXPECT_EQ(line_count(second.error), 1u);
  EXPECT_EQ(viewing.end(SIGINT).code, 130);
}

TEST(ViewCommand, BadInputIsToldBeforeAnythingIsServed) {
  const ProgramFolder folder;
  folder.write("bad.yaml", ball_scene + "nonsense: 1\n");
  folder.write("bad.h5", "no trajectory");
  EXPECT_EQ(folder.run({"view", "bad.yaml"}).code, 3);
  EXPECT_EQ(folder.run({"view", "bad.h5"}).code, 3);
  EXPECT_EQ(folder.run({"view", "none.yaml"}).code, 3);
  EXPECT_EQ(folder.run({"view", "bad.yaml", "--port", "70000"}).code, 2);
  EXPECT_EQ(folder.run({"view", "bad.h5", "--set", "run.duration=1"}).code, 2);
}

}  // namespace
}  // namespace rigor::live_view_test
