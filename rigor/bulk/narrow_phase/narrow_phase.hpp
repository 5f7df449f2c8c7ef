#pragma once

#include "rigor/bulk/narrow_phase/manifold_list.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// Two shapes that may touch within the step; body_A < body_B.
struct ShapePair {
  int body_A, body_B;
  int shape_A, shape_B;  ///< Indices among the shapes of these bodies.
  float margin;          ///< Largest gap of a point that counts [m], >= 0.
};

/// Finds where pairs of shapes touch, in 32 bits relative to the pair: the answers of contact_set up to that
/// rounding, reduced to four points per manifold. It holds what it needs of the Model's shapes; its answers
/// depend on the bodies alone.
class NarrowPhase {
 public:
  explicit NarrowPhase(const Model& model);
  ~NarrowPhase();
  NarrowPhase(const NarrowPhase&) = delete;
  NarrowPhase& operator=(const NarrowPhase&) = delete;

  /// After these bodies of the Model have changed. All shapes that it has seen must be alive still.
  void set_bodies(const Model& model, std::span<const int> bodies);

  /// Finds the manifolds of all pairs that have points, in the order of the pairs (the buffer is cleared
  /// first).
  void find_manifolds(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, const Executor& executor,
                      ManifoldList& manifolds);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace rigor
