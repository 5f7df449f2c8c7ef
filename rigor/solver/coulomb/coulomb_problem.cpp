#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/solver/coulomb/coulomb_gauss_seidel.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"
#include "rigor/solver/coulomb/coulomb_local.hpp"
#include "rigor/solver/coulomb/coulomb_polish.hpp"
#include "rigor/solver/coulomb/coulomb_proximal.hpp"
#include "rigor/solver/coulomb/coulomb_seed.hpp"
#include "rigor/solver/coulomb/proximal_points.hpp"
#include "rigor/solver/coulomb/smooth_modes.hpp"
#include "rigor/solver/linear/contact_space_motion.hpp"
#include "rigor/solver/linear/lcp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

void check_sizes(const CoulombProblem& problem) {
  const Index n = static_cast<Index>(problem.mu.size());
  RIGOR_ASSERT(problem.A.rows() == 3 * n && problem.A.cols() == 3 * n && problem.b.size() == 3 * n);
  RIGOR_ASSERT(problem.rows.size() == problem.mu.size() && problem.slips.size() == problem.mu.size());
}

bool is_finite(const CoulombProblem& problem) {
  const auto is_number = [](double mu) { return std::isfinite(mu) && mu >= 0; };
  return problem.A.allFinite() && problem.b.allFinite() &&
         std::all_of(problem.mu.begin(), problem.mu.end(), is_number);
}

bool never_approaches(const CoulombProblem& problem) {
  for (std::size_t k = 0; k < problem.mu.size(); ++k)
    if (problem.b(3 * static_cast<Index>(k) + 2) < 0) return false;
  return true;
}

// Whether no contact has to find its slip direction: then it is a linear complementarity problem.
bool is_linear(const CoulombProblem& problem) {
  for (std::size_t k = 0; k < problem.mu.size(); ++k)
    if (problem.mu[k] > 0 && problem.rows[k] == FrictionRow::cone) return false;
  return true;
}

bool is_frictionless(const CoulombProblem& problem) {
  return std::all_of(problem.mu.begin(), problem.mu.end(), [](double mu) { return mu == 0; });
}

int exponent_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

/// The same problem with the largest |A| and |b| in [½, 1), and the powers of two that lead back.
struct ScaledProblem {
  CoulombProblem problem;
  int A_exponent;
  int b_exponent;
};

ScaledProblem scaled(const CoulombProblem& problem) {
  ScaledProblem result{problem, exponent_of(problem.A.cwiseAbs().maxCoeff()),
                       exponent_of(problem.b.cwiseAbs().maxCoeff())};
  result.problem.A *= std::ldexp(1.0, -result.A_exponent);
  result.problem.b *= std::ldexp(1.0, -result.b_exponent);
  return result;
}

void scale_back(const ScaledProblem& scaled, CoulombSolution& solution) {
  solution.lambda *= std::ldexp(1.0, scaled.b_exponent - scaled.A_exponent);
  solution.w *= std::ldexp(1.0, scaled.b_exponent);
}

CoulombSolution labelled(CoulombSolution solution, int iterations, const char* method) {
  solution.iterations = iterations;
  solution.method = method;
  return solution;
}

const char* name_of(LcpName name) {
  return name == LcpName::dantzig ? "dantzig" : "lemke";
}

