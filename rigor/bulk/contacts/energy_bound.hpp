#pragma once

#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/contacts/common_motion.hpp"
#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/dynamics/body_phase.hpp"
#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// Contacts take energy and never give any, but a few sweeps solve them approximately: impulses of an impact
/// with which the next substep begins, arms that a step holds while bodies turn, and overlaps that are put
/// back may add some. So each island is asked at the end of a step: with E its kinetic energy and what its
/// springs hold, less the work of forces, E(end) - E(begin) is taken: from springs that hold what nothing
/// paid for, then from the impulses of its contacts, all in one part, and what is left from the motion of its
/// bodies against each other (of an island that something fixed has pressed, against that), in equal parts,
/// which leaves its momenta as they are. Where all of its motion does not pay for what overlaps that are put
/// back have lifted, its bodies go back along their ways until it does. Islands with springs, motors or
/// moving kinematic bodies, whose work is not known, are left alone.
class EnergyBound {
 public:
  explicit EnergyBound(const Model& model);

  /// After gravity of the Model has changed; after other parts of it have.
  void set_gravity();
  void change(const ChangedBodies& changed);

  /// At the beginning of a step.
  void begin(const BulkBodies& bodies, const Executor& executor);
  /// Before the bodies are moved to the end of the step: the work of its forces, which are these
  /// accelerations.
  void add_work(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations,
                const Executor& executor);
  /// At the end of a step, with its contacts and what is remembered of them.
  void hold(BulkContacts& contacts, const Executor& executor, ManifoldMemories& memory, BulkBodies& bodies);

 private:
  void find_lift(int body);
  void find_tied();
  struct IslandGain {
    double gain = 0;    ///< E(end) - E(begin) [J].
    double scale = 0;   ///< Of the energies of which it is a difference [J].
    double stored = 0;  ///< What springs have come to hold, those that gave back aside [J].
    bool is_known = true, is_pressed = false;
    std::vector<int> bodies;
  };
  bool find_gains(const StepManifolds& manifolds, const ManifoldMemories& memory, const BulkBodies& bodies,
                  const Executor& executor);
  bool is_taken(const IslandGain& island) const;
  int island_of(const StepManifolds& manifolds, std::size_t i, const BulkBodies& bodies) const;
  void find_islands(const BulkContacts& contacts, const ManifoldMemories& memory, const BulkBodies& bodies);
  void empty_springs(const StepManifolds& manifolds, ManifoldMemories& memory, const BulkBodies& bodies);
  void lessen_impulses(BulkContacts& contacts, BulkBodies& bodies);
  double energy_against(const CommonMotion& common, const IslandGain& island, const BulkBodies& bodies) const;
  void calm(const IslandGain& island, BulkBodies& bodies) const;
  void go_back(const IslandGain& island, double rest, BulkBodies& bodies) const;

  const Model* model_;
  BulkIslands islands_;
  std::vector<char> is_unknown_;                ///< Bodies whose work is not known.
  std::vector<char> is_anchored_, is_jointed_;  ///< Bodies that joints tie to something fixed, or to others.
  std::vector<double> lift_;                    ///< Of bodies: what is nothing to them at rest [J].
  std::vector<double> begin_;  ///< Of bodies: kinetic energy at the beginning, then with the work [J].
  std::vector<double> work_;   ///< Of bodies: the work of their forces in the step [J].
  std::vector<double> gain_;   ///< Of bodies: kinetic energy that nothing explains [J].
  std::vector<IslandGain> gains_;
  std::vector<int> gain_at_;      ///< Index in gains_ of the island of which a body is the lowest; -1: none.
  std::vector<Wrench> given_;     ///< What contacts have given each body in the step.
  std::vector<float> lost_part_;  ///< Of the impulses on each body.
};

}  // namespace rigor
