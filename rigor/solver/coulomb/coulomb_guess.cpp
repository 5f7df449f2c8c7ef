#include "rigor/solver/coulomb/coulomb_guess.hpp"

#include "rigor/solver/coulomb/cone.hpp"

namespace rigor {

Vec2 slip_of_force(const Vec3& lambda, const Vec2& fallback) {
  const double friction = lambda.head<2>().norm();
  return friction > 0 ? Vec2(-lambda.head<2>() / friction) : fallback;
}

bool has_unknown_slips(const CoulombProblem& laws, const ContactModes& modes) {
  for (std::size_t k = 0; k < laws.mu.size(); ++k) {
    if (modes.modes[k] == ContactMode::slide && laws.rows[k] == FrictionRow::cone && laws.mu[k] > 0)
      return true;
  }
  return false;
}

CoulombGuess open_guess(const CoulombProblem& problem) {
  CoulombGuess guess;
  guess.lambda = VecX::Zero(problem.b.size());
  guess.modes.modes.assign(problem.mu.size(), ContactMode::open);
  guess.modes.slips.assign(problem.mu.size(), Vec2::UnitX());
  for (std::size_t i = 0; i < problem.mu.size(); ++i)
    if (problem.rows[i] == FrictionRow::slide) guess.modes.slips[i] = problem.slips[i];
  return guess;
}

CoulombGuess guess_of_forces(const CoulombProblem& problem, const VecX& lambda,
                             const std::vector<ContactMode>& modes) {
  CoulombGuess guess = open_guess(problem);
  guess.lambda = lambda;
  guess.modes.modes = modes;
  for (std::size_t i = 0; i < problem.mu.size(); ++i) {
    const Vec3 force = lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
    if (problem.rows[i] == FrictionRow::cone)
      guess.modes.slips[i] = slip_of_force(force, guess.modes.slips[i]);
  }
  return guess;
}

VecX clamp_to_cones(const CoulombProblem& problem, const VecX& lambda) {
  VecX clamped(lambda.size());
  for (std::size_t i = 0; i < problem.mu.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const Vec3 force = lambda.segment<3>(row);
    const double mu = problem.mu[i];
    if (problem.rows[i] == FrictionRow::cone) {
      clamped.segment<3>(row) = clamp_to_cone(force, mu);
    } else {
      const double normal = std::max(0.0, force(2));
      const Vec2 slip = mu > 0 ? problem.slips[i] : Vec2::Zero();
      clamped.segment<3>(row) << -mu * normal * slip, normal;
    }
  }
  return clamped;
}

CoulombSolution make_solution(const CoulombProblem& problem, const VecX& lambda,
                              const std::vector<ContactMode>& modes, double tolerance) {
  CoulombSolution solution{lambda, problem.A * lambda + problem.b, modes, 0.0, 0, false, ""};
  solution.residual = coulomb_residual(problem, lambda, solution.w);
  solution.converged = solution.residual <= tolerance;
  return solution;
}

}  // namespace rigor