// The linear complementarity problem of the normal rows alone: w_n = (A_nn - μ A_nt slip) λ_n + b_n.
CoulombSolution solve_linear(const CoulombProblem& problem, LcpName name, double tolerance) {
  CoulombGuess guess = open_guess(problem);
  std::vector<ContactVector> rows, columns;
  VecX q(static_cast<Index>(problem.mu.size()));
  for (Index i = 0; i < q.size(); ++i) {
    const std::size_t k = at(i);
    const double mu = problem.mu[k];
    const Vec2 friction = mu > 0 ? Vec2(-mu * problem.slips[k]) : Vec2::Zero();
    rows.push_back({i, Vec3::UnitZ()});
    columns.push_back({i, Vec3(friction(0), friction(1), 1.0)});
    q(i) = problem.b(3 * i + 2);
  }
  const MatX M = reduce(problem.A, rows, columns);

  // Dantzig's pivoting promises nothing for the unsymmetric M of sliding contacts: Lemke's method then.
  LcpSolution lcp = name == LcpName::dantzig ? lcp_dantzig(M, q) : lcp_lemke(M, q);
  if (!lcp.converged && name == LcpName::dantzig) {
    name = LcpName::lemke;
    lcp = lcp_lemke(M, q);
  }

  // The pivots tell what the contacts do; the polish makes the forces exact.
  for (Index i = 0; i < q.size(); ++i) {
    guess.lambda.segment<3>(3 * i) = lcp.z(i) * columns[at(i)].direction;
    if (lcp.z(i) > 0) guess.modes.modes[at(i)] = ContactMode::slide;
  }
  return labelled(polish_coulomb(problem, guess, tolerance), lcp.pivots, name_of(name));
}

CoulombSolution solve_single(const CoulombProblem& problem, double tolerance) {
  const LocalCoulombSolution local = solve_coulomb_local(problem.A, problem.b, problem.mu[0]);
  CoulombSolution solution = make_solution(problem, local.lambda, {local.mode}, tolerance);
  return labelled(std::move(solution), 1, "one contact");
}

/// Alternates proximal Newton and Gauss–Seidel, polishes each guess and keeps the best point so far.
class Chain {
 public:
  Chain(const CoulombProblem& problem, const CoulombOptions& options, CoulombSolution start)
      : problem_(problem),
        options_(options),
        best_(std::move(start)),
        motion_(problem.A),
        proximal_(problem, motion_, open_guess(problem)),
        gauss_seidel_(problem, open_guess(problem)) {}

  /// What a few proximal steps find.
  CoulombSolution run_briefly() {
    proximal_until(20);
    return best_;
  }

  CoulombSolution run() {
    // A few proximal steps show the modes of most problems; strong friction may need the other method, or
    // many more steps.
    if (proximal_until(20) || is_enough()) return best_;
    constexpr int kFewSweeps = 256;
    if (gauss_seidel_until(std::min(kFewSweeps, options_.max_iterations)) || is_enough()) return best_;
    if (options_.max_iterations <= kFewSweeps) return best_;
    if (proximal_until(100) || is_enough()) return best_;
    gauss_seidel_until(options_.max_iterations);
    return best_;
  }

 private:
  bool is_enough() const { return best_.residual <= options_.enough; }

  bool offer(const CoulombGuess& guess, int iterations, const char* method) {
    if (!guess.lambda.allFinite()) return false;
    CoulombSolution solution = options_.least_norm
                                   ? polish_coulomb(problem_, guess, options_.tolerance)
                                   : make_solution(problem_, clamp_to_cones(problem_, guess.lambda),
                                                   guess.modes.modes, options_.tolerance);
    if (solution.residual < best_.residual) best_ = labelled(std::move(solution), iterations, method);
    return best_.converged;
  }

  // Polishes the first guesses, which solve most problems, then those whose modes have settled, and every
  // eighth step: polishing a wrong guess costs more than many steps.
  bool proximal_until(int last) {
    constexpr int kFirst = 2, kAlways = 8;
    std::vector<ContactMode> before, offered;
    while (proximal_steps_ < last) {
      poll_interrupt();
      proximal_.step();
      ++proximal_steps_;
      const CoulombGuess& guess = proximal_.guess();
      const bool has_settled = guess.modes.modes == std::exchange(before, guess.modes.modes);
      const bool is_due = proximal_steps_ <= kFirst || (has_settled && guess.modes.modes != offered);
      if (!is_due && proximal_steps_ % kAlways != 0) continue;
      offered = guess.modes.modes;
      if (offer(guess, proximal_steps_, "proximal")) return true;
    }
    return false;
  }

