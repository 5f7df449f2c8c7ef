#include "rigor/solver/motion/motion_problem.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"
#include "rigor/solver/coulomb/coulomb_proximal.hpp"
#include "rigor/solver/coulomb/least_norm_slips.hpp"
#include "rigor/solver/coulomb/proximal_points.hpp"
#include "rigor/solver/motion/least_constraint.hpp"
#include "rigor/solver/motion/swept_forces.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

// Times that contacts are moved to other modes before the guess is given up.
constexpr int kMoves = 5;

class MotionSolver {
 public:
  MotionSolver(const MotionProblem& problem, const CoulombOptions& options, const VecX& forces)
      : problem_(problem),
        laws_(problem.laws),
        options_(options),
        start_(forces),
        motion_(problem.rows),
        forces_of_([this](const ContactModes& modes) { return forces_of(modes); }) {}

  bool is_finite() const {
    const auto is_number = [](double mu) { return std::isfinite(mu) && mu >= 0; };
    return motion_.diagonal().allFinite() && std::all_of(laws_.mu.begin(), laws_.mu.end(), is_number);
  }

  std::optional<CoulombSolution> run(const std::vector<ContactMode>& start) {
    // Without friction the nearest point shows the modes; of many contacts proximal points find it sooner,
    // and of very many they alone. A start near the solution is best refined itself.
    if (is_frictionless() && is_many_to_resolution()) {
      std::optional<CoulombSolution> solution = solve_to_resolution();
      if (solution && (solution->converged || !is_dense_enough())) return solution;
    }
    const bool is_near = start_.size() > 0 && options_.resolution && are_masses_alike(problem_.rows);
    if (is_frictionless() && is_dense_enough() && !is_near)
      return settle(guess_of(least_constraint_modes()), kMoves, "least constraint");
    if (start_.size() > 0 && !options_.least_norm) return is_near ? solve_to_resolution() : share_somehow();

    // The modes of a similar problem before, then that every contact holds: most problems are solved by that.
    if (!start.empty()) {
      if (std::optional<CoulombSolution> solution = settle(guess_of(start), 1, "motion")) return solution;
    }
    const std::vector<ContactMode> holding(laws_.mu.size(), ContactMode::stick);
    if (options_.least_norm || may_hold()) {
      if (std::optional<CoulombSolution> solution = settle(guess_of(holding), 1, "motion")) return solution;
    }

    // Else the motion has to be searched.
    if (options_.resolution && !options_.least_norm) return solve_to_resolution();
    return options_.least_norm ? approach() : share_somehow();
  }

 private:
  bool is_frictionless() const {
    return std::all_of(laws_.mu.begin(), laws_.mu.end(), [](double mu) { return mu == 0; });
  }

