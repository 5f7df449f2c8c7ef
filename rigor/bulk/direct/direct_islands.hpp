#pragma once

#include "rigor/bulk/direct/slender_towers.hpp"
#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/matching/step_manifolds.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/bulk_contact.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/core/index.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace rigor {

struct DirectProblem;

/// What DirectIslands need to know of a step.
struct DirectStep {
  double h;                                   ///< Of the whole step [s].
  int substeps;                               ///< Remembered impulses are those of one of them.
  const StepManifolds& manifolds;             ///< In the order of keys.
  std::function<MotionRow(int)> free_change;  ///< Of a body's velocity within the step, without contacts.
};

/// Islands that sweeps cannot hold. Where heavy bodies rest on light ones, sweeps bring the weight to the
/// ground only after about (height × ratio) of them, and the stack comes down meanwhile; a slender tower
/// buckles on the springs of its contacts. So the contacts of such an island are solved exactly, in 64 bits,
/// once a step: velocities that Coulomb's law allows at its end (Moreau's step, docs/theory/bulk.md, section
/// 6), and displacements with them.
///
/// It takes islands of at most 64 bodies with masses that differ by a factor of ten, and SlenderTowers each
/// of whose bodies touches at most two others: those without joints, springs, rolling and torsional friction,
/// moving kinematic bodies, and without a bounce in this step.
class DirectIslands {
 public:
  explicit DirectIslands(const Model& model);

  /// After gravity of the Model has changed; after other parts of it have.
  void set_gravity() { towers_.set_gravity(*model_); }
  void change(const ChangedBodies& changed);

  /// Whether islands may be taken: masses differ so much, or there are slender towers. memory: of the step
  /// before; substep [s].
  bool may_be_needed(const ManifoldMemories& memory, double substep);
  /// Forgets the islands: none is solved in this step.
  void clear();
  /// Finds the islands that are to be solved.
  void find(const StepManifolds& manifolds, const BulkBodies& bodies);
  bool has_found_any() const { return !found_.empty(); }
  /// Solves those of them that can be: their bodies get the velocities of their displacements in the step.
  void solve(const DirectStep& step, BulkBodies& bodies);
  /// Whether a body was in a solved island: then nothing else may change its velocity in this step.
  bool holds(int body) const { return !is_held_.empty() && is_held_[at(body)]; }
  /// The number of islands that were solved.
  int island_count() const { return island_count_; }
  /// Gives the bodies their velocities at the end of the step.
  void finish(BulkBodies& bodies) const;
  /// The contacts of the solved islands, with their impulses.
  const std::vector<BulkContact>& contacts() const { return contacts_; }
  /// The number of the manifold of one of them among those of the step.
  std::size_t manifold_of(std::size_t contact) const { return solved_[contact].manifold; }
  /// Writes impulses of one substep into the memories of their manifolds, where they last, and what is left
  /// of the energy of their overlaps, if there is room for it; memory: of all manifolds, in the order of
  /// find().
  void remember(int substeps, bool keeps_energy, ManifoldMemories& memory) const;

 private:
  struct Island {
    std::vector<int> bodies;             ///< Dynamic ones, ascending.
    std::vector<std::size_t> manifolds;  ///< Ascending.
    bool is_heavy_on_light = false;
  };
  /// Islands that are small enough, and have masses that differ or may be a slender tower.
  std::vector<Island> find_islands(const StepManifolds& manifolds, const BulkBodies& bodies);
  bool is_taken(const StepManifolds& manifolds, const Island& island, const BulkBodies& bodies) const;
  bool is_column(const StepManifolds& manifolds, const Island& island, const BulkBodies& bodies) const;
  DirectProblem problem_of(const DirectStep& step, const Island& island, const BulkBodies& bodies) const;
  static VecX find_push(DirectProblem& problem, double h, const VecX& V_end);
  double lasting_part(const DirectProblem& problem, const Island& island, const VecX& V_end) const;
  double size_of(const Island& island) const;
  bool solve_island(const DirectStep& step, const Island& island, BulkBodies& bodies);

  void compare_masses();
  void find_tied();

  const Model* model_;
  std::vector<double> masses_;  ///< [kg]; 0 of those that are not dynamic.
  bool masses_differ_ = false;  ///< Whether a heavy body may come to rest on a light one at all.
  SlenderTowers towers_;
  std::vector<bool> is_tied_;  ///< Bodies with joints or springs.
  BulkIslands islands_;
  std::vector<Island> found_;
  std::vector<bool> is_held_;
  int island_count_ = 0;
  struct EndVelocity {
    int body;
    float v[3], w[3];
  };
  std::vector<EndVelocity> ends_;
  struct Solved {
    std::size_t manifold;  ///< Its number.
    double lasting;        ///< The part of its impulses with which the next step may begin.
    float energy;          ///< That its overlap holds [J].
  };
  std::vector<Solved> solved_;         ///< The manifolds of solved islands.
  std::vector<BulkContact> contacts_;  ///< Of those.
};

}  // namespace rigor
