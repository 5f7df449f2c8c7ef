#pragma once

namespace rigor {

/// How pairs of boxes that overlap are found among many.
enum class BroadPhaseMethod { tree, sweep_and_prune };

}  // namespace rigor
