#pragma once

#include "rigor/contact/impact/delassus_operator.hpp"
#include "rigor/contact/system/contact_system.hpp"
#include "rigor/solver/linear/contact_rows.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigor {

/// One contact of an ImpactProblem.
struct ImpactContact {
  int lower, higher;  ///< Bodies, lower < higher.
  /// Takes an impulse λ of the contact to the impulse on the body of higher index, in W: the contact frame C,
  /// or -C where that body is the contact's A.
  Mat3 frame;
  double mu;
  double restitution;                 ///< e, as it is to be used here.
  double tangential_restitution = 0;  ///< e_t; 0: none.

  /// Unit normal from the lower to the higher body.
  Vec3 n_W() const { return frame.col(2); }
};

/// Contacts at an instant of impact, in contact space: impulses λ (3n, t1 t2 n of each contact) change the
/// relative velocities by A λ.
struct ImpactProblem {
  std::vector<ImpactContact> contacts;  ///< n.
  DelassusOperator A;                   ///< 3n × 3n [1/kg].
  VecX u;                               ///< Relative velocities before, 3n [m/s].
  /// What A is made of, where the contacts are more than a few and bodies alone bear them: else none.
  std::shared_ptr<const ContactRows> rows = {};
  /// The same where joints or loads bear them too: only all contacts together are solved on these.
  std::shared_ptr<const ContactRows> jointed_rows = {};

  std::size_t count() const { return contacts.size(); }
};

/// Impulses of an impact.
struct ImpactSolution {
  VecX lambda;            ///< 3n impulses in the contact frames [N s].
  double residual = 0;    ///< Of the complementarity problems solved on the way, relative.
  bool converged = true;  ///< Nothing approaches any more, by the law asked for.
  int iterations = 0;     ///< Of the solvers, or impacts of a sequence.
  /// Angular impulses in the contact frames, 3n [N m s]; empty: none.
  VecX moments = {};
  std::string phases = {};  ///< What happened, if it was one collision (CollisionOutcome::phases).
  double unresolved = 0;    ///< Approach that contacts which contradict each other may keep [m/s].
};

/// The contacts of a system with their coefficients of restitution.
ImpactProblem make_impact_problem(const ContactSystem& system, const std::vector<double>& restitutions);

/// The problem of some of its contacts alone, with velocities u (3n): by a matrix, or by rows alone where
/// the problem has rows and the contacts chosen are many.
ImpactProblem part_of(const ImpactProblem& problem, const std::vector<std::size_t>& chosen, const VecX& u);

/// The rows of these contacts: on the nodes that they have, or where joints hold some on all nodes.
ContactRows rows_of(const ContactRows& rows, const std::vector<std::size_t>& contacts);

/// First of the three rows of a contact.
inline Eigen::Index row_of(std::size_t contact) {
  return 3 * static_cast<Eigen::Index>(contact);
}
inline double normal_velocity(const VecX& u, std::size_t contact) {
  return u[row_of(contact) + 2];
}

/// Approach slower than this is rounding of the velocities u [m/s].
double rounding_speed(const VecX& u);
/// The fastest approach, max(0, -u_n) over all contacts [m/s].
double fastest_approach(const VecX& u);

/// What the impulses change of the kinetic energy, less the work of prescribed bodies [J]: λ·(u⁻ + ½ A λ).
double energy_change(const ImpactProblem& problem, const VecX& lambda);

/// Speed below which faces that lie on each other within the contact tolerance may contradict each other, in
/// an impact at velocities u (3n) [m/s].
double contradiction_speed(const VecX& u);

/// Impulses λ with w = A λ + b, 0 ≤ λ_n ⊥ w_n ≥ 0, λ in the cones, friction against w_t: Coulomb's law,
/// without friction if `mu` is zero.
CoulombSolution solve_cones(const MatX& A, const VecX& b, const std::vector<double>& mu);

/// The same for all contacts of the problem, from velocities b (3n). Where it has rows they are solved, with
/// the share of the load that proximal points from no load lead to: it follows the symmetry of the problem
/// and not the order of the contacts, but is not of least norm, whose search takes three to twenty times
/// as long. By A else, and what the rows leave.
CoulombSolution solve_cones(const ImpactProblem& problem, const VecX& b, const std::vector<double>& mu);

/// μ of all contacts.
std::vector<double> frictions(const ImpactProblem& problem);

}  // namespace rigor