  // Polishes after 1, 2, 4, 8, ... sweeps.
  bool gauss_seidel_until(int last) {
    double change = 1;
    while (sweeps_ < last && change > 0) {
      poll_interrupt();
      change = gauss_seidel_.sweep();
      ++sweeps_;
      const bool is_power = (sweeps_ & (sweeps_ - 1)) == 0;
      if ((is_power || sweeps_ == last || change == 0) &&
          offer(gauss_seidel_.guess(), sweeps_, "gauss-seidel"))
        return true;
      if (!gauss_seidel_.guess().lambda.allFinite()) return false;
    }
    return false;
  }

  const CoulombProblem& problem_;
  const CoulombOptions& options_;
  CoulombSolution best_;
  FactoredMotion motion_;
  CoulombProximal proximal_;
  CoulombGaussSeidel gauss_seidel_;
  int proximal_steps_ = 0;
  int sweeps_ = 0;
};

CoulombSolution solve_seeded(const CoulombProblem& problem, LcpName name, double tolerance) {
  const LcpSeed seed = seed_by_lcp(problem, name);
  return labelled(polish_coulomb(problem, seed.guess, tolerance), seed.pivots, name_of(name));
}

bool holds_all(const CoulombSolution& solution) {
  return std::all_of(solution.modes.begin(), solution.modes.end(),
                     [](ContactMode mode) { return mode == ContactMode::stick; });
}

// Coulomb's law can have several solutions. Pivots may end at one that lacks the symmetry of the problem (of
// two points of an edge one lets go); the one of less force has it.
CoulombSolution of_less_force(const CoulombSolution& seeded, const CoulombSolution& other) {
  constexpr double kSame = 1e-9;
  return other.converged && other.lambda.norm() < (1 - kSame) * seeded.lambda.norm() ? other : seeded;
}

/// The guess that every contact holds, with the forces of least norm.
CoulombSolution try_holding(const CoulombProblem& problem, double tolerance) {
  CoulombGuess guess = open_guess(problem);
  for (std::size_t k = 0; k < problem.mu.size(); ++k) {
    const bool may_stick = problem.rows[k] == FrictionRow::cone && problem.mu[k] > 0;
    guess.modes.modes[k] = may_stick ? ContactMode::stick : ContactMode::slide;
  }
  const VecX forces = KnownModesSystem(problem, guess.modes).solve();
  return labelled(make_solution(problem, clamp_to_cones(problem, forces), guess.modes.modes, tolerance), 0,
                  "holding");
}

/// By proximal points; the equations of the modes that these find refine the forces where they hold beyond
/// the resolution.
std::optional<CoulombSolution> solve_to_resolution(const CoulombProblem& problem,
                                                   const CoulombOptions& options, double enough) {
  std::optional<CoulombSolution> solution = solve_by_proximal_points(
      problem, FactoredMotion(problem.A), [&](const VecX& lambda) { return largest_term(problem, lambda); },
      {.enough = enough, .resolution = *options.resolution});
  if (!solution) return std::nullopt;
  const CoulombGuess guess =
      solve_smooth_modes(problem, guess_of_forces(problem, solution->lambda, solution->modes));
  CoulombSolution exact =
      make_solution(problem, clamp_to_cones(problem, guess.lambda), solution->modes, enough);
  if (!(exact.residual < solution->residual)) return solution;
  return labelled(std::move(exact), solution->iterations, "proximal points");
}

/// A as a map of motions: block by block where a Newton step is less work then than with a factor of A.
std::unique_ptr<ContactMotion> motion_of(const MatX& A) {
  if (!has_few_blocks(A)) return std::make_unique<FactoredMotion>(A);
  auto by_blocks = std::make_unique<ContactSpaceMotion>(A);
  if (auto factored = FactoredMotion::of_little_work(A, by_blocks->work())) return factored;
  return by_blocks;
}

