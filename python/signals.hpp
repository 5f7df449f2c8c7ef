#pragma once

#include "binding.hpp"

#include <chrono>

namespace rigor::python {

/// Whether Python wants the call to end (Ctrl-C): asked within long computations, without the lock of the
/// interpreter. Looks twenty times a second at most.
class SignalWatch {
 public:
  bool operator()() {
    constexpr int calls_between = 64;
    if (is_wanted_ || ++calls_ % calls_between != 0) return is_wanted_;
    const auto now = std::chrono::steady_clock::now();
    if (now - looked_ < std::chrono::milliseconds(50)) return false;
    looked_ = now;
    const py::gil_scoped_acquire lock;
    // The error that the signal's handler has raised waits until the call has come back.
    is_wanted_ = PyErr_CheckSignals() != 0;
    return is_wanted_;
  }

 private:
  int calls_ = 0;
  bool is_wanted_ = false;
  std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

/// A call that Ctrl-C can end: it throws Interrupted then, which becomes KeyboardInterrupt.
class InterruptibleCall {
 public:
  explicit InterruptibleCall(Simulation& simulation) : simulation_(simulation) {
    simulation_.set_interrupt(SignalWatch());
  }
  ~InterruptibleCall() { simulation_.set_interrupt({}); }
  InterruptibleCall(const InterruptibleCall&) = delete;
  InterruptibleCall& operator=(const InterruptibleCall&) = delete;

 private:
  Simulation& simulation_;
};

}  // namespace rigor::python
