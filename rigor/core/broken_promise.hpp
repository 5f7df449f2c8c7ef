#pragma once

#include <stdexcept>
#include <string>

namespace rigor {

/// A RIGOR_ASSERT that failed: a defect of the program, never of its input. what() names the place in the
/// source and the condition, "rigor/math/roots.cpp:19: broken promise: lo <= hi". A Stepper reports it as the
/// reason why it stopped; elsewhere it reaches the caller, whose process goes on.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace rigor
