#pragma once

#include <chrono>
#include <csignal>

namespace rigor {

/// While this object exists, the first SIGINT, SIGTERM or SIGHUP requests an orderly end instead of ending
/// the process; the second one ends it. Only one object may exist at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  ~InterruptWatch();

  bool is_requested() const;
  /// Whether it was requested this long ago.
  bool is_requested_since(std::chrono::milliseconds time) const;

 private:
  struct sigaction previous_[3];
};

/// Pages and pictures are made of the whole run at its end. So long after a signal those of a short run are
/// still finished; longer ones are given up, so that the program ends when it is asked to.
inline constexpr std::chrono::milliseconds grace_of_writing{400};

}  // namespace rigor
