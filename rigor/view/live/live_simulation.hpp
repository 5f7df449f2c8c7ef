#pragma once

#include "rigor/view/live/live_command.hpp"
#include "rigor/view/live/live_file.hpp"
#include "rigor/view/live/live_run.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace rigor {

/// What a live simulation shows of itself: always the newest, shared, never changed afterwards.
struct LiveSnapshot {
  std::uint32_t generation = 0;                ///< Counts the scenes: one more with each that is read anew.
  std::shared_ptr<const std::string> frame;    ///< live_frame_bytes.
  std::shared_ptr<const std::string> history;  ///< live_history_bytes.
  std::shared_ptr<const std::string> status;   ///< JSON, docs/live.md.
  std::shared_ptr<const std::vector<PageBlock>> blocks;  ///< Data of the page, of this generation.
  std::string scene;                                     ///< Its name.
};

/// An answer to one client: a text (JSON), or a file to keep (live_file_bytes).
struct LiveReply {
  std::uint64_t client;
  bool is_text;
  std::string bytes;
};

/// A LiveRun on a thread of its own. It goes with the clock, times the speed; where it cannot keep up, time
/// passes more slowly. Commands wait in a queue of limited length; what it shows is the newest snapshot, so
/// nobody who looks can hold it up.
class LiveSimulation {
 public:
  /// Reads the file: throws InputError. notify is called on the simulation's thread when there is a new
  /// snapshot, reply with an answer; both must be quick.
  LiveSimulation(LiveFile file, std::function<void()> notify, std::function<void(LiveReply)> reply);
  LiveSimulation(const LiveSimulation&) = delete;
  LiveSimulation& operator=(const LiveSimulation&) = delete;
  /// Ends the thread when its present step is done.
  ~LiveSimulation();

  /// Puts a command of a client into the queue; false if it is full. A pull takes the place of the same
  /// client's pull that is still waiting. A release always finds room.
  bool post(std::uint64_t client, LiveCommand command);
  LiveSnapshot newest() const;
  /// Whether anybody looks: without, no frames are made.
  void set_watched(bool is_watched);
  const std::vector<std::string>& warnings() const { return warnings_; }

  static constexpr std::size_t most_waiting = 64;

 private:
  using Clock = std::chrono::steady_clock;
  struct Request {
    std::uint64_t client;
    LiveCommand command;
  };

  void run();
  void wait();
  void carry_out_requests();
  void carry_out(const Request& request);
  void apply(const LiveCommand& command, std::uint64_t client);
  void look_at_file();
  void reload();
  void go_on();
  void pace_anew();
  void publish_frame();
  void publish_history();
  void publish_status();
  std::string status() const;

  LiveFile file_;
  const std::function<void()> notify_;
  const std::function<void(LiveReply)> reply_;
  std::vector<std::string> warnings_;

  // Of the simulation's thread alone.
  std::unique_ptr<LiveRun> run_;
  std::uint32_t generation_ = 1;
  bool is_running_ = false, follows_file_ = true, file_has_changed_ = false, frame_is_new_ = true,
       status_is_new_ = true;
  double speed_ = 1;
  std::uint64_t puller_ = 0;  ///< The client whose pull it is.
  std::vector<std::string> file_messages_;
  Clock::time_point paced_from_, looked_at_file_, published_, remembered_, told_, rated_from_;
  std::uint64_t history_revision_ = 0;               ///< Of the history that was published last.
  double pace_time_ = 0, rate_time_ = 0, rate_ = 0;  ///< Simulated [s]; simulated seconds a second.

  mutable std::mutex mutex_;  ///< Guards what follows.
  std::condition_variable wake_;
  std::deque<Request> requests_;
  LiveSnapshot newest_;
  bool is_ending_ = false, is_watched_ = false;

  std::thread thread_;
};

}  // namespace rigor
