#include "rigor/geometry/broad_phase.hpp"

#include "rigor/geometry/aabb_tree.hpp"
#include "rigor/geometry/sweep_and_prune.hpp"

namespace rigor {

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseMethod method) {
  if (method == BroadPhaseMethod::tree) return std::make_unique<AabbTree>();
  return std::make_unique<SweepAndPrune>();
}

}  // namespace rigor
