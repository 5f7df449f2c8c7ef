#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/contact_motion.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace rigor {

/// Of so many contacts bold searches without a start begin in the interior of the cones: what a few of them
/// do is guessed sooner otherwise.
inline constexpr std::size_t kFewestInside = 48;

struct ProximalPointOptions {
  /// Residual at which the search ends.
  double wanted = 1e-13;
  /// Largest residual that counts as solved, where the search gets no farther.
  double enough = 1e-10;
  /// What b is known to [its unit]: where contacts contradict each other, b may be changed by so much.
  double resolution = 0;
  /// Whether the best that was found is given where nothing solves the problem; `converged` is false then.
  bool gives_best = false;
  /// Whether Newton's method begins with a moderate c and long steps, and ends early: two times as fast where
  /// many contacts share loads, but what it finds of several solutions need not be as symmetric as the
  /// problem.
  bool is_bold = false;
  /// Whether `start` is near the solution: the points then begin with a large ρ.
  bool is_near = false;
  /// Forces to begin with (3n); none: 0.
  VecX start = VecX();
};

/// Coulomb's law by proximal points, with a non-smooth Newton method inside. From forces λ⁰ the next ones λ
/// solve the law of contacts that give way a little,
///
///   w = A λ + b + (λ - λ⁰) / ρ,
///
/// a problem with one regular matrix however redundant the contacts are: with Alart and Curnier's functions
/// P_n(x) = max(0, x_n) and P_t(x) = the point of the disk of radius μ P_n nearest to x_t it is
///
///   λ = P(λ - c w),  M v = Lᵀ λ,  w = L v + b + (λ - λ⁰) / ρ
///
/// for the motion v and the forces λ (A = L M⁻¹ Lᵀ), with any c > 0, solved by Newton's method with a search
/// along its line: with c = ρ, when λ⁰ and v alone decide, or if `is_bold` first with a moderate c, since the
/// forces of a point then begin the next one. Slip directions are unknowns in it, so none is held from step
/// to step. ρ grows; where a problem is not solved it shrinks.
///
/// λ is the exact solution of the law with b' = b + (λ - λ⁰) / ρ. Contacts that contradict each other (no
/// forces make them hold, nor do they quite let go) show as a b' that stays as far from b, while forces that
/// do nothing grow from point to point. If that is no farther than b is known, λ is the answer, and
/// `residual` that of the law with b'. Of the shares of redundant contacts any may result.
///
/// Sources: Alart and Curnier, A Mixed Formulation for Frictional Contact Problems Prone to Newton Like
/// Solution Methods, 1991; Acary, Brémond and Huber, On Solving Contact Problems with Coulomb Friction:
/// Formulations and Numerical Comparisons, 2018 (proximal points around such a method). What
/// to do about contradictions is our own.
///
/// `laws`: of which A is not read. size_of(λ): the largest of the terms that w is summed from. Nothing if
/// neither residual came to `enough` (but for `gives_best`).
std::optional<CoulombSolution> solve_by_proximal_points(const CoulombProblem& laws,
                                                        const ContactMotion& motion,
                                                        const std::function<double(const VecX&)>& size_of,
                                                        const ProximalPointOptions& options);

}  // namespace rigor
