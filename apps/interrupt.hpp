#pragma once

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

 private:
  struct sigaction previous_[3];
};

}  // namespace rigor
