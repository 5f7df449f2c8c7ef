#include "rigor/sim/time_stepping/step_solver.hpp"

#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/index.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/solver/cones/convex_cone.hpp"
#include "rigor/solver/cones/pyramid_cone.hpp"
#include "rigor/solver/coulomb/coulomb_guess.hpp"
#include "rigor/solver/coulomb/interior_point.hpp"
#include "rigor/solver/coulomb/rolling_friction_problem.hpp"
#include "rigor/solver/coulomb/static_friction.hpp"
#include "rigor/solver/motion/motion_problem.hpp"
#include "rigor/solver/motion/motion_start.hpp"
#include "rigor/solver/motion/projected_gauss_seidel.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

/// Residual of a solved problem: two more digits of slip that changes its direction would take most of the
/// time.
constexpr double solved = 1e-10;

bool has_moments(const Contact& contact) {
  return !contact.stop && (contact.rolling_friction > 0 || contact.torsional_friction > 0);
}

StepImpulses impulses_of(CoulombSolution solution) {
  StepImpulses impulses;
  impulses.lambda = std::move(solution.lambda);
  impulses.modes = std::move(solution.modes);
  impulses.residual = solution.residual;
  impulses.iterations = solution.iterations;
  impulses.converged = solution.residual <= solved;
  return impulses;
}

/// Options for problems whose b is known to the resolution.
CoulombOptions options_for(double resolution) {
  CoulombOptions options;
  options.least_norm = false;
  options.enough = solved;
  options.resolution = resolution;
  options.is_bold = true;
  return options;
}

/// Modes of contacts with these forces: where friction is at its bound, they slide.
std::vector<ContactMode> modes_of_forces(const VecX& lambda, const std::vector<double>& mu) {
  std::vector<ContactMode> modes;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    const Vec3 force = lambda.segment<3>(3 * static_cast<Index>(i));
    const bool slides = force.head<2>().norm() >= sliding_share * mu[i] * force.z();
    modes.push_back(force.z() <= 0 ? ContactMode::open : slides ? ContactMode::slide : ContactMode::stick);
  }
  return modes;
}

/// Impulses near the solution, inside the cones; none of few contacts, which are solved as soon.
std::optional<StepImpulses> rough_impulses(const MotionProblem& problem) {
  // Of (the largest rate)² times a mass. With 1e-4 more exact tries show something new, with 1e-8 as many.
  constexpr double gap = 1e-6;
  if (problem.laws.mu.size() < kFewestRough) return std::nullopt;
  const std::optional<VecX> forces = interior_forces(problem.laws, SparseMotion(problem.rows), {.gap = gap});
  if (!forces) return std::nullopt;
  StepImpulses impulses;
  impulses.lambda = clamp_to_cones(problem.laws, *forces);
  impulses.modes = modes_of_forces(impulses.lambda, problem.laws.mu);
  impulses.accuracy = StepAccuracy::rough;
  return impulses;
}

/// A and b of contacts after the rows of springs are eliminated: the response of bodies on springs.
class SpringResponse {
 public:
  /// rows of the contacts (forces, and moments if any), and their rates without impulses.
  SpringResponse(ContactRows rows, const VecX& rates, const SpringRows& springs,
                 const ContactSystem& system) {
    const Index contacts = rates.size();
    add_springs(springs, system, rows);
    const MatX all = contact_response(rows);

    // The blocks of the springs, and their coupling with the contacts.
    const Index count = static_cast<Index>(springs.count());
    MatX of_springs(count, count);
    coupling_.resize(count, contacts);
    for (Index i = 0; i < count; ++i) {
      const Index row = contacts + 3 * i + 2;
      coupling_.row(i) = all.row(row).head(contacts);
      for (Index k = 0; k < count; ++k) of_springs(i, k) = all(row, contacts + 3 * k + 2);
    }

    // The Schur complement of the springs' rows.
    of_springs.diagonal() += springs.softness;
    stiffness_.compute(of_springs);
    free_ = springs.rates + springs.drive;
    const MatX reduced =
        all.topLeftCorner(contacts, contacts) - coupling_.transpose() * stiffness_.solve(coupling_);
    A = 0.5 * (reduced + reduced.transpose());
    b = rates - coupling_.transpose() * stiffness_.solve(free_);
  }

  MatX A;
  VecX b;

  /// ν when the contacts have these impulses.
  VecX impulses(const VecX& lambda) const { return -stiffness_.solve(free_ + coupling_ * lambda); }

