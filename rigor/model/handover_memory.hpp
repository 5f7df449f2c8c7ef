#pragma once

namespace rigor {

/// What `scheme: auto` remembers of a run that it may hand over between events and fixed steps
/// (rigor/sim/handover). Part of the State, so that a fresh stepper continues bit for bit.
struct HandoverMemory {
  /// Who carries the bodies: events; exact steps, whatever they cost or until time pays for them; soft steps.
  enum class Carrier { events, steps, soft_steps };
  Carrier carrier = Carrier::events;
  double owed = 0;   ///< Work that events have cost beyond what simulated time pays for (WorkBudget).
  double price = 0;  ///< Work of one event, as it was when steps took over.
  /// Operations that exact steps have taken beyond what simulated time pays for (AdvanceReport::step_work).
  double owed_by_steps = 0;
  double soft_step = 0;  ///< Longest soft step [s]; 0: they do not carry the bodies.

  bool operator==(const HandoverMemory& other) const = default;
};

}  // namespace rigor
