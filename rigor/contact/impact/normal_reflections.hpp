#pragma once

#include "rigor/contact/impact/impact_problem.hpp"
#include "rigor/solver/linear/least_norm.hpp"

#include <map>
#include <optional>
#include <vector>

namespace rigor {

/// Reflections about the contacts that approach, without friction, until none does: each stops them,
/// 0 ≤ z ⊥ (u + A z)_n ≥ 0, and takes 2 z, which keeps the energy.
///
/// Contacts that approach and do not act on one another stop by themselves, so that a reflection is a few
/// small problems. In a wave through a stack or a wall the same groups approach again and again: what stops
/// all contacts of a group together, the impulses of least norm, is factored once.
class NormalReflections {
 public:
  /// Holds a reference to the problem.
  explicit NormalReflections(const ImpactProblem& problem);

  /// The sum of the reflections' impulses, 3n.
  VecX run();

 private:
  using Group = std::vector<std::size_t>;

  std::vector<Group> groups_of(const Group& approaching) const;
  std::optional<VecX> stop(const Group& group);
  std::optional<VecX> hold_all(const Group& group, const VecX& u);
  MatX response_within(const Group& group) const;
  void add(std::size_t contact, double impulse);

  const ImpactProblem& problem_;
  std::vector<std::vector<DelassusOperator::Coupling>> couplings_;
  VecX lambda_;                            ///< Normal impulses so far, n.
  VecX u_;                                 ///< Normal velocities now, n.
  std::map<Group, LeastNormSystem> held_;  ///< Groups that have stopped before.
};

}  // namespace rigor