 private:
  static void add_springs(const SpringRows& springs, const ContactSystem& system, ContactRows& rows) {
    std::vector<int> nodes;
    int count = 0;
    for (const BodyKinetics& body : system.kinetics) nodes.push_back(body.inverse_mass > 0 ? count++ : -1);
    for (std::size_t i = 0; i < springs.count(); ++i) {
      ContactRows::Sides sides;
      for (const bool is_A : {true, false}) {
        const SpringRows::End& end = is_A ? springs.ends_A[i] : springs.ends_B[i];
        if (!std::binary_search(system.bodies.begin(), system.bodies.end(), end.body)) continue;
        const Vec3 line = (is_A ? -1.0 : 1.0) * springs.lines[i];
        ContactRows::Side& side = sides[is_A ? 0 : 1];
        side.node = nodes[at(system.local_index(end.body))];
        if (side.node >= 0)
          side.J.row(2) << line.transpose(), (end.p_W - system.of(end.body).x).cross(line).transpose();
      }
      rows.contacts.push_back(sides);
    }
  }

  Eigen::LLT<MatX> stiffness_;  ///< Of the springs' own rows.
  MatX coupling_;
  VecX free_;
};

/// Vectors of forces and of moments (3n each), contact by contact (6n).
VecX interleaved(const VecX& forces, const VecX& moments) {
  VecX both(forces.size() + moments.size());
  for (Index i = 0; 3 * i < forces.size(); ++i)
    both.segment<6>(6 * i) << forces.segment<3>(3 * i), moments.segment<3>(3 * i);
  return both;
}

}  // namespace

StepLaws step_laws_of(const ContactSystem& system, double still) {
  const std::size_t count = system.contacts.size();
  StepLaws laws;
  laws.contacts.b = relative_velocities(system);

  // Sliding.
  laws.contacts.rows.assign(count, FrictionRow::cone);
  laws.contacts.slips.assign(count, Vec2::Zero());
  for (const Contact& contact : system.contacts) laws.contacts.mu.push_back(contact.friction);

  // Rolling and spinning, if anything has moments.
  if (std::any_of(system.contacts.begin(), system.contacts.end(), has_moments)) {
    laws.angular_velocities = VecX::Zero(laws.contacts.b.size());
    for (std::size_t i = 0; i < count; ++i) {
      const Contact& contact = system.contacts[i];
      laws.rolling.push_back(contact.stop ? 0.0 : contact.rolling_friction);
      laws.torsional.push_back(contact.stop ? 0.0 : contact.torsional_friction);
      if (!contact.stop)
        laws.angular_velocities.segment<3>(3 * static_cast<Index>(i)) = relative_angular_velocity(system, i);
    }
  }
  if (std::any_of(system.contacts.begin(), system.contacts.end(),
                  [](const Contact& contact) { return contact.has_static_friction(); })) {
    for (std::size_t i = 0; i < count; ++i) {
      const Contact& contact = system.contacts[i];
      laws.sticking_friction.push_back(contact.has_static_friction() ? contact.static_friction
                                                                     : contact.friction);
      laws.sticks.push_back(laws.contacts.b.segment<2>(3 * static_cast<Index>(i)).norm() <= still);
    }
  }
  return laws;
}

StepSolver::StepSolver(const Method& method)
    : solver_(method.solver),
      cone_(method.cone),
      sweeps_(static_cast<int>(method.iterations)),
      resting_(resting_choice(method)) {}

StepImpulses StepSolver::solve(const ContactSystem& system, StepLaws laws) const {
  if (laws.sticking_friction.empty()) return solve_with(system, laws);
  StepImpulses last;
  const auto solve_with_mu = [&](const std::vector<double>& mu) {
    laws.contacts.mu = mu;
    last = solve_with(system, laws);
    CoulombSolution solution;
    solution.modes = last.modes;
    return solution;
  };
  solve_static_friction({laws.contacts.mu, laws.sticking_friction, laws.sticks}, solve_with_mu);
  return last;
}

StepImpulses StepSolver::solve_with(const ContactSystem& system, const StepLaws& laws) const {
  if (laws.angular_velocities.size() > 0) return solve_frictions(system, laws);
  if (solver_ == SolverMethod::pgs) return sweep(system, laws.contacts);
  return solve_cones(system, laws);
}

