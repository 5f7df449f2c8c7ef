#pragma once

namespace rigor {

/// The method that finds the pairs of boxes that overlap among many.
enum class BroadPhaseMethod { tree, sweep_and_prune };

}  // namespace rigor
