#include "rigor/view/live/live_server.hpp"

#include "rigor/io/files/file_error.hpp"
#include "view/live_client.hpp"
#include "view/live_scenes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <thread>

namespace rigor::live_server_test {
namespace {

using namespace std::chrono_literals;
using test::address_of;
using test::answer;
using test::Connection;
using test::get;
using test::LiveAddress;
using test::LiveSocket;
using test::status_of;
using Json = nlohmann::json;

/// A server with a live ball, on a thread of its own.
class LiveServerTest : public testing::Test {
 protected:
  LiveServerTest() {
    std::string name = (std::filesystem::temp_directory_path() / "rigor_live_XXXXXX").string();
    if (!::mkdtemp(name.data())) std::abort();
    folder = name;
    std::ofstream(folder / "live.yaml") << test::live_ball;
    server = std::make_unique<LiveServer>(std::uint16_t{0}, limits);
    simulation = std::make_unique<LiveSimulation>(
        LiveFile(folder / "live.yaml", {}), [this] { server->notify(); },
        [this](LiveReply reply) { server->reply(std::move(reply)); });
    address = address_of(server->url());
    thread = std::thread([this] { server->serve(*simulation, [this] { return should_end.load(); }); });
  }
  ~LiveServerTest() override {
    should_end = true;
    thread.join();
    simulation.reset();
    std::filesystem::remove_all(folder);
  }

  static bool is_status(const LiveSocket::Message& message) {
    return message.opcode == 1 && message.bytes.find("\"type\": \"status\"") != std::string::npos;
  }
  /// Frames are of kind 1, files of 2, histories of 3.
  static bool is_bytes(const LiveSocket::Message& message, std::uint32_t kind) {
    std::uint32_t own = 0;
    if (message.opcode == 2) std::memcpy(&own, message.bytes.data(), sizeof own);
    return own == kind;
  }
  static double time_of(const LiveSocket::Message& frame) {
    double time = 0;
    std::memcpy(&time, frame.bytes.data() + 20, sizeof time);
    return time;
  }
  /// The first frame later than a time.
  static LiveSocket::Message frame_after(LiveSocket& socket, double time) {
    return socket.next([time](const LiveSocket::Message& message) {
      return is_bytes(message, 1) && time_of(message) > time;
    });
  }
  template <typename Predicate>
  static Json status_with(LiveSocket& socket, Predicate is_wanted) {
    Json status;
    socket.next([&](const LiveSocket::Message& message) {
      if (!is_status(message)) return false;
      status = Json::parse(message.bytes);
      return static_cast<bool>(is_wanted(status));
    });
    return status;
  }
  static std::string error_after(LiveSocket& socket, const std::string& message, int opcode = 1) {
    socket.send(message, opcode);
    const LiveSocket::Message reply = socket.next([](const LiveSocket::Message& candidate) {
      return candidate.opcode == 1 && candidate.bytes.find("\"error\"") != std::string::npos;
    });
    return Json::parse(reply.bytes)["messages"][0].get<std::string>();
  }

