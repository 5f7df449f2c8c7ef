#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/contact_measures.hpp"
#include "rigor/bulk/direct_islands.hpp"
#include "rigor/bulk/executor.hpp"
#include "rigor/bulk/graph_colouring.hpp"
#include "rigor/bulk/manifold_blocks.hpp"
#include "rigor/bulk/narrow_phase.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// All contacts of a step as blocks of eight, by colours.
class BulkContacts {
 public:
  explicit BulkContacts(const Model& model);

  /// At the begin of a step: which manifolds there are and what is remembered of them. memory: of the
  /// contacts of the step before, in the order of keys; it is held until prepare(), the others until the next
  /// step.
  void match(const std::vector<ShapePair>& pairs, const std::vector<PairManifold>& manifolds,
             const std::vector<ManifoldMemory>& memory, const Executor& executor);
  /// All of them, until prepare().
  std::vector<StepManifold> manifolds() const;
  /// Whose they are, without impulses; until the next step.
  std::vector<ManifoldMemory> keys() const;
  /// Then: blocks of the manifolds, but for those of the islands that were solved directly. h [s]: of the
  /// substeps.
  void prepare(const BulkBodies& bodies, double h, const DirectIslands& direct, const Executor& executor);
  /// Applies the impulses that the blocks begin with; once, in the first substep.
  void warm_start(BulkBodies& bodies, const Executor& executor);
  /// One sweep over all colours. h [s]: of the substep.
  void solve(BlockPass pass, float h, BulkBodies& bodies, const Executor& executor);
  bool has_restitution() const { return has_restitution_; }
  /// Adds the impulses of a substep to those of the step; after the last sweep of each substep, if the totals
  /// are wanted.
  void add_up(const Executor& executor);
  /// After the last substep, if has_restitution() and the impulses were added up: which contacts bounce, and
  /// how much energy each may give back; whether there are any.
  bool find_bounces(const BulkBodies& bodies, const Executor& executor);
  /// Then lets them bounce (manifold_bounce.hpp).
  void bounce_apart(const Model& model, BulkBodies& bodies, const Executor& executor);
  /// What the contacts remember, in the order of keys; the energy of their springs if the impulses were added
  /// up. h [s]: of a substep.
  void remember(const BulkBodies& bodies, double h, int substeps, const Executor& executor,
                std::vector<ManifoldMemory>& memory) const;

  /// Calls visit(contact, key, is_new) for each manifold of the step, in the order of blocks. is_new: it had
  /// no impulse at the end of the step before.
  struct Contact {
    const ManifoldBlock& block;
    const BlockTotals& totals;
    int lane;
  };
  template <class Visit>
  void for_contacts(const Visit& visit) const {
    for (std::size_t k = 0; k < totals_.size(); ++k) {
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int number = blocks_[k].manifold[static_cast<std::size_t>(lane)];
        if (number < 0) continue;
        const std::size_t i = static_cast<std::size_t>(number);
        visit(Contact{blocks_[k], totals_[k], lane}, key_of(i), matches_[i].is_new);
      }
    }
  }
  /// Calls visit(contact, most) for each manifold that bounces, in the order of blocks. most: the energy that
  /// it may give back [J], which may be changed.
  template <class Visit>
  void for_bounces(const Visit& visit) {
    for (std::size_t k = 0; k < bounces_.size(); ++k) {
      for (int lane = 0; bounces_[k].does_any && lane < kLaneCount; ++lane) {
        double& most = bounces_[k].most[static_cast<std::size_t>(lane)];
        if (most > 0) visit(Contact{blocks_[k], totals_[k], lane}, most);
      }
    }
  }

 private:
  struct BlockBounces {
    bool does_any = false;
    std::array<double, kLaneCount> most{};  ///< Of each lane [J].
  };
  /// What is known of a manifold at the begin of a step.
  struct Match {
    int memory = -1;   ///< Its number among those of the step before; -1: none.
    int surface = 0;   ///< Its number among the surfaces.
    float energy = 0;  ///< Of its springs [J].
    bool is_new = true;
  };
  void match_range(std::size_t begin, std::size_t end);
  int material_of(int body, int shape) const;
  StepManifold manifold_at(std::size_t i) const;
  /// Of a manifold; no impulses.
  ManifoldMemory key_of(std::size_t i) const;
  template <class Work>
  void for_blocks(const Executor& executor, const Work& work);

  std::vector<int> first_shape_;  ///< Of each body.
  std::vector<int> materials_;    ///< Of each shape of all bodies.
  std::size_t material_count_;
  LaneTarget target_ = best_lane_target();
  std::vector<ManifoldSurface> surfaces_;  ///< Of two materials, by first * count + second.
  GraphColouring colouring_;
  std::vector<ManifoldBlock> blocks_;
  const std::vector<ShapePair>* pairs_ = nullptr;
  const std::vector<PairManifold>* manifolds_ = nullptr;
  const std::vector<ManifoldMemory>* memory_ = nullptr;  ///< Of the step before.
  std::vector<Match> matches_;                           ///< Of the manifolds.
  std::vector<int> swept_;                               ///< Which of them are in blocks.
  std::vector<ConstraintEdge> edges_;                    ///< Of those.
  std::vector<BlockTotals> totals_;                      ///< Of each block, if they are wanted.
  std::vector<BlockBounces> bounces_;                    ///< Of each block, after find_bounces().
  bool has_restitution_ = false;
};

}  // namespace rigor