  /// Whether some motion may stop all contacts at once: stiff springs in their place leave next to nothing of
  /// their rates, and, of few contacts, neither pull on a pair of bodies nor drag beyond its cone. It costs
  /// one elimination, less than half of what it takes to find forces that hold.
  bool may_hold() const {
    constexpr double kStiffness = 1e6, kShare = 1e-2;  // Times the mass of each contact; of the rates.
    const bool are_free = std::all_of(laws_.rows.begin(), laws_.rows.end(),
                                      [](FrictionRow row) { return row == FrictionRow::cone; });
    if (is_frictionless() || !are_free || !are_masses_alike(problem_.rows)) return true;
    if (options_.is_bold && parts_somewhere()) return false;
    const VecX masses = effective_masses(motion_.diagonal());
    std::vector<Mat3> D(laws_.mu.size());
    VecX forces = laws_.b;
    for (std::size_t k = 0; k < D.size(); ++k) {
      const Index i = static_cast<Index>(k);
      D[k] = kStiffness * masses(i) * (laws_.mu[k] > 0 ? Mat3::Identity() : Mat3(Vec3::UnitZ().asDiagonal()));
      forces.segment<3>(3 * i) = D[k] * laws_.b.segment<3>(3 * i);
    }
    motion_.factor(D, Symmetry::positive);
    const VecX left = motion_.rates(motion_.solve(-motion_.apply_transpose(forces))) + laws_.b;
    const double most = kShare * laws_.b.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < D.size(); ++k) {
      const Index row = 3 * static_cast<Index>(k);
      const double of_contact =
          laws_.mu[k] > 0 ? left.segment<3>(row).cwiseAbs().maxCoeff() : std::abs(left(row + 2));
      if (of_contact > most) return false;
    }
    VecX pushes(left.size());
    for (std::size_t k = 0; k < D.size(); ++k) {
      const Index row = 3 * static_cast<Index>(k);
      pushes.segment<3>(row) = -D[k] * left.segment<3>(row);
    }
    return laws_.mu.size() >= kFewestInside || may_push(pushes);
  }

  /// Whether a contact would part without impulses: then all hold less often than not, and what a bold search
  /// finds costs less than trying it.
  bool parts_somewhere() const {
    constexpr double kShare = 1e-2;  // Of the largest rate: blocks that fall together part by rounding.
    const double least = kShare * laws_.b.cwiseAbs().maxCoeff();
    for (Index row = 2; row < laws_.b.size(); row += 3)
      if (laws_.b(row) > least) return true;
    return false;
  }

  /// Whether contacts may have such forces by their sum: those of one pair of bodies with one normal must
  /// together lie in the cone, in whatever way they share them. (Where bodies form loops, pairs may share
  /// them in other ways than springs do, and few of the problems that could hold are searched then.) Rows
  /// with a load, bounded forces of joints, are not asked: their normals are the loads.
  bool may_push(const VecX& forces) const {
    constexpr double kSameNormal = 1e-6, kShare = 0.3;  // Of the largest force.
    const double negligible = kShare * forces.cwiseAbs().maxCoeff();
    const std::vector<ContactRows::Sides>& contacts = problem_.rows.contacts;
    for (std::size_t begin = 0, end; begin < contacts.size(); begin = end) {
      // The contacts that follow each other on the same two nodes; the first one with a body shows the axes.
      const ContactRows::Sides& first = contacts[begin];
      const auto side = std::ranges::find_if(first, [](const ContactRows::Side& s) { return s.node >= 0; });
      const auto place = static_cast<std::size_t>(side - first.begin());
      Vec3 sum = Vec3::Zero();
      bool is_flat = side != first.end() && first.back().node < 0;
      for (end = begin; end < contacts.size(); ++end) {
        if (contacts[end][0].node != first[0].node || contacts[end][1].node != first[1].node) break;
        if (!is_flat) continue;
        const Mat3 axes = contacts[end][place].J.leftCols<3>();
        sum += axes.transpose() * forces.segment<3>(3 * static_cast<Index>(end));
        is_flat = laws_.mu[end] == laws_.mu[begin] &&
                  (axes.row(2) - side->J.row(2).head<3>()).cwiseAbs().maxCoeff() <= kSameNormal;
      }
      if (!is_flat) continue;
      const Vec3 n = side->J.row(2).head<3>();
      const double push = n.dot(sum), drag = (sum - push * n).norm();
      if (push < -negligible || drag > laws_.mu[begin] * push + negligible) return false;
    }
    return true;
  }

  /// Whether any share of the load will do, of more contacts than dense methods solve quickly.
  bool is_many_to_resolution() const {
    constexpr std::size_t kMostInDenseMethods = 16;
    return options_.resolution && !options_.least_norm && laws_.mu.size() > kMostInDenseMethods;
  }

  /// These modes, as far as the rows allow them.
  CoulombGuess guess_of(const std::vector<ContactMode>& modes) const {
    CoulombGuess guess = open_guess(laws_);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const bool may_stick = laws_.rows[k] == FrictionRow::cone && laws_.mu[k] > 0;
      // A contact that began to slip has no direction yet: it shows as one that cannot stick.
      guess.modes.modes[k] = modes[k] == ContactMode::open ? ContactMode::open
                             : may_stick                   ? ContactMode::stick
                                                           : ContactMode::slide;
    }
    return guess;
  }

  /// The dense search for the nearest point takes contacts and the rows of joints, as equations, one by one:
  /// of long chains and of large heaps they are too many.
  bool is_dense_enough() const {
    constexpr std::size_t kMostHeldNodes = 40, kMostContacts = 200;
    return problem_.rows.joint_nodes.size() <= kMostHeldNodes && laws_.mu.size() <= kMostContacts;
  }

  /// The nearest point with G = J M^(-½): joints first, as equations, then the normals of contacts.
  LeastConstraintProblem nearest_point() const {
    const ContactRows& rows = problem_.rows;
    const Index count = static_cast<Index>(laws_.mu.size());
    const Index equations = for_each_joint_row(rows, [](Index, int, const Vec6&) {});
    const Index size = 6 * static_cast<Index>(rows.node_count());
    LeastConstraintProblem nearest{MatX::Zero(equations + count, size), VecX::Zero(equations + count),
                                   equations};
    const auto add = [&](Index row, int node, const Vec6& J) {
      // With M = C Cᵀ: the row Cᵀ⁻¹ needs.
      const Mat6 root = cholesky_factor(rows.masses[at(node)]);
      nearest.G.row(row).segment<6>(6 * node) += root.triangularView<Eigen::Lower>().solve(J).transpose();
    };
    for_each_joint_row(rows, add);
    for (Index i = 0; i < count; ++i) {
      nearest.d(equations + i) = -laws_.b(3 * i + 2);
      for (const ContactRows::Side& side : rows.contacts[at(i)])
        if (side.node >= 0) add(equations + i, side.node, side.J.row(2).transpose());
    }
    return nearest;
  }

  /// Which contacts push when there is no friction: the active rows of the nearest point.
  std::vector<ContactMode> least_constraint_modes() {
    const std::size_t count = laws_.mu.size();
    const LeastConstraintProblem nearest = nearest_point();
    const LeastConstraintSolution solution = solve_least_constraint(nearest);
    pivots_ = solution.iterations;
    std::vector<ContactMode> modes(count, ContactMode::open);
    const VecX slack = nearest.G * solution.y - nearest.d;
    for (std::size_t i = 0; i < count; ++i) {
      // Redundant contacts hold too, though the active rows do without them.
      const Index row = nearest.equalities + static_cast<Index>(i);
      const double size_of_row = std::abs(nearest.d(row)) + nearest.G.row(row).norm() * solution.y.norm();
      if (slack(row) <= 1e-12 * size_of_row) modes[i] = ContactMode::slide;
    }
    return modes;
  }

  double largest_of(const VecX& lambda) const {
    return std::max(laws_.b.cwiseAbs().maxCoeff(), largest_term(problem_.rows, lambda));
  }

  VecX motion_of(const VecX& lambda) const {
    return motion_.rates(motion_.apply_inverse_mass(motion_.apply_transpose(lambda))) + laws_.b;
  }

  CoulombSolution solution_of(const VecX& forces, const std::vector<ContactMode>& modes) const {
    CoulombSolution solution{clamp_to_cones(laws_, forces), VecX(), modes, 0.0, 0, false, ""};
    solution.w = motion_of(solution.lambda);
    solution.residual =
        law_residual(laws_, motion_.diagonal(), largest_of(solution.lambda), solution.lambda, solution.w);
    solution.converged = solution.residual <= options_.tolerance;
    return solution;
  }

  std::optional<CoulombSolution> forces_of(const ContactModes& modes) const {
    const std::optional<VecX> forces = MotionModesSystem(problem_, motion_.plan(), modes).find_in_cones();
    if (!forces) return std::nullopt;
    return solution_of(*forces, modes.modes);
  }

  /// Solves for the guess's modes and moves the contacts that break the law, a few times.
  std::optional<CoulombSolution> settle(CoulombGuess guess, int most_moves, const char* method) const {
    // Where any share will do, forces in the cones are found at once or not at all: of 627 problems of heaps
    // 421 needed no step, 5 three to six, and 201 had none after nine.
    constexpr int kImpatience = 2, kPatience = 8;
    std::set<std::vector<ContactMode>> visited;
    for (int move = 0; move < most_moves && visited.insert(guess.modes.modes).second; ++move) {
      poll_interrupt();
      const MotionModesSystem system(problem_, motion_.plan(), guess.modes);
      const std::optional<VecX> forces = system.find_in_cones(options_.least_norm ? kPatience : kImpatience);
      // Forces for the modes, with their slips followed if these are unknown; they are the solution if the
      // law holds for them.
      if (forces) {
        CoulombSolution solution = solution_of(*forces, guess.modes.modes);
        if (has_unknown_slips(laws_, guess.modes) && solution.residual > kZeroMotion) {
          if (auto least = find_least_norm(laws_, guess.modes, kZeroMotion, forces_of_))
            solution = std::move(*least);
        }
        if (solution.converged)
          return labelled(options_.least_norm ? with_least_norm(std::move(solution)) : std::move(solution),
                          move + 1, method);
      }

      // The law is broken somewhere: the contacts that break it move.
      guess.lambda = system.least_norm();
      move_contacts(laws_, motion_.diagonal(), motion_of(guess.lambda),
                    kZeroMotion * largest_of(guess.lambda), guess);
    }
    return std::nullopt;
  }

  /// The solution with the forces of least norm: every contact with w_n = 0 may push, every one with w = 0
  /// may stick.
  CoulombSolution with_least_norm(CoulombSolution solution) const {
    const ContactModes face =
        modes_of_motion(laws_, solution.lambda, solution.w, kZeroMotion * largest_of(solution.lambda));
    if (face.modes == solution.modes) return solution;
    const double accepted = std::max(kZeroMotion, 4 * solution.residual);
    if (std::optional<CoulombSolution> least = find_least_norm(laws_, face, accepted, forces_of_))
      return *least;
    solution.modes = face.modes;
    return solution;
  }

  /// Steps of the augmented Lagrangian until what the contacts seem to do is what they do. Most problems need
  /// one guess, nearly all of the others fewer than these; contact space solves what is left sooner than more
  /// of them would.
  std::optional<CoulombSolution> approach() const {
    constexpr int kMaxSteps = 40, kMaxGuesses = 10;
    int guesses = 0;
    CoulombProximal proximal(laws_, motion_, open_guess(laws_));
    std::vector<ContactMode> offered;
    for (int step = 1; step <= kMaxSteps; ++step) {
      proximal.step();
      const CoulombGuess& guess = proximal.guess();
      if (!guess.lambda.allFinite()) return std::nullopt;
      if (guess.modes.modes == offered && step % 8 != 0) continue;
      offered = guess.modes.modes;
      if (++guesses > kMaxGuesses) return std::nullopt;
      if (std::optional<CoulombSolution> solution = settle(guess, kMoves, "proximal motion"))
        return labelled(std::move(*solution), step, "proximal motion");
    }
    return std::nullopt;
  }

  /// Steps of the augmented Lagrangian until its own forces solve the problem.
  std::optional<CoulombSolution> share_somehow() const {
    constexpr int kMaxSteps = 60;
    CoulombGuess guess = open_guess(laws_);
    const bool is_warm = start_.size() > 0;
    if (is_warm) guess.lambda = clamp_to_cones(laws_, start_);
    CoulombProximal proximal(laws_, motion_, guess, {.makes_digits = true, .is_warm = is_warm});
    for (int step = 1; step <= kMaxSteps; ++step) {
      proximal.step();
      const CoulombGuess& reached = proximal.guess();
      if (!reached.lambda.allFinite()) return std::nullopt;
      CoulombSolution solution = solution_of(reached.lambda, reached.modes.modes);
      if (solution.converged) return labelled(std::move(solution), step, "proximal motion");
    }
    return std::nullopt;
  }

  std::optional<CoulombSolution> solve_to_resolution() const {
    // Contact space may still solve what is left, but of many contacts it takes minutes.
    constexpr std::size_t kMostInContactSpace = 60;
    // What few contacts do shows in a few sweeps.
    constexpr int kSweeps = 20;
    const bool is_swept =
        options_.is_bold && start_.size() == 0 && !problem_.rows.joints && laws_.mu.size() < kFewestInside;
    return solve_by_proximal_points(laws_, motion_, [this](const VecX& lambda) { return largest_of(lambda); },
                                    {.enough = options_.enough,
                                     .resolution = *options_.resolution,
                                     .gives_best = laws_.mu.size() > kMostInContactSpace,
                                     .is_bold = options_.is_bold,
                                     .start = is_swept ? swept_forces(problem_, kSweeps) : start_});
  }

  CoulombSolution labelled(CoulombSolution solution, int iterations, const char* method) const {
    solution.iterations = std::max(iterations, pivots_);
    solution.method = method;
    return solution;
  }

  const MotionProblem& problem_;
  const CoulombProblem& laws_;
  const CoulombOptions& options_;
  const VecX& start_;
  SparseMotion motion_;
  ForcesOfModes forces_of_;
  int pivots_ = 0;
};

}  // namespace

std::optional<CoulombSolution> solve_in_motion_space(const MotionProblem& problem,
                                                     const std::vector<ContactMode>& start,
                                                     const CoulombOptions& options, const VecX& forces) {
  const CoulombProblem& laws = problem.laws;
  RIGOR_ASSERT(laws.b.size() == 3 * static_cast<Index>(problem.rows.contacts.size()));
  RIGOR_ASSERT(start.empty() || start.size() == laws.mu.size());
  RIGOR_ASSERT(forces.size() == 0 || forces.size() == laws.b.size());
  if (!laws.b.allFinite()) return std::nullopt;
  bool approaches = false;
  for (Index i = 2; i < laws.b.size(); i += 3) approaches = approaches || laws.b(i) < 0;
  if (!approaches)
    return CoulombSolution{
        VecX::Zero(laws.b.size()), laws.b, open_guess(laws).modes.modes, 0.0, 0, true, "open"};
  MotionSolver solver(problem, options, forces);
  return solver.is_finite() ? solver.run(start) : std::nullopt;
}

}  // namespace rigor
