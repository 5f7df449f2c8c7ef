#include "rigor/solver/coulomb/coulomb_polish.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"
#include "rigor/solver/coulomb/least_norm_slips.hpp"
#include "rigor/solver/coulomb/smooth_modes.hpp"

#include <set>
#include <utility>

namespace rigor {
namespace {

using Eigen::Index;

constexpr double kZero = kZeroMotion;
constexpr int kMaxMoves = 5;

class Polisher {
 public:
  Polisher(const CoulombProblem& problem, double tolerance) : problem_(problem), tolerance_(tolerance) {}

  CoulombSolution run(CoulombGuess guess) {
    CoulombSolution best =
        make_solution(problem_, clamp_to_cones(problem_, guess.lambda), guess.modes.modes, tolerance_);

    // Solve the equations of the modes, check signs and cones, move the contacts that break them: until the
    // law holds to rounding, the modes have been met before or the moves are used up.
    std::set<std::vector<ContactMode>> visited;
    std::size_t released = 0;
    for (int move = 0; move < kMaxMoves && visited.insert(guess.modes.modes).second; ++move) {
      poll_interrupt();
      const CoulombSolution candidate = solve_modes(guess);
      if (candidate.residual < best.residual) best = candidate;
      if (best.residual <= kZero) break;
      const std::vector<ContactMode> before = guess.modes.modes;
      const VecX w = problem_.A * guess.lambda + problem_.b;
      const double zero = kZero * largest_term(problem_, guess.lambda);
      move_contacts(problem_, problem_.A.diagonal(), w, zero, guess);
      // Equations that contradict each other break no sign: then a contact lets go, which is no move.
      if (guess.modes.modes == before && released < problem_.mu.size() && release_worst(w, zero, guess)) {
        ++released;
        --move;
      }
    }
    return best.converged ? with_least_norm(best) : best;
  }

 private:
  /// Redundant contacts whose equations contradict each other by a little cannot all hold: the one with the
  /// largest miss is released. False if all equations hold.
  bool release_worst(const VecX& w, double zero, CoulombGuess& guess) const {
    std::vector<ContactMode>& modes = guess.modes.modes;
    double opening = zero, slipping = zero;
    std::size_t opens = modes.size(), slips = modes.size();
    for (std::size_t k = 0; k < modes.size(); ++k) {
      if (modes[k] == ContactMode::open) continue;
      const Vec3 motion = w.segment<3>(3 * static_cast<Index>(k));
      const double slip = modes[k] == ContactMode::stick ? motion.head<2>().norm() : 0;
      if (motion.z() > opening) opening = motion.z(), opens = k;
      if (slip > slipping) slipping = slip, slips = k;
    }
    if (opens < modes.size() && opening >= slipping) {
      modes[opens] = ContactMode::open;
    } else if (slips < modes.size()) {
      modes[slips] = ContactMode::slide;
      guess.modes.slips[slips] = w.segment<2>(3 * static_cast<Index>(slips)) / slipping;
    } else {
      return false;
    }
    return true;
  }

  // Solves the equations of the guess's modes (changes its forces and slips), then looks for forces that do
  // the same and are in the cones.
  CoulombSolution solve_modes(CoulombGuess& guess) const {
    const std::vector<ContactMode>& modes = guess.modes.modes;
    const bool has_slips = has_unknown_slips(problem_, guess.modes);
    if (has_slips) guess = solve_smooth_modes(problem_, std::move(guess));
    const auto solution_of = [&](const VecX& forces) {
      return make_solution(problem_, clamp_to_cones(problem_, forces), modes, tolerance_);
    };
    if (has_slips) {
      CoulombSolution smooth = solution_of(guess.lambda);
      if (smooth.residual <= kZero) return smooth;
    }

    // Forces for the slips as they are now; where slips were unknowns the forces are those of Newton's
    // method.
    const KnownModesSystem system(problem_, guess.modes);
    if (!has_slips) guess.lambda = system.solve_near(guess.lambda);
    CoulombSolution best = solution_of(guess.lambda);
    if (best.residual <= kZero || system.is_regular()) return best;

    // Redundant contacts: another share of the same load may be in the cones.
    const std::optional<VecX> forces = system.find_in_cones();
    if (!forces) return best;
    CoulombSolution shifted = solution_of(*forces);
    return shifted.residual < best.residual ? shifted : best;
  }

  // The solution with the forces of least norm: every contact with w_n = 0 may push, every one with w = 0 may
  // stick.
  CoulombSolution with_least_norm(const CoulombSolution& solution) const {
    const ContactModes face = modes_of_motion(problem_, solution.lambda, solution.w,
                                              kZero * largest_term(problem_, solution.lambda));
    const double accepted = std::max(kZero, 4 * solution.residual);
    const std::optional<CoulombSolution> least = find_least_norm(problem_, face, accepted);
    if (least) return *least;
    CoulombSolution result = solution;
    result.modes = face.modes;
    return result;
  }

  const CoulombProblem& problem_;
  double tolerance_;
};

}  // namespace

CoulombSolution polish_coulomb(const CoulombProblem& problem, const CoulombGuess& guess, double tolerance) {
  return Polisher(problem, tolerance).run(guess);
}

}  // namespace rigor
