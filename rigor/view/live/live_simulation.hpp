#pragma once

#include "rigor/view/live/live_command.hpp"
#include "rigor/view/live/live_file.hpp"
#include "rigor/view/live/live_run.hpp"

#include <atomic>
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

/// What a live simulation publishes: always the newest state, shared, and immutable once published.
struct LiveSnapshot {
  std::uint32_t generation = 0;                ///< Counts the scenes: increases whenever one is read anew.
  std::shared_ptr<const std::string> frame;    ///< live_frame_bytes.
  std::shared_ptr<const std::string> history;  ///< live_history_bytes.
  std::shared_ptr<const std::string> status;   ///< JSON, docs/live.md.
  std::shared_ptr<const std::vector<PageBlock>> blocks;  ///< Data of the page, of this generation.
  std::string scene;                                     ///< Name of the scene.
};

/// An answer to one client: a text (JSON), or a file to keep (live_file_bytes).
struct LiveReply {
  std::uint64_t client;
  bool is_text;
  std::string bytes;
};

/// A LiveRun on a thread of its own. It follows the clock, times the speed; where it cannot keep up, time
/// passes more slowly. Commands wait in a queue of limited length, and viewers see the newest snapshot, so no
/// viewer can slow it down.
class LiveSimulation {
 public:
  /// Reads the file; throws InputError. notify is called on the simulation's thread when there is a new
  /// snapshot, and reply with an answer; both must be quick.
  LiveSimulation(LiveFile file, std::function<void()> notify, std::function<void(LiveReply)> reply);
  LiveSimulation(const LiveSimulation&) = delete;
  LiveSimulation& operator=(const LiveSimulation&) = delete;
  /// Ends the thread; a step that takes long is broken off.
  ~LiveSimulation();

  /// Queues a command of a client; false if the queue is full. A pull replaces a pull of the same client that
  /// is still waiting. A release always finds room.
  bool post(std::uint64_t client, LiveCommand command);
  LiveSnapshot newest() const;
  /// Tells whether anybody is watching: otherwise no frames are made.
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
  void work();
  void wait();
  bool should_break_off() const;
  void begin_run(Scene scene);
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

  // Used by the simulation's thread only.
  std::unique_ptr<LiveRun> run_;
  std::uint32_t generation_ = 1;
  bool is_running_ = false, follows_file_ = true, file_has_changed_ = false, frame_is_new_ = true,
       status_is_new_ = true;
  double speed_ = 1;
  std::uint64_t puller_ = 0;  ///< The client that pulls.
  std::vector<std::string> file_messages_;
  std::string failure_;  ///< Of the program itself; ends with the next command.
  Clock::time_point paced_from_, looked_at_file_, published_, remembered_, told_, rated_from_;
  std::uint64_t history_revision_ = 0;               ///< Revision of the history published last.
  double pace_time_ = 0, rate_time_ = 0, rate_ = 0;  ///< Simulated [s]; simulated seconds per second.

  mutable std::mutex mutex_;  ///< Guards the members below.
  std::condition_variable wake_;
  std::deque<Request> requests_;
  LiveSnapshot newest_;
  bool is_watched_ = false;

  // Asked within long steps, without the mutex.
  std::atomic<bool> is_ending_{false};
  std::atomic<bool> is_urgent_{false};  ///< A command waits that ends or replaces the present step.
  Clock::time_point busy_since_;        ///< When the present step began; the simulation's thread only.

  std::thread thread_;
};

}  // namespace rigor
