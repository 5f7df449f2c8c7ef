#pragma once

#include "rigor/solver/motion/motion_modes.hpp"

namespace rigor {

/// Forces near a solution of Coulomb's law (3n), by so many sweeps of projected Gauss–Seidel from none,
/// without joints: a contact at a time, all three of its rows with the motion as it is then. What few
/// contacts do shows in fewer operations than by steps of Newton's method. (Source:
/// projected_gauss_seidel.hpp.)
VecX swept_forces(const MotionProblem& problem, int sweeps);

}  // namespace rigor
