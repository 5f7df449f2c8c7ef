#include "rigor/geometry/broad_phase/broad_phase.hpp"

#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/geometry/broad_phase/sweep_and_prune.hpp"

namespace rigor {

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseMethod method) {
  if (method == BroadPhaseMethod::tree) return std::make_unique<AabbTree>();
  return std::make_unique<SweepAndPrune>();
}

}  // namespace rigor
