#pragma once

namespace rigor {

/// What `scheme: auto` remembers of a run that it may hand over between events and fixed steps
/// (rigor/sim/handover). Part of the State, so that a fresh stepper continues bit for bit.
struct HandoverMemory {
  bool is_in_steps = false;  ///< Fixed steps carry the bodies.
  double owed = 0;           ///< Work that events have cost beyond what simulated time pays for (EffortDebt).
  double price = 0;          ///< Work of one event, as it was when steps took over.

  bool operator==(const HandoverMemory& other) const = default;
};

}  // namespace rigor