/// Of many contacts: what they do by proximal points that begin from the interior of the cones, refined to
/// the forces of least norm where these are asked for.
CoulombSolution solve_many(const CoulombProblem& problem, const CoulombOptions& options,
                           const CoulombSolution& start) {
  const std::unique_ptr<ContactMotion> motion = motion_of(problem.A);
  // Of the solutions of few contacts careful points find the one that has the symmetry of the problem.
  const bool is_bold = !options.least_norm || problem.mu.size() >= kFewestInside;
  std::optional<CoulombSolution> found = solve_by_proximal_points(
      problem, *motion, [&](const VecX& lambda) { return largest_term(problem, lambda); },
      {.enough = options.tolerance, .gives_best = true, .is_bold = is_bold});
  if (!found || !(found->residual < start.residual)) return start;
  if (!options.least_norm && found->converged) return *found;
  CoulombSolution polished =
      polish_coulomb(problem, guess_of_forces(problem, found->lambda, found->modes), options.tolerance);
  const bool is_refined = polished.converged || polished.residual < found->residual;
  return labelled(is_refined ? std::move(polished) : std::move(*found), found->iterations, "proximal points");
}

/// So many contacts are better begun with proximal points than with the chain.
constexpr std::size_t kFewestMany = 8;

/// Sweeps as long as they converge fast: they cost little, and where any share of the load will do their
/// forces are an answer. Of few contacts it costs less to refine what a few of them show.
CoulombSolution solve_by_sweeps(const CoulombProblem& problem, const CoulombOptions& options,
                                CoulombSolution best) {
  constexpr int kMostSweeps = 1024, kFirstLook = 16;
  constexpr double kGainOfDoubling = 0.1;
  const bool are_few = problem.mu.size() < kFewestMany;
  const int most = std::min(are_few ? kFirstLook : kMostSweeps, options.max_iterations);
  CoulombGaussSeidel gauss_seidel(problem, open_guess(problem));
  const CoulombGuess& guess = gauss_seidel.guess();
  double change = 1;
  int sweep = 0;
  while (sweep < most && change > 0) {
    poll_interrupt();
    change = gauss_seidel.sweep();
    ++sweep;
    if (!guess.lambda.allFinite()) return best;
    const bool is_power = (sweep & (sweep - 1)) == 0;
    if (!is_power && change > options.tolerance) continue;
    CoulombSolution next = labelled(
        make_solution(problem, clamp_to_cones(problem, guess.lambda), guess.modes.modes, options.tolerance),
        sweep, "gauss-seidel");
    const bool is_slow = is_power && sweep >= kFirstLook && next.residual > kGainOfDoubling * best.residual;
    if (next.residual < best.residual) best = std::move(next);
    if (best.converged) return best;
    if (is_slow) break;
  }
  if (!are_few) return best;
  CoulombSolution refined = polish_coulomb(problem, guess, options.tolerance);
  return refined.residual < best.residual ? labelled(std::move(refined), sweep, "gauss-seidel") : best;
}

/// Where b is exact. The chain would take minutes of many contacts.
CoulombSolution solve_exact(const CoulombProblem& problem, const CoulombOptions& options,
                            CoulombSolution start) {
  constexpr std::size_t kMostOfChain = 200;
  const std::size_t count = problem.mu.size();
  if (!options.least_norm) start = solve_by_sweeps(problem, options, std::move(start));
  if (count >= kFewestMany && !start.converged) start = solve_many(problem, options, start);
  if (start.converged || count > kMostOfChain) return start;
  // What the chain guesses shows sooner if it is refined, which makes the forces those of least norm.
  CoulombOptions refined = options;
  refined.least_norm = true;
  return Chain(problem, refined, std::move(start)).run();
}

