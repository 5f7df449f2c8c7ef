#include "rigor/contact/resting/resting.hpp"

#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/index.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <Eigen/Cholesky>
#include <optional>
#include <utility>

namespace rigor {

namespace {

/// Of so few contacts the dense problem in contact space costs less than the rounds of motion space, each of
/// which asks the joints twice; forces of least norm are the same.
constexpr std::size_t few_contacts = 4, few_contacts_with_joints = 8;

bool is_small(const ContactSystem& system) {
  return system.contacts.size() <= (system.joints ? few_contacts_with_joints : few_contacts);
}

/// Tangential unit vector of the slip at each contact: from u_t where there is slip, along the old one
/// otherwise.
Vec2 slip_direction(const Mat3& frame, const Vec3& u, const Vec3& old_slip_W, double direction_tolerance) {
  const Vec2 u_t = u.head<2>();
  const Vec2 old = (frame.transpose() * old_slip_W).head<2>();
  const double speed = u_t.norm();
  if (speed <= direction_tolerance && old.norm() > 0) return old.normalized();
  if (speed == 0) return Vec2::Zero();
  // Past the instant where slip ends u_t points back: friction keeps its side.
  return (u_t.dot(old) < 0 ? -1.0 : 1.0) / speed * u_t;
}

/// The laws of the contacts, without A and b.
CoulombProblem laws_of(const ContactSystem& system) {
  CoulombProblem problem;
  const std::size_t n = system.contacts.size();
  problem.rows.assign(n, FrictionRow::cone);
  problem.slips.assign(n, Vec2::Zero());
  for (const Contact& contact : system.contacts) problem.mu.push_back(contact.friction);
  return problem;
}

std::vector<ContactMode> modes_of(const std::vector<ContactState>& states) {
  std::vector<ContactMode> modes;
  modes.reserve(states.size());
  for (const ContactState& state : states) modes.push_back(state.mode);
  return modes;
}

/// The force of known mode at a contact that is alone between bodies that no joint holds, from its own three
/// rows; nothing elsewhere, and where these are too close to dependent.
std::optional<VecX> force_alone(const ContactSystem& system, const CoulombProblem& laws,
                                const std::vector<ContactMode>& modes) {
  constexpr double least_ratio = 1e-6;
  if (modes.size() != 1 || system.joints) return std::nullopt;
  if (modes.front() == ContactMode::open) return Vec3::Zero();
  // Slide: one unknown, λ_n, on the generator against the slip.
  const Mat3 A = delassus(system);
  const Vec3 b = laws.b;
  if (modes.front() == ContactMode::slide) {
    const Vec2 friction = -laws.mu.front() * laws.slips.front();
    const Vec3 direction(friction.x(), friction.y(), 1);
    const double response = A.row(2).dot(direction);
    if (!(response > least_ratio * A(2, 2))) return std::nullopt;
    return Vec3(-b.z() / response * direction);
  }

  // Stick: A λ = -b with one step of refinement.
  const Eigen::LLT<Mat3> factors(A);
  if (factors.info() != Eigen::Success || !(factors.rcond() > least_ratio)) return std::nullopt;
  const Vec3 lambda = factors.solve(-b);
  return Vec3(lambda - factors.solve(A * lambda + b));
}

VecX forces_of_modes(const ContactSystem& system, CoulombProblem laws, const std::vector<ContactMode>& modes,
                     const RestingChoice& choice) {
  if (const std::optional<VecX> force = force_alone(system, laws, modes)) return *force;
  if (choice.space == RestingSpace::motion && !is_small(system)) {
    const MotionProblem problem{motion_rows(system), laws};
    const EliminationPlan plan = elimination_plan(problem.rows);
    const MotionModesSystem forces(problem, plan, {modes, laws.slips});
    if (forces.is_exact()) return forces.least_norm();
  }
  // Rows too close to dependent for motion space, or that contradict each other.
  laws.A = delassus(system);
  return solve_known_modes(laws, modes);
}

/// The laws of contacts whose modes are known: accelerations and slip directions, without A.
CoulombProblem laws_of_modes(const ContactSystem& system, const std::vector<ContactState>& states,
                             const std::vector<Wrench>& wrenches, double direction_tolerance) {
  CoulombProblem problem = laws_of(system);
  problem.b = free_contact_accelerations(system, wrenches);
  const VecX u = relative_velocities(system);
  for (std::size_t i = 0; i < states.size(); ++i) {
    problem.slips[i] = slip_direction(system.frames[i], u.segment<3>(3 * static_cast<Eigen::Index>(i)),
                                      states[i].slip_W, direction_tolerance);
  }
  return problem;
}

}  // namespace

VecX free_contact_accelerations(const ContactSystem& system, const std::vector<Wrench>& wrenches) {
  const std::vector<Vec6> of_bodies = accelerations(system, wrenches);
  VecX result(3 * static_cast<Eigen::Index>(system.contacts.size()));
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const ContactJacobian& rows = system.rows[i];
    const std::size_t a = at(system.local_index(contact.body_A));
    const std::size_t b = at(system.local_index(contact.body_B));
    Vec3 u = rows.A * of_bodies[a] + rows.B * of_bodies[b];
    u += contact.stop ? rows.bias : acceleration_bias(contact, system.kinetics[a], system.kinetics[b]);
    if (rows.mobility > 0) u[2] = -rows.load * rows.mobility;
    result.segment<3>(3 * static_cast<Eigen::Index>(i)) = u;
  }
  return result;
}

