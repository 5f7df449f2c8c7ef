#pragma once

#include "rigor/model/contact_memory.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// What schemes that go from event to event know of a State that they have left, besides the motions: part of
/// the State, so that a fresh stepper continues bit for bit and counts what happens as the old one would.
/// Whoever moves a body otherwise (State::anchor_body) makes the State one that was given. Time stepping
/// keeps the forces of its last step here, from which the solver of the next one begins.
struct EventMemory {
  /// Places in ContactMemory::values: point [m], force on B [N] (0 where it is not known), number of the
  /// mode.
  static constexpr std::size_t point = 0, force = 3, mode = 6;
  static constexpr int mode_count = 4;  ///< Of TouchingPoint::Mode.

  bool is_left = false;                 ///< The bodies are where such a scheme has left them.
  std::vector<ContactMemory> contacts;  ///< Those that last, or had forces in the last step.

  bool operator==(const EventMemory& other) const = default;
};

}  // namespace rigor