CoulombSolution solve_scaled(const CoulombProblem& problem, const CoulombOptions& options) {
  // Without unknown slips pivoting alone solves it.
  if (is_linear(problem)) {
    const LcpName fitting = is_frictionless(problem) ? LcpName::dantzig : LcpName::lemke;
    CoulombSolution linear = solve_linear(problem, options.lcp.value_or(fitting), options.tolerance);
    if (linear.converged || !options.resolution) return linear;
    return solve_to_resolution(problem, options, options.tolerance).value_or(std::move(linear));
  }

  // The baseline is that every contact opens; one contact alone is solved in closed form.
  CoulombSolution start = labelled(make_solution(problem, VecX::Zero(problem.b.size()),
                                                 open_guess(problem).modes.modes, options.tolerance),
                                   0, "open");
  if (problem.mu.size() == 1) {
    CoulombSolution single = solve_single(problem, options.tolerance);
    if (single.converged) return single;
  }

  // If a complementarity method was asked for, it says first what the contacts do. Lemke's table of the
  // pyramid has 12 columns per contact: with more contacts than this it takes minutes.
  constexpr std::size_t kMostOfPyramid = 60;
  if (options.lcp == LcpName::dantzig || (options.lcp && problem.mu.size() <= kMostOfPyramid)) {
    const CoulombSolution seeded = solve_seeded(problem, *options.lcp, options.tolerance);
    if (seeded.converged)
      return holds_all(seeded) ? seeded : of_less_force(seeded, Chain(problem, options, start).run_briefly());
    if (seeded.residual < start.residual) start = seeded;
  }

  if (!options.resolution) return solve_exact(problem, options, std::move(start));

  // b is known to a resolution: contacts may contradict each other by as much, and proximal points decide.
  // They come first where any share of redundant contacts will do. Where it must be the least, b is taken as
  // exact first; of few contacts the chain ends at the same of several solutions as pivots do.
  if (!options.least_norm) {
    CoulombSolution holding = try_holding(problem, options.tolerance);
    if (holding.converged) return holding;
    if (std::optional<CoulombSolution> solution = solve_to_resolution(problem, options, options.enough))
      return std::move(*solution);
  }
  constexpr std::size_t kFewestToResolution = 16;
  if (options.least_norm && problem.mu.size() >= kFewestToResolution)
    start = solve_many(problem, options, start);
  if (start.converged) return start;
  CoulombOptions polished = options;
  polished.least_norm = true;
  CoulombSolution best = Chain(problem, polished, std::move(start)).run();
  if (best.converged || !options.least_norm) return best;
  return solve_to_resolution(problem, options, options.tolerance).value_or(std::move(best));
}

}  // namespace

CoulombSolution solve_coulomb(const CoulombProblem& problem, const CoulombOptions& options) {
  check_sizes(problem);
  CoulombSolution open{
      VecX::Zero(problem.b.size()), problem.b, open_guess(problem).modes.modes, 0.0, 0, true, "open"};
  if (!is_finite(problem)) {
    CoulombSolution failed = open;
    failed.converged = false;
    failed.residual = std::numeric_limits<double>::infinity();
    return failed;
  }
  if (never_approaches(problem)) return open;

  // Scaling by powers of two is exact: all thresholds below may be relative to 1.
  const ScaledProblem unit = scaled(problem);
  CoulombOptions unit_options = options;
  if (options.resolution) unit_options.resolution = std::ldexp(*options.resolution, -unit.b_exponent);
  CoulombSolution solution = solve_scaled(unit.problem, unit_options);
  scale_back(unit, solution);
  return solution;
}

VecX solve_known_modes(const CoulombProblem& problem, const std::vector<ContactMode>& modes) {
  check_sizes(problem);
  RIGOR_ASSERT(modes.size() == problem.mu.size());
  return KnownModesSystem(problem, {modes, problem.slips}).solve();
}

std::optional<VecX> find_cone_forces(const CoulombProblem& problem, const std::vector<ContactMode>& modes) {
  check_sizes(problem);
  RIGOR_ASSERT(modes.size() == problem.mu.size());
  return KnownModesSystem(problem, {modes, problem.slips}).find_in_cones();
}

double coulomb_residual(const CoulombProblem& problem, const VecX& lambda, const VecX& w) {
  return law_residual(problem, problem.A.diagonal(), largest_term(problem, lambda), lambda, w);
}

}  // namespace rigor
