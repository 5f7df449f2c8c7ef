#pragma once

#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"

#include <vector>

namespace rigor {

/// What bounces may give back: at most what the step has taken. Sums over manifolds by the impulses and
/// velocities of a step know its dissipation, rotations and falls within the step aside; so the bodies are
/// asked. With E the kinetic energy of an island less the work of forces and of bodies that move as they
/// must, all bounces of the island get together at most E(begin) - E(now): no step with a bounce ends with
/// more energy than it began.
class BounceLimits {
 public:
  explicit BounceLimits(const Model& model);

  /// After the Model has changed.
  void change(const ChangedBodies& changed) { islands_.change(*model_, changed); }

  /// At the beginning of a step.
  void begin(const BulkBodies& bodies, const Executor& executor);
  /// After the last substep, with the bounces of the contacts found: lessens what they may give back.
  /// accelerations: of the forces in the step.
  void limit(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations, const Executor& executor,
             BulkContacts& contacts);

 private:
  const Model* model_;
  BulkIslands islands_;
  std::vector<double> energies_;  ///< Of bodies: kinetic at the begin, then what they have lost [J].
  std::vector<double> lost_;      ///< By islands, at their lowest body [J].
  std::vector<double> wanted_;    ///< By islands: what their bounces would give back [J].
};

}  // namespace rigor
