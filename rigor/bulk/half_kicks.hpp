#pragma once

#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"
#include "rigor/bulk/joints/bulk_joints.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"

#include <vector>

namespace rigor {

/// What touches nothing is stepped to the second order in the substep, by the method of Verlet (leapfrog):
/// between the substeps of a step its velocity is that of half a substep before, so that the kicks by which
/// forces begin substeps are in the middle of its displacements. Contacts need velocities at the ends of
/// substeps, so bodies that touch something have none of this; nor have those on which springs or laws of
/// joints other than limits act, whose forces are those of whole substeps. Derivation: section 1 of
/// docs/theory/bulk_joints.md.
class HalfKicks {
 public:
  /// Before a step, finds what flies among the bodies that move and that no contact-free chain has.
  /// `touches`, by body: whether it may touch another, or a spring holds it.
  void find(const std::vector<int>& moving, const std::vector<char>& touches, const BulkBodies& bodies,
            BulkJoints& joints);
  /// What acts in substeps of h [s]: forces, and gyroscopic torques.
  struct Kick {
    float h;
    const std::vector<MotionRow>& accelerations;  ///< By body.
    const GyroscopicTerms& gyroscopic_terms;      ///< Prepared for the step.
    std::vector<MotionRow>& turns;                ///< Room for what these change.
  };
  /// Before the first substep: velocities go back by half of one.
  void begin(const Kick& kick, BulkJoints& joints, const Executor& executor, BulkBodies& bodies) const;
  /// After the last one: velocities are those of the end of the step.
  void end(const Kick& kick, BulkJoints& joints, const Executor& executor, BulkBodies& bodies) const;

 private:
  void take_part(float part, const Kick& kick, const Executor& executor, BulkBodies& bodies) const;

  std::vector<char> flies_;  ///< Each body.
  std::vector<int> flying_;  ///< Bodies, ascending.
};

}  // namespace rigor
