#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"

namespace rigor {

/// The pyramid that approximates the friction cone: `directions` vectors d_j at equal angles in the tangent
/// plane of the contact, the first at `first_angle` [rad] from t1.
struct FrictionPyramid {
  int directions = 4;  ///< Even, at least 4: each has its opposite.
  double first_angle = 0;
};

/// A CoulombProblem with pyramids in place of its cones: a linear complementarity problem for the normal
/// forces c, the forces β along the directions and the slip speeds s,
///
///   0 ≤ c ⊥ w_n ≥ 0,   0 ≤ β ⊥ Dᵀ w_t + e s ≥ 0,   0 ≤ s ⊥ μ c - eᵀ β ≥ 0,   λ_t = D β.
///
/// Solved by Lemke's method; the matrix is copositive, so there is always a solution. What it gives up is
/// isotropy: friction acts along the direction nearest to the opposite of the slip, wrong by up to π /
/// directions, and its power is too small by a factor of down to cos(π / directions). The time grows with the
/// cube of the number of contacts times directions. `residual` is that of the complementarity problem; the
/// modes describe λ and w.
///
/// Source: Stewart and Trinkle, An implicit time-stepping scheme for rigid body dynamics with inelastic
/// collisions and Coulomb friction, Int. J. Numer. Methods Eng. 39, 1996.
CoulombSolution solve_pyramids(const CoulombProblem& problem, const FrictionPyramid& pyramid = {});

}  // namespace rigor