  std::filesystem::path folder;
  // Shorter than usual, so that the test does not take long.
  const LiveLimits limits{.request_time = 0.6};
  std::unique_ptr<LiveServer> server;
  std::unique_ptr<LiveSimulation> simulation;
  LiveAddress address;
  std::atomic<bool> should_end{false};
  std::thread thread;
};

TEST_F(LiveServerTest, ThePageComesWithHeadersThatKeepItToItself) {
  const std::string page = get(address, "/?token=" + address.token);
  EXPECT_EQ(status_of(page), 200);
  for (const std::string part :
       {"Content-Security-Policy: default-src 'none'; script-src 'self';", "frame-ancestors 'none'",
        "X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer", "Cache-Control: no-store",
        "<meta name=\"rigor-live\" content=\"1\">", "data-kind=\"header\"", "<script src=\"/viewer.js\">"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_NE(page.find("connect-src ws://" + address.host()), std::string::npos);
  const std::string script = get(address, "/viewer.js");
  EXPECT_EQ(status_of(script), 200);
  EXPECT_NE(script.find("Content-Type: text/javascript"), std::string::npos);
}

TEST_F(LiveServerTest, RequestsOfOthersAreRefused) {
  const std::string good = "GET /?token=" + address.token + " HTTP/1.1\r\n";
  EXPECT_EQ(status_of(answer(address.port, good + "Host: evil.example\r\n")), 421);
  EXPECT_EQ(status_of(answer(address.port, good)), 421);
  EXPECT_EQ(status_of(get(address, "/")), 403);
  EXPECT_EQ(status_of(get(address, "/scene.yaml?token=" + address.token)), 404);
  EXPECT_EQ(status_of(get(address, "/../../etc/passwd?token=" + address.token)), 404);
  const std::string upgrade =
      "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  const std::string live = "/live?token=" + address.token;
  EXPECT_EQ(status_of(get(address, live, upgrade)), 403) << "no Origin";
  EXPECT_EQ(status_of(get(address, live, upgrade + "Origin: http://evil.example\r\n")), 403);
  EXPECT_EQ(status_of(get(address, "/live?token=00", upgrade + "Origin: http://" + address.host() + "\r\n")),
            403);
}

TEST_F(LiveServerTest, OversizedAndMalformedRequestsAreRefused) {
  EXPECT_EQ(status_of(get(address, "/", "X: " + std::string(20000, 'a') + "\r\n")), 431);
  EXPECT_EQ(status_of(get(address, "/" + std::string(20000, 'a'))), 431);
  EXPECT_EQ(status_of(get(address, "/?token=" + address.token, "Content-Length: 1000000000\r\n")), 413);
  EXPECT_EQ(status_of(get(address, "/?token=" + address.token, "Transfer-Encoding: chunked\r\n")), 413);
  EXPECT_EQ(status_of(answer(address.port, "nonsense\r\n")), 400);
  EXPECT_EQ(status_of(get(address, "/?token=" + address.token)), 200) << "and it goes on serving";
}

TEST_F(LiveServerTest, ASlowClientIsDroppedWhenItsTimeIsOver) {
  Connection slow(address.port);
  const auto begin = std::chrono::steady_clock::now();
  bool is_closed = false;
  for (int i = 0; i < 30 && !is_closed; ++i) {
    slow.send("G");
    is_closed = slow.is_closed_within(0.1);
  }
  const double waited = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_TRUE(is_closed);
  EXPECT_GT(waited, 0.9 * limits.request_time) << "an honest client has this long";
}

TEST_F(LiveServerTest, AFloodOfConnectionsIsLimitedAndAnHonestClientIsServed) {
  LiveSocket watching(address);
  ASSERT_EQ(watching.status, 101);
  std::deque<Connection> flood;
  for (std::size_t i = 0; i < 3 * limits.connections; ++i) flood.emplace_back(address.port).send("G");
  EXPECT_EQ(status_of(get(address, "/?token=" + address.token)), 200);
  EXPECT_TRUE(flood.front().is_closed_within(1)) << "the oldest had to go";
  watching.send(R"({"do": "step"})");
  EXPECT_EQ(time_of(frame_after(watching, 0)), 0.01) << "who has the token keeps its connection";
}

TEST_F(LiveServerTest, AnHonestClientWaitsNoSecondBehindManyIdleOnes) {
  std::deque<Connection> idle;
  // Half of them have sent a little, as requests that never end.
  for (int i = 0; i < 700; ++i) {
    idle.emplace_back(address.port);
    if (i % 2 == 0) idle.back().send("G");
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(status_of(get(address, "/?token=" + address.token)), 200);
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(waited.count(), 1);
}

TEST_F(LiveServerTest, MoreSocketsThanAllowedAreRefused) {
  std::deque<LiveSocket> sockets;
  for (std::size_t i = 0; i < limits.sockets; ++i) {
    sockets.emplace_back(address);
    EXPECT_EQ(sockets.back().status, 101);
  }
  EXPECT_EQ(LiveSocket(address).status, 503);
}

TEST_F(LiveServerTest, RunPauseAndStepDoWhatTheySay) {
  LiveSocket socket(address);
  socket.send(R"({"do": "run"})");
  const double later = time_of(frame_after(socket, 0.05));
  socket.send(R"({"do": "pause"})");
  status_with(socket, [](const Json& status) { return status["running"] == false; });
  std::this_thread::sleep_for(100ms);
  socket.send(R"({"do": "step"})");
  const double stepped = time_of(frame_after(socket, later));
  std::this_thread::sleep_for(200ms);
  socket.send(R"({"do": "step"})");
  EXPECT_LE(time_of(frame_after(socket, stepped)) - stepped, 0.01 + 1e-12)
      << "time stood still between the steps";
  socket.send(R"({"do": "reset"})");
  socket.next(
      [](const LiveSocket::Message& message) { return is_bytes(message, 1) && time_of(message) == 0; });
}

TEST_F(LiveServerTest, ChangesArriveAndAreTold) {
  LiveSocket socket(address);
  socket.send(R"({"do": "gravity", "value": [0, 0, 0]})");
  socket.send(R"({"do": "surface", "material": "rubber", "friction": 0.75})");
  socket.send(R"({"do": "method", "key": "integrator", "value": "rk4"})");
  socket.send(R"({"do": "speed", "value": 1000})");
  const Json status = status_with(socket, [](const Json& candidate) { return candidate["speed"] == 1000; });
  EXPECT_EQ(status["gravity"], Json({0, 0, 0}));
  EXPECT_EQ(status["surfaces"][1]["friction"], 0.75);
  socket.send(R"({"do": "push", "body": 1, "point": [0, 0, 0], "impulse": [0, 0, 2]})");
  socket.send(R"({"do": "step"})");
  const LiveSocket::Message frame = frame_after(socket, 0);
  float height = 0;
  const std::size_t series = 11;
  std::memcpy(&height, frame.bytes.data() + 28 + 8 * series + 8, sizeof height);
  EXPECT_NEAR(height, 0.02, 1e-6) << "2 m/s for 0.01 s, without gravity";
}

TEST_F(LiveServerTest, WhatIsNoCommandIsAnsweredWithAnError) {
  LiveSocket socket(address);
  EXPECT_EQ(error_after(socket, "{"), "the message is not JSON");
  EXPECT_EQ(error_after(socket, R"({"do": "fly"})").substr(0, 21), "unknown command 'fly'");
  EXPECT_EQ(error_after(socket, R"({"do": "run"})", 2), "commands are texts");
  EXPECT_EQ(error_after(socket, R"({"do": "push", "body": 0, "point": [0, 0, 0], "impulse": [0, 0, 0]})"),
            "body 0 is none that forces can move");
  socket.send(R"({"do": "step"})");
  EXPECT_EQ(time_of(frame_after(socket, 0)), 0.01);
}

TEST_F(LiveServerTest, TooLongAndTooManyMessagesEndTheConnection) {
  LiveSocket large(address);
  large.send(std::string(5000, ' '));
  EXPECT_TRUE(large.connection().is_closed_within(2));
  LiveSocket many(address);
  for (int i = 0; i < 2 * limits.messages; ++i) many.send(R"({"do": "pause"})");
  EXPECT_TRUE(many.connection().is_closed_within(2));
  EXPECT_EQ(LiveSocket(address).status, 101);
}

TEST_F(LiveServerTest, WhoDoesNotReadDoesNotHoldTheSimulationUp) {
  LiveSocket deaf(address, 1024), honest(address);
  // A page of more than half a megabyte: more than the system keeps for who does not read.
  deaf.send(R"({"do": "export"})");
  deaf.send(R"({"do": "export"})");
  honest.send(R"({"do": "run"})");
  EXPECT_GE(time_of(frame_after(honest, 0.5)), 0.5);
}

TEST_F(LiveServerTest, APageThatIsOpenedLaterGetsTheHistory) {
  {
    LiveSocket early(address);
    for (int i = 1; i <= 5; ++i) early.send(R"({"do": "step"})");
    frame_after(early, 0.045);
  }
  LiveSocket late(address);
  const LiveSocket::Message history = late.next([](const LiveSocket::Message& message) {
    std::uint32_t rows = 0;
    if (is_bytes(message, 3)) std::memcpy(&rows, message.bytes.data() + 12, sizeof rows);
    return rows == 6;
  });
  double time = 0;
  std::memcpy(&time, history.bytes.data() + 28 + 8 * 11 * 5, sizeof time);
  EXPECT_EQ(time, 0.05) << "the last of six rows of eleven series";
}

TEST_F(LiveServerTest, ALostPullerLetsGo) {
  const auto speed_after = [](LiveSocket& socket, double time) {
    socket.send(R"({"do": "step"})");
    const LiveSocket::Message frame = frame_after(socket, time);
    EXPECT_NEAR(time_of(frame), time + 0.01, 1e-12);
    float speed = 0;
    std::memcpy(&speed, frame.bytes.data() + 28 + 8 * 11 + 4 * 9, sizeof speed);
    return speed;
  };
  {
    LiveSocket puller(address);
    puller.send(R"({"do": "gravity", "value": [0, 0, 0]})");
    puller.send(R"({"do": "pull", "body": 1, "point": [0, 0, 0], "target": [0, 0, 2]})");
    const float first = speed_after(puller, 0);
    EXPECT_GT(speed_after(puller, 0.01), first) << "it is pulled upwards";
  }
  std::this_thread::sleep_for(300ms);
  LiveSocket socket(address);
  const float first = speed_after(socket, 0.02);
  EXPECT_EQ(speed_after(socket, 0.03), first) << "nothing pulls it any more";
}

TEST_F(LiveServerTest, ABrokenFileIsToldAndAMendedOneIsANewScene) {
  LiveSocket socket(address);
  std::string text = test::live_ball;
  text.replace(text.find("mass: 1"), 7, "mass: -1");
  std::ofstream(folder / "live.yaml") << text;
  const Json broken =
      status_with(socket, [](const Json& status) { return !status["file"]["messages"].empty(); });
  EXPECT_NE(broken["file"]["messages"][0].get<std::string>().find("mass"), std::string::npos);
  EXPECT_EQ(broken["generation"], 1) << "the old scene stays";
  std::ofstream(folder / "live.yaml") << test::live_ball + "# mended\n";
  const Json mended = status_with(socket, [](const Json& status) { return status["generation"] == 2; });
  EXPECT_TRUE(mended["file"]["messages"].empty());
  EXPECT_NE(get(address, "/?token=" + address.token).find("rigor-live\" content=\"2\""), std::string::npos);
}

TEST_F(LiveServerTest, StateAndPageComeAsFiles) {
  LiveSocket socket(address);
  for (const std::string command : {"save", "export"}) {
    socket.send("{\"do\": \"" + command + "\"}");
    const LiveSocket::Message file =
        socket.next([](const LiveSocket::Message& message) { return is_bytes(message, 2); });
    const std::string suffix = command == "save" ? ".checkpoint" : ".html";
    EXPECT_EQ(file.bytes.substr(8, 12 + suffix.size()), "live_ball-0s" + suffix);
  }
}

TEST(LiveServer, APortInUseIsAnErrorThatSaysSo) {
  const LiveServer first(std::uint16_t{0});
  const LiveAddress address = address_of(first.url());
  try {
    const LiveServer second(static_cast<std::uint16_t>(address.port));
    FAIL() << "the port was taken twice";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("choose another --port"), std::string::npos) << error.what();
  }
}

TEST(LiveSimulation, APauseBreaksOffAStepWithoutEnd) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "rigor_live_stiff.yaml";
  std::ofstream(path)
      << "rigor: 1\nrun: {step: 0.005, output_interval: 0.02}\nmethod: {scheme: time-stepping}\n"
         "bodies:\n  - {name: a, position: [0, 0, 1], velocity: [1, 0, 0], linear_drag: 1e15, "
         "angular_drag: 1e15, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}\n";
  LiveSimulation simulation(
      LiveFile(path, {}), [] {}, [](const LiveReply&) {});
  const auto seconds_until = [&simulation](const char* part) {
    const auto begin = std::chrono::steady_clock::now();
    const auto passed = [&begin] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    while (simulation.newest().status->find(part) == std::string::npos && passed() < 10)
      std::this_thread::sleep_for(5ms);
    return passed();
  };
  // The status of a run appears before its first step or not at all.
  ASSERT_TRUE(simulation.post(1, live::Speed{2}));
  seconds_until("\"speed\": 2");
  ASSERT_TRUE(simulation.post(1, live::Run{}));
  std::this_thread::sleep_for(300ms);
  ASSERT_TRUE(simulation.post(1, live::Pause{}));
  ASSERT_TRUE(simulation.post(1, live::Speed{3}));
  EXPECT_LT(seconds_until("\"speed\": 3"), 1);
  EXPECT_NE(simulation.newest().status->find("\"running\": false"), std::string::npos);
  ASSERT_TRUE(simulation.post(1, live::Run{}));
  std::this_thread::sleep_for(100ms);
  // Its end does not wait for the step either.
  std::filesystem::remove(path);
}

TEST(LiveSimulation, AQueueThatIsFullTakesNoMoreButReleasesAndNewerPulls) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "rigor_live_queue.yaml";
  std::ofstream(path) << test::live_ball;
  // The simulation waits in its first answer until the queue has been filled.
  std::atomic<bool> may_go_on{false};
  LiveSimulation simulation(
      LiveFile(path, {}), [] {},
      [&may_go_on](const LiveReply&) {
        while (!may_go_on) std::this_thread::sleep_for(1ms);
      });
  ASSERT_TRUE(simulation.post(1, live::MethodValue{"integrator", "none"}));
  std::this_thread::sleep_for(100ms);
  std::size_t taken = 0;
  while (simulation.post(1, live::Pause{}) && taken < 1000) ++taken;
  EXPECT_EQ(taken, LiveSimulation::most_waiting);
  EXPECT_TRUE(simulation.post(1, live::Release{}));
  EXPECT_FALSE(simulation.post(2, live::Run{}));
  may_go_on = true;
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace rigor::live_server_test
