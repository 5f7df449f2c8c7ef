#pragma once

#include <exception>
#include <functional>

namespace rigor {

/// What poll_interrupt() throws.
class Interrupted : public std::exception {
 public:
  /// "interrupted".
  const char* what() const noexcept override { return "interrupted"; }
};

/// While it lives, poll_interrupt() on this thread asks `interrupt`. Scopes nest: the innermost one is asked.
/// It is the one thing that functions know without being told, so that a search deep below a stepper can be
/// ended without each function on the way having an argument for it (decision 18).
class InterruptScope {
 public:
  /// interrupt must outlive the scope; an empty one is never true.
  explicit InterruptScope(const std::function<bool()>& interrupt);
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

 private:
  const std::function<bool()>* outer_;
};

/// What threads that work for this one ask: each begins with a scope of it, this thread too. They ask one at
/// a time. Valid as long as the scope that this thread is in.
std::function<bool()> shared_interrupt();

/// Throws Interrupted if the interrupt of this thread's scope asks for an end. Every loop whose number of
/// passes the input decides polls; results never depend on it.
void poll_interrupt();

}  // namespace rigor
