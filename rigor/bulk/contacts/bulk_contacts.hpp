#pragma once

#include "rigor/bulk/contacts/solved_manifold.hpp"
#include "rigor/bulk/direct/direct_islands.hpp"
#include "rigor/bulk/graph/block_lists.hpp"
#include "rigor/bulk/graph/cached_colouring.hpp"
#include "rigor/bulk/matching/manifold_blocks.hpp"
#include "rigor/bulk/matching/step_manifolds.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/held_bodies.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// All contacts of a step as blocks of eight, by colours.
class BulkContacts {
 public:
  explicit BulkContacts(const Model& model);

  /// After a body of the Model has changed.
  void set_body(const Model& model, int body);
  /// After its materials have changed.
  void set_surfaces(const Model& model) { manifolds_.set_surfaces(model); }

  /// At the beginning of a step: which manifolds there are and what is remembered of them
  /// (StepManifolds::match).
  void match(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
             const ManifoldMemories& memory, const Executor& executor);
  const StepManifolds& manifolds() const { return manifolds_; }
  /// Then: which of them are solved at once. bodies: which are dynamic.
  void colour(const BulkBodies& bodies);
  /// Then: blocks of the manifolds, but for those of the islands that were solved directly. h [s]: of the
  /// substeps; whole [s]: of those to which the springs belong.
  void prepare(const BulkBodies& bodies, double h, double whole, const DirectIslands& direct,
               const Executor& executor);
  /// Applies the impulses that the blocks begin with; once, in the first substep.
  void warm_start(BulkBodies& bodies, const Executor& executor);
  /// One sweep over all colours. h [s]: of the substep.
  void solve(BlockPass pass, float h, BulkBodies& bodies, const Executor& executor);
  bool has_restitution() const { return has_restitution_; }
  /// Adds the impulses of a substep to those of the step; after the last sweep of each substep, if the totals
  /// are wanted.
  void add_up(const Executor& executor);
  /// Whether they were added up in this step: then memories have the energies of their springs.
  bool keeps_energy() const { return blocks_.has_totals(); }
  /// After the last substep, if has_restitution() and the impulses were added up: which contacts bounce, and
  /// how much energy each may give back; whether there are any.
  bool find_bounces(const std::vector<MotionRow>& accelerations, const BulkBodies& bodies,
                    const Executor& executor);
  /// Then lets them bounce (manifold_bounce.hpp).
  void bounce_apart(const Model& model, const std::vector<MotionRow>& accelerations, HeldBodies& held,
                    BulkBodies& bodies, const Executor& executor);
  /// Takes part(body_A, body_B) of the sums of each manifold's impulses away.
  template <class Part>
  void lessen(const Part& part) {
    blocks_.for_totals(0, blocks_.count(), [&](const auto& block, auto& total, int number) {
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
        if (manifold_of(number, static_cast<int>(lane)) < 0) continue;
        const float kept = 1 - part(block.body_A[lane], block.body_B[lane]);
        for (std::size_t k = 0; k < total.rows; ++k) total.row[k][lane] *= kept;
      }
    });
  }
  /// Adds impulses to the sums of a manifold. It remembers no more of the last substep than the part of it
  /// that has a normal impulse of `kept` [N s].
  void add(std::size_t manifold, const ManifoldImpulses& impulses, double kept);
  /// What the contacts remember, in the order of keys; the energy of their springs if the impulses were added
  /// up. h [s]: of a substep.
  void remember(const BulkBodies& bodies, double h, int substeps, const Executor& executor,
                ManifoldMemories& memory);

  /// Calls visit(manifold, number) for each manifold of the step, in the order of blocks, if impulses were
  /// added up. number: its own among manifolds().
  template <class Visit>
  void for_contacts(const Visit& visit) const {
    for_contacts([](int, int, bool, bool) { return true; }, visit);
  }
  /// The same for those of which is_wanted(body_A, body_B, is_new, is_pressed): the others are not read.
  /// is_new: it had no impulse at the end of the step before; is_pressed: it had one in this step.
  template <class IsWanted, class Visit>
  void for_contacts(const IsWanted& is_wanted, const Visit& visit) const {
    if (!blocks_.has_totals()) return;
    blocks_.for_totals(0, blocks_.count(), [&](const auto& block, const auto& total, int number) {
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int manifold = manifold_of(number, lane);
        if (manifold < 0) continue;
        const std::size_t i = at(manifold);
        unsigned pressed = 0;
        for (const std::uint8_t of_point : block.pressed) pressed |= of_point;
        const bool is_pressed = (pressed >> lane & 1) != 0;
        if (is_wanted(manifolds_.body_A(i), manifolds_.body_B(i), manifolds_.is_new(i), is_pressed))
          visit(read(block, total, lane, i), i);
      }
    });
  }
  /// Calls visit(body_A, body_B, most) for each manifold that bounces, in the order of blocks. most: the
  /// energy that it may give back [J], which may be changed.
  template <class Visit>
  void for_bounces(const Visit& visit) {
    blocks_.for_blocks(0, static_cast<int>(bounces_.size()), [&](const auto& block, int number) {
      BlockBounces& bounces = bounces_[at(number)];
      for (std::size_t lane = 0; bounces.does_any && lane < kLaneCount; ++lane) {
        if (bounces.most[lane] > 0) visit(block.body_A[lane], block.body_B[lane], bounces.most[lane]);
      }
    });
  }

 private:
  struct BlockBounces {
    bool does_any = false;
    std::array<double, kLaneCount> most{};  ///< Of each lane [J].
  };
  template <class IsSwept>
  void colour_those(const BulkBodies& bodies, const IsSwept& is_swept);
  /// Colour after colour.
  template <class Work>
  void for_colours(const Executor& executor, const Work& work);
  /// Number of the manifold in a lane of a block, -1 if it is empty.
  int manifold_of(int block, int lane) const { return colouring_.now().blocks[at(block)][at(lane)]; }
  template <BlockKind kind>
  SolvedManifold read(const ManifoldBlock<kind>& block, const BlockImpulses<kind>& total, int lane,
                      std::size_t manifold) const {
    SolvedManifold own = read_manifold(block, total, lane);
    set_surface(manifolds_.surface(manifold), own);
    return own;
  }

  LaneTarget target_ = best_lane_target();
  std::vector<bool> is_round_;  ///< Of bodies: their inertia is the same about all axes, or infinite.
  StepManifolds manifolds_;
  CachedColouring colouring_;  ///< Of the manifolds in blocks, by their numbers.
  BlockLists blocks_;
  std::vector<BlockBounces> bounces_;  ///< Of each block, after find_bounces().
  std::vector<float> kept_;            ///< By manifold: add(); empty if all are remembered.
  bool has_restitution_ = false;
  bool is_all_swept_ = true;  ///< No manifold was left to the direct solver.
};

}  // namespace rigor
