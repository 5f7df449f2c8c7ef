#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/executor.hpp"
#include "rigor/bulk/graph_colouring.hpp"
#include "rigor/bulk/manifold_blocks.hpp"
#include "rigor/bulk/narrow_phase.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <vector>

namespace rigor {

/// All contacts of a step as blocks of eight, by colours.
class BulkContacts {
 public:
  explicit BulkContacts(const Model& model);

  /// At the begin of a step of substeps of h [s]. memory: of the contacts of the step before, in the order of
  /// keys.
  void prepare(const BulkBodies& bodies, double h, const std::vector<ShapePair>& pairs,
               const std::vector<PairManifold>& manifolds, const std::vector<ManifoldMemory>& memory,
               const Executor& executor);
  /// Applies the impulses that the blocks begin with; once, in the first substep.
  void warm_start(BulkBodies& bodies, const Executor& executor);
  /// One sweep over all colours. h [s]: of the substep.
  void solve(BlockPass pass, float h, BulkBodies& bodies, const Executor& executor);
  bool has_restitution() const { return has_restitution_; }
  /// What the contacts remember, in the order of keys.
  void remember(std::vector<ManifoldMemory>& memory) const;

 private:
  template <class Work>
  void for_blocks(const Executor& executor, const Work& work);

  const Model* model_;
  LaneTarget target_ = best_lane_target();
  std::vector<ManifoldSurface> surfaces_;  ///< Of two materials, by first * count + second.
  GraphColouring colouring_;
  std::vector<ManifoldBlock> blocks_;
  std::vector<ManifoldMemory> keys_;  ///< Of the manifolds of this step; their impulses are in the blocks.
  std::vector<ConstraintEdge> edges_;
  std::vector<const ManifoldMemory*> found_;
  bool has_restitution_ = false;
};

}  // namespace rigor
