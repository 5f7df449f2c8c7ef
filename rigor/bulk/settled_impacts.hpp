#pragma once

#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/contacts/manifold_impact.hpp"
#include "rigor/bulk/graph/jointed_bodies.hpp"
#include "rigor/bulk/joints/bulk_joints.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/held_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Ends the impacts of a step as Newton's and Coulomb's laws say, together with the joints. Sweeps know the
/// mass of each body alone and begin with what the sweep before has done, so that at the end of a step bodies
/// may part from what they struck faster than they should, and jointed ones, of which joints pull the rest
/// after them, at any speed. For small worlds: each contact that struck is solved with what all bodies, held
/// by their joints, answer to it.
class SettledImpacts {
 public:
  explicit SettledImpacts(const Model& model);
  /// After joints or bodies of the Model have changed.
  void find_jointed() { jointed_.find(*model_); }

  /// Whether a joint holds one of the bodies to others or to the world.
  bool are_jointed(int body_A, int body_B) const {
    return jointed_.contains(body_A) || jointed_.contains(body_B);
  }
  /// What the step was taken with.
  struct Step {
    double substep;                               ///< [s].
    const std::vector<MotionRow>& accelerations;  ///< By forces, of each body.
    const HeldBodies& held;
    const Executor& executor;
  };
  /// After the last substep: bounces of bodies without joints are given. Changes velocities, and what the
  /// contacts have done in the step; of contacts that struck newly, or jointed bodies, the next one begins
  /// with no more than twice what forces press: the rest would throw the bodies that they have stopped.
  void settle(const Step& step, BulkJoints& joints, BulkContacts& contacts, BulkBodies& bodies);

 private:
  struct Struck {
    std::size_t number;  ///< Of the manifold.
    SolvedManifold manifold;
    ImpactAim aim;
    Mat6 K;
    ManifoldImpulses added;
    int group;
    double kept;  ///< Sum of the normal impulses with which the next step may begin [N s].
  };
  void list_struck(const Step& step, const BulkContacts& contacts, const BulkBodies& bodies);
  double impulse_to_keep(const Struck& struck, const Step& step) const;
  void find_groups();
  void settle_group(int group, const Step& step, BulkJoints& joints, BulkBodies& bodies);
  static Vec6 wrench_sizes(const SolvedManifold& manifold, const BulkBodies& bodies);
  void take_back(BulkJoints& joints, BulkBodies& bodies) const;
  void pull_joints(const Struck& struck, const Executor& executor, BulkJoints& joints, BulkBodies& bodies);
  Mat6 find_response(const Struck& struck, const Executor& executor, BulkJoints& joints, BulkBodies& bodies);
  Vec6 try_wrench(const SolvedManifold& manifold, const Vec6& wrench, const Executor& executor,
                  BulkJoints& joints, BulkBodies& bodies);
  bool change_motion(Struck& struck, const std::vector<MotionRow>& accelerations, BulkBodies& bodies) const;
  double kinetic_energy(int group, const BulkBodies& bodies) const;
  void hold_joints(int group, const Executor& executor, BulkJoints& joints, BulkBodies& bodies) const;

  const Model* model_;
  JointedBodies jointed_;
  std::vector<int> group_;  ///< By body: those whose impacts concern each other, by the lowest.
  std::vector<Struck> struck_;
  std::vector<MotionRecord> motion_;  ///< Before joints hold what the impacts change.
};

}  // namespace rigor
