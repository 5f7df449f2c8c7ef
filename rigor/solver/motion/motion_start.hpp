#pragma once

#include "rigor/solver/motion/motion_modes.hpp"

#include <optional>

namespace rigor {

/// The problem of solve_in_motion_space from `forces` (3n) of one like it, where any share of the load will
/// do (without options.least_norm): these forces themselves, if they solve it, as those of bodies at rest
/// solve one step after the other, or proximal points from there, if they nearly do. Nothing if they do not
/// (then they are no better than none), nor of few contacts and of unlike masses, where that all hold is
/// found anew.
std::optional<CoulombSolution> solve_from_forces(const MotionProblem& problem, const VecX& forces,
                                                 const CoulombOptions& options);

}  // namespace rigor