namespace {

// Share of the largest acceleration below which one counts as none.
constexpr double resting_rounding = 1e-9;

CoulombSolution solve_laws(const ContactSystem& system, CoulombProblem laws, const RestingChoice& choice,
                           const std::vector<ContactMode>& start) {
  CoulombOptions options;
  options.resolution = resting_rounding * laws.b.cwiseAbs().maxCoeff();
  if (choice.space == RestingSpace::motion) {
    if (system.joints && is_small(system)) {
      CoulombProblem dense = laws;
      dense.A = delassus(system);
      CoulombSolution solution = solve_coulomb(dense, options);
      if (solution.converged) return solution;
    }
    const MotionProblem problem{motion_rows(system), laws};
    if (std::optional<CoulombSolution> solution = solve_in_motion_space(problem, start)) return *solution;
  }
  laws.A = delassus(system);
  if (choice.space == RestingSpace::contact) options.lcp = choice.lcp;
  return solve_coulomb(laws, options);
}

}  // namespace

RestingSolution solve_resting(const ContactSystem& system, const std::vector<Wrench>& wrenches,
                              double slip_tolerance, const RestingChoice& choice,
                              const std::vector<ContactMode>& start) {
  // Contacts that slip already have known friction; the others may stick or start to slip.
  CoulombProblem problem = laws_of(system);
  problem.b = free_contact_accelerations(system, wrenches);
  const VecX u = relative_velocities(system);
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Vec2 u_t = u.segment<2>(3 * static_cast<Eigen::Index>(i));
    if (u_t.norm() <= slip_tolerance) continue;
    problem.rows[i] = FrictionRow::slide;
    problem.slips[i] = u_t.normalized();
  }

  // Forces and accelerations, and from them what each contact does.
  RestingSolution solution{solve_laws(system, problem, choice, start), {}};
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    ContactState state{solution.forces.modes[i], Vec3::Zero()};
    Vec2 slip = problem.slips[i];
    if (state.mode == ContactMode::slide && problem.rows[i] == FrictionRow::cone) {
      // Slip begins along the tangential acceleration. Without one the force is at the limit and nothing
      // slips.
      const Vec2 w_t = solution.forces.w.segment<2>(3 * static_cast<Eigen::Index>(i));
      if (w_t.norm() <= resting_rounding * problem.b.cwiseAbs().maxCoeff()) {
        state.mode = ContactMode::stick;
      } else {
        slip = w_t.normalized();
      }
    }
    state.slip_W = system.frames[i].leftCols<2>() * slip;
    solution.states.push_back(state);
  }
  return solution;
}

VecX contact_forces(const ContactSystem& system, const std::vector<ContactState>& states,
                    const std::vector<Wrench>& wrenches, double direction_tolerance,
                    const RestingChoice& choice) {
  return forces_of_modes(system, laws_of_modes(system, states, wrenches, direction_tolerance),
                         modes_of(states), choice);
}

bool modes_have_forces(const ContactSystem& system, const std::vector<ContactState>& states,
                       const std::vector<Wrench>& wrenches, double direction_tolerance,
                       const RestingChoice& choice) {
  CoulombProblem laws = laws_of_modes(system, states, wrenches, direction_tolerance);
  if (choice.space == RestingSpace::motion) {
    const MotionProblem problem{motion_rows(system), laws};
    const EliminationPlan plan = elimination_plan(problem.rows);
    const MotionModesSystem forces(problem, plan, {modes_of(states), laws.slips});
    if (forces.is_exact()) return forces.find_in_cones().has_value();
  }
  laws.A = delassus(system);
  return find_cone_forces(laws, modes_of(states)).has_value();
}

void add_contact_wrenches(const ContactSystem& system, const VecX& lambda, std::vector<Wrench>& wrenches) {
  const std::vector<Wrench> of_contacts = contact_wrenches(system, lambda);
  for (std::size_t b = 0; b < wrenches.size(); ++b) {
    wrenches[b].f_W += of_contacts[b].f_W;
    wrenches[b].tau_W += of_contacts[b].tau_W;
  }
}

VecX projection_impulses(const ContactSystem& system, const std::vector<ContactState>& states,
                         const RestingChoice& choice) {
  CoulombProblem laws = laws_of(system);
  laws.b = relative_velocities(system);
  // Bodies at rest, as most scenes begin: nothing is to be corrected.
  if (laws.b.isZero(0)) return laws.b;
  // Along the slip nothing is corrected: a sliding contact takes part with its normal alone.
  laws.mu.assign(states.size(), 0.0);
  return forces_of_modes(system, std::move(laws), modes_of(states), choice);
}

VecX normal_impulses(const ContactSystem& system, const VecX& wanted, const std::vector<ContactMode>& modes,
                     const RestingChoice& choice) {
  CoulombProblem laws = laws_of(system);
  laws.b = wanted;
  laws.mu.assign(modes.size(), 0.0);
  return forces_of_modes(system, std::move(laws), modes, choice);
}

}  // namespace rigor
