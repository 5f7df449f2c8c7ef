#include "rigor/solver/coulomb_polish.hpp"

#include "rigor/solver/least_norm_slips.hpp"
#include "rigor/solver/smooth_modes.hpp"

#include <set>
#include <utility>

namespace rigor {
namespace {

using Eigen::Index;

// Part of the largest term below which a w counts as zero, and a sign as undecided.
constexpr double kZero = 1e-13;
constexpr int kMaxMoves = 5;

class Polisher {
 public:
  Polisher(const CoulombProblem& problem, double tolerance) : problem_(problem), tolerance_(tolerance) {}

  CoulombSolution run(CoulombGuess guess) {
    CoulombSolution best =
        make_solution(problem_, clamp_to_cones(problem_, guess.lambda), guess.modes.modes, tolerance_);
    std::set<std::vector<ContactMode>> visited;
    for (int move = 0; move < kMaxMoves && visited.insert(guess.modes.modes).second; ++move) {
      const CoulombSolution candidate = solve_modes(guess);
      if (candidate.residual < best.residual) best = candidate;
      if (best.residual <= kZero) break;
      move_contacts(guess);
    }
    return best.converged ? with_least_norm(best) : best;
  }

 private:
  bool has_turning_slips(const CoulombGuess& guess) const {
    for (std::size_t k = 0; k < problem_.mu.size(); ++k)
      if (guess.modes.modes[k] == ContactMode::slide && problem_.rows[k] == FrictionRow::cone &&
          problem_.mu[k] > 0)
        return true;
    return false;
  }

  // Solves the equations of the guess's modes (changes its forces and slips), then looks for forces that do
  // the same and are in the cones.
  CoulombSolution solve_modes(CoulombGuess& guess) const {
    const std::vector<ContactMode>& modes = guess.modes.modes;
    const bool turning = has_turning_slips(guess);
    if (turning) guess = solve_smooth_modes(problem_, std::move(guess));
    const auto solution_of = [&](const VecX& forces) {
      return make_solution(problem_, clamp_to_cones(problem_, forces), modes, tolerance_);
    };
    if (turning) {
      const CoulombSolution smooth = solution_of(guess.lambda);
      if (smooth.residual <= kZero) return smooth;
    }
    const KnownModesSystem system(problem_, guess.modes);
    if (!turning) guess.lambda = system.solve_near(guess.lambda);
    CoulombSolution best = solution_of(guess.lambda);
    if (best.residual <= kZero || system.is_regular()) return best;
    const std::optional<VecX> forces = system.find_in_cones();
    if (!forces) return best;
    CoulombSolution shifted = solution_of(*forces);
    return shifted.residual < best.residual ? shifted : best;
  }

  // The solution with the forces of least norm: every contact with w_n = 0 may push, every one with w = 0 may
  // stick.
  CoulombSolution with_least_norm(const CoulombSolution& solution) const {
    const ContactModes face = modes_of_motion(solution);
    const double accepted = std::max(kZero, 4 * solution.residual);
    const std::optional<CoulombSolution> least = find_least_norm(problem_, face, accepted);
    if (least) return *least;
    CoulombSolution result = solution;
    result.modes = face.modes;
    return result;
  }

  // A slip direction is that of the friction force, which is known better than that of a slow w.
  ContactModes modes_of_motion(const CoulombSolution& solution) const {
    ContactModes face = open_guess(problem_).modes;
    const double zero = kZero * largest_term(problem_, solution.lambda);
    for (std::size_t k = 0; k < face.modes.size(); ++k) {
      const Vec3 w = solution.w.segment<3>(3 * static_cast<Index>(k));
      const Vec3 force = solution.lambda.segment<3>(3 * static_cast<Index>(k));
      if (w(2) > zero) continue;
      const double speed = w.head<2>().norm();
      const bool may_stick = problem_.rows[k] == FrictionRow::cone && problem_.mu[k] > 0;
      face.modes[k] = may_stick && speed <= zero ? ContactMode::stick : ContactMode::slide;
      if (may_stick && speed > zero) face.slips[k] = slip_of_force(force, w.head<2>() / speed);
    }
    return face;
  }

  // Contacts that pull open; open ones that sink close; backward slides stick; sticks outside the cone slide.
  void move_contacts(CoulombGuess& guess) const {
    const VecX w = problem_.A * guess.lambda + problem_.b;
    const double zero = kZero * largest_term(problem_, guess.lambda);
    for (std::size_t k = 0; k < problem_.mu.size(); ++k) {
      const Index row = 3 * static_cast<Index>(k);
      const Vec3 force = guess.lambda.segment<3>(row);
      const double mu = problem_.mu[k];
      const double stiffness = problem_.A.diagonal().segment<3>(row).mean();
      const bool may_stick = problem_.rows[k] == FrictionRow::cone && mu > 0;
      ContactMode& mode = guess.modes.modes[k];
      if (mode == ContactMode::open) {
        if (w(row + 2) < -zero) mode = may_stick ? ContactMode::stick : ContactMode::slide;
      } else if (stiffness * force(2) < -zero) {
        mode = ContactMode::open;
      } else if (mode == ContactMode::slide) {
        const bool backward = guess.modes.slips[k].dot(w.segment<2>(row)) < -zero;
        if (may_stick && backward) mode = ContactMode::stick;
      } else if (stiffness * (force.head<2>().norm() - mu * force(2)) > zero) {
        mode = ContactMode::slide;
        guess.modes.slips[k] = slip_of_force(force, guess.modes.slips[k]);
      }
    }
  }

  const CoulombProblem& problem_;
  double tolerance_;
};

}  // namespace

CoulombSolution polish_coulomb(const CoulombProblem& problem, const CoulombGuess& guess, double tolerance) {
  return Polisher(problem, tolerance).run(guess);
}

}  // namespace rigor
