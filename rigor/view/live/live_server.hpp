#pragma once

#include "rigor/view/live/live_simulation.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Limits on what a client may use.
struct LiveLimits {
  std::size_t header_bytes = 8192, message_bytes = 4096;
  std::size_t connections = 32;  ///< Connections that have not shown the token.
  std::size_t sockets = 8;
  int messages = 240;          ///< Per second and socket.
  double request_time = 5;     ///< [s] until a request has arrived.
  double response_time = 60;   ///< [s] until its answer has been sent.
  double idle_time = 30;       ///< [s] without any traffic on a socket.
  int burst = 32;              ///< Connections at once.
  double accept_pause = 1e-3;  ///< [s] between later connections.
};

/// Pages that are made when they are asked for.
struct LivePages {
  /// The page at a path, "/" or "/run/12", with this policy; nothing if there is none. It may take a while:
  /// the server waits for it.
  std::function<std::optional<std::string>(std::string_view path, const std::string& policy)> page;
  /// The script at a path; nothing if there is none. It lives as long as the program.
  std::function<std::optional<std::string_view>(std::string_view path)> script;
};

/// Serves pages on 127.0.0.1: a recorded run, a live simulation with a WebSocket for frames and commands
/// (docs/live.md), or pages made on demand. Nothing is read from disk, so there is nothing to request but the
/// pages and the viewer. Everything that a client may use is limited: bytes, time, connections, messages.
class LiveServer {
 public:
  /// Binds the port (0: a free one). Throws FileError if it is not available.
  explicit LiveServer(std::uint16_t port, const LiveLimits& limits = {});
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;
  ~LiveServer();

  /// For the callbacks of the simulation; callable from any thread, return at once.
  void notify();
  void reply(LiveReply reply);

  /// Address of the page, with the token.
  std::string url() const;
  /// Serves on this thread until should_end returns true (it is called twenty times per second).
  void serve(LiveSimulation& simulation, const std::function<bool()>& should_end);
  void serve(const std::string& title, std::vector<PageBlock> blocks,
             const std::function<bool()>& should_end);
  void serve(const LivePages& pages, const std::function<bool()>& should_end);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rigor
