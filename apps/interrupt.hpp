#pragma once

#include <csignal>

namespace rigor {

/// While this lives, the first SIGINT, SIGTERM or SIGHUP asks for an orderly end instead of ending the
/// process; the second one ends it. One at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  ~InterruptWatch();

  bool is_requested() const;

 private:
  struct sigaction previous_[3];
};

}  // namespace rigor