/// Springs are eliminated in contact space. All else is sparse: motion space.
StepImpulses StepSolver::solve_cones(const ContactSystem& system, const StepLaws& laws) const {
  // Springs are eliminated first.
  CoulombProblem problem = laws.contacts;
  if (laws.springs) {
    const SpringResponse response(motion_rows(system), problem.b, *laws.springs, system);
    problem.A = response.A;
    problem.b = response.b;
    StepImpulses impulses = solve_dense(problem, laws.resolution);
    impulses.springs = response.impulses(impulses.lambda);
    return impulses;
  }

  // By sparse rows, else by the Delassus operator: few contacts of jointed bodies are solved more exactly
  // there, and one contact of any bodies in closed form.
  constexpr std::size_t few = 4;
  const bool has_joints =
      system.joints || std::any_of(system.contacts.begin(), system.contacts.end(),
                                   [](const Contact& contact) { return contact.stop.has_value(); });
  if (cone_ == ConeMethod::convex && !has_joints)
    return impulses_of(solve_convex_cones(MotionProblem{motion_rows(system), problem}));
  const bool is_sparse = system.contacts.size() > (has_joints ? few : 1);
  if (cone_ == ConeMethod::exact && resting_.space == RestingSpace::motion && is_sparse) {
    const MotionProblem of_rows{motion_rows(system), problem};
    const CoulombOptions options = options_for(laws.resolution);
    std::optional<CoulombSolution> solution;
    if (laws.start.size() > 0) solution = solve_from_forces(of_rows, laws.start, options);
    if (!solution && laws.accuracy == StepAccuracy::rough && !has_joints) {
      if (std::optional<StepImpulses> rough = rough_impulses(of_rows)) return *rough;
    }
    if (!solution) solution = solve_in_motion_space(of_rows, {}, options);
    if (solution) return impulses_of(std::move(*solution));
  }
  problem.A = delassus(system);
  return solve_dense(problem, laws.resolution);
}

StepImpulses StepSolver::solve_dense(const CoulombProblem& problem, double resolution) const {
  if (cone_ == ConeMethod::convex) return impulses_of(solve_convex_cones(problem));
  if (cone_ == ConeMethod::pyramid) return impulses_of(solve_pyramids(problem));
  CoulombOptions options = options_for(resolution);
  options.tolerance = solved;
  if (resting_.space == RestingSpace::contact) options.lcp = resting_.lcp;
  return impulses_of(solve_coulomb(problem, options));
}

/// Sliding, rolling and spinning friction together.
StepImpulses StepSolver::solve_frictions(const ContactSystem& system, const StepLaws& laws) const {
  // A and b with moments, without springs that act implicitly.
  ContactRows rows = moment_rows(system);
  RollingFrictionProblem problem{{},
                                 interleaved(laws.contacts.b, laws.angular_velocities),
                                 laws.contacts.mu,
                                 laws.rolling,
                                 laws.torsional};
  std::optional<SpringResponse> response;
  if (laws.springs) {
    response.emplace(std::move(rows), problem.b, *laws.springs, system);
    problem.A = response->A;
    problem.b = response->b;
  } else {
    problem.A = contact_response(rows);
  }

  // Forces and moments, contact by contact.
  const RollingFrictionSolution solution = solve_rolling_friction(problem);
  StepImpulses impulses;
  if (response) impulses.springs = response->impulses(solution.lambda);
  impulses.lambda = impulses.moments = VecX::Zero(laws.contacts.b.size());
  for (Index i = 0; 3 * i < impulses.lambda.size(); ++i) {
    impulses.lambda.segment<3>(3 * i) = solution.lambda.segment<3>(6 * i);
    impulses.moments.segment<3>(3 * i) = solution.lambda.segment<3>(6 * i + 3);
  }
  impulses.modes = modes_of_forces(impulses.lambda, laws.contacts.mu);
  impulses.residual = solution.residual;
  impulses.iterations = solution.iterations;
  impulses.converged = solution.residual <= solved;
  return impulses;
}

/// Joints take part in the sweeps; the error that these leave in their equations is projected away when the
/// impulses are applied.
StepImpulses StepSolver::sweep(const ContactSystem& system, const CoulombProblem& laws) const {
  VelocityProblem problem{{motion_rows(system), laws}, VecX()};
  if (problem.contacts.rows.joints) {
    Index rows = 0;
    for (const ConstraintGraph::Link& link : problem.contacts.rows.joints->graph().links) rows += link.rows;
    problem.c = VecX::Zero(rows);
  }
  const VelocitySolution solution = solve_projected_gauss_seidel(problem, sweeps_);
  StepImpulses impulses;
  impulses.lambda = solution.lambda;
  impulses.modes = modes_of_forces(solution.lambda, laws.mu);
  impulses.residual = solution.residual;
  impulses.iterations = sweeps_;
  impulses.converged = solution.residual <= solved;
  return impulses;
}

}  // namespace rigor
