#pragma once

#include "rigor/bulk/bulk_events.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// What happened in a step.
struct BulkStepReport {
  int parts = 1;           ///< Parts in which the step was taken (PassingGuard::longest_part).
  int pair_count = 0;      ///< Pairs of shapes whose boxes overlap.
  int manifold_count = 0;  ///< Manifolds that have points.
  int point_count = 0;
  int direct_islands = 0;              ///< Islands whose contacts were solved directly.
  int sleeping_count = 0;              ///< Bodies that sleep at the end of the step.
  std::vector<BulkImpact> impacts;     ///< In the order of their bodies.
  Vec3 momentum_error = Vec3::Zero();  ///< See StepBalance [kg m/s].
  /// Momenta of the bodies of the balance, and the impulses on them, that the step has rounded [kg m/s].
  double rounded_momentum = 0;
  double work = 0;                     ///< Work of kinematic bodies, torques and forces fixed in bodies [J].
  double max_overlap = 0;              ///< Deepest overlap at the beginning of the step [m].
  int overlap_A = -1, overlap_B = -1;  ///< Bodies of the deepest overlap.
  double worst_overlap = 0;            ///< The largest share of the thinner body's thickness [m].
  double worst_share = 0;              ///< That share.
  int worst_A = -1, worst_B = -1;      ///< Its bodies.
  double max_joint_error = 0;  ///< Largest joint error at the end of the step [m]: BulkJoints::worst_error.
  int worst_joint = -1;        ///< The joint with that error.
  /// A body whose pose or velocity is not finite at the end of the step, -1: none. Such a world cannot go on.
  int broken_body = -1;

  /// Adds what happened in a later part of the step.
  void add(const BulkStepReport& later);
};

/// A report of a step that has begun: its pairs, their manifolds, and how deep they overlap.
BulkStepReport describe_contacts(const Model& model, const std::vector<ShapePair>& pairs,
                                 const ManifoldList& manifolds);

}  // namespace rigor
