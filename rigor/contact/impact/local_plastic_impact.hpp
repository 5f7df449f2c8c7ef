#pragma once

#include "rigor/contact/impact/impact_problem.hpp"

namespace rigor {

/// Coulomb's law with e = 0 on all contacts of the problem, from velocities u (3n), solved where it acts: of
/// many contacts on the bodies about those that approach alone, and on more where others approach then.
///
/// Impulses that solve the law there, with none elsewhere, solve it everywhere as soon as nothing approaches
/// elsewhere: so the answer is as exact as that of all contacts at once, and an impact on a wall costs what
/// it moves. Approach of 1e-10 of the fastest velocity counts as none.
CoulombSolution solve_plastic_where_it_acts(const ImpactProblem& problem, const VecX& u);

}  // namespace rigor
