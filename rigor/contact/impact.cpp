#include "rigor/contact/impact.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rigor {

namespace {

/// The contacts as one problem in contact space.
struct ImpactSpace {
  MatX A;         ///< Delassus operator, 3n × 3n.
  VecX u_before;  ///< 3n.
  std::vector<double> mu;
  std::vector<double> e;

  std::size_t count() const { return e.size(); }
};

Eigen::Index row(std::size_t contact, int component) {
  return 3 * static_cast<Eigen::Index>(contact) + component;
}
double normal_part(const VecX& u, std::size_t contact) {
  return u[row(contact, 2)];
}

CoulombSolution solve_cone_problem(const MatX& A, const VecX& b, const std::vector<double>& mu) {
  return solve_coulomb({A, b, mu, std::vector<FrictionRow>(mu.size(), FrictionRow::cone),
                        std::vector<Vec2>(mu.size(), Vec2::Zero())});
}

ImpactSolution solution_of(const CoulombSolution& found) {
  return {found.lambda, found.residual, found.converged, found.iterations};
}

/// Newton's law with friction on all contacts at once: w = u⁺ + e min(0, u_n⁻) n, 0 ≤ λ_n ⊥ w_n ≥ 0.
ImpactSolution solve_newton(const ImpactSpace& space) {
  VecX b = space.u_before;
  for (std::size_t i = 0; i < space.count(); ++i) {
    b[row(i, 2)] += space.e[i] * std::min(0.0, normal_part(space.u_before, i));
  }
  return solution_of(solve_cone_problem(space.A, b, space.mu));
}

/// The frictionless problem of a chosen set of contacts: 0 ≤ λ_V ⊥ (u + A λ)_V ≥ 0; λ = 0 outside of V.
VecX solve_frictionless(const ImpactSpace& space, const VecX& u, const std::vector<std::size_t>& chosen) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(chosen.size());
  MatX A(size, size);
  VecX b(size);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    b.segment<3>(row(i, 0)) = u.segment<3>(row(chosen[i], 0));
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      A.block<3, 3>(row(i, 0), row(k, 0)) = space.A.block<3, 3>(row(chosen[i], 0), row(chosen[k], 0));
    }
  }
  const CoulombSolution found = solve_cone_problem(A, b, std::vector<double>(chosen.size(), 0.0));
  VecX lambda = VecX::Zero(u.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) lambda[row(chosen[i], 2)] = found.lambda[row(i, 2)];
  return lambda;
}

std::vector<std::size_t> all_contacts(const ImpactSpace& space) {
  std::vector<std::size_t> all(space.count());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

/// Generalised reflections: reflect the velocity about all constraints it violates until it violates none.
/// Energy and momentum are conserved at each reflection; finitely many suffice in exact arithmetic.
VecX generalised_reflections(const ImpactSpace& space, double tolerance) {
  constexpr int most_reflections = 10000;
  VecX u = space.u_before;
  VecX lambda = VecX::Zero(u.size());
  for (int k = 0; k < most_reflections; ++k) {
    std::vector<std::size_t> violated;
    for (std::size_t i = 0; i < space.count(); ++i) {
      if (normal_part(u, i) < -tolerance) violated.push_back(i);
    }
    if (violated.empty()) return lambda;
    const VecX reflection = 2 * solve_frictionless(space, u, violated);
    lambda += reflection;
    u += space.A * reflection;
  }
  return lambda;
}

double energy_change(const ImpactSpace& space, const VecX& lambda) {
  return lambda.dot(space.u_before + 0.5 * (space.A * lambda));
}

/// Normal impulses λ = e λ_GR + (1 - e) λ_plastic, contact by contact; with one e for all where different e
/// would gain energy.
VecX blended_normal_impulses(const ImpactSpace& space, double tolerance) {
  const VecX plastic = solve_frictionless(space, space.u_before, all_contacts(space));
  const VecX reflected = generalised_reflections(space, tolerance);
  VecX lambda = plastic;
  for (std::size_t i = 0; i < space.count(); ++i) {
    lambda[row(i, 2)] += space.e[i] * (reflected[row(i, 2)] - plastic[row(i, 2)]);
  }
  if (energy_change(space, lambda) > 0) {
    const double e = *std::min_element(space.e.begin(), space.e.end());
    lambda = plastic + e * (reflected - plastic);
  }
  return lambda;
}

/// Friction within the disks |λ_t| ≤ μ λ_n of given normal impulses: the tangential impulses that leave the
/// least kinetic energy, by projected Gauss-Seidel on this convex problem.
void add_friction(const ImpactSpace& space, VecX& lambda) {
  constexpr int sweeps = 200;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0, size = 0;
    for (std::size_t i = 0; i < space.count(); ++i) {
      const double bound = space.mu[i] * lambda[row(i, 2)];
      if (bound <= 0) continue;
      const Mat2 A_tt = space.A.block<2, 2>(row(i, 0), row(i, 0));
      const Vec2 u_t = space.u_before.segment<2>(row(i, 0)) + space.A.middleRows<2>(row(i, 0)) * lambda;
      const double step = 1 / A_tt.norm();
      Vec2 next = lambda.segment<2>(row(i, 0)) - step * u_t;
      if (next.norm() > bound) next *= bound / next.norm();
      change += (next - lambda.segment<2>(row(i, 0))).norm();
      size += bound;
      lambda.segment<2>(row(i, 0)) = next;
    }
    if (change <= 1e-14 * size) return;
  }
}

/// Reflections with restitution, friction within the cones, and a last plastic pass for what friction brought
/// together.
ImpactSolution solve_reflections(const ImpactSpace& space) {
  const double tolerance = 1e-13 * space.u_before.cwiseAbs().maxCoeff();
  VecX lambda = blended_normal_impulses(space, tolerance);
  add_friction(space, lambda);
  const VecX u = space.u_before + space.A * lambda;
  double closest = 0;
  for (std::size_t i = 0; i < space.count(); ++i) closest = std::min(closest, normal_part(u, i));
  if (closest >= -tolerance) return {lambda, 0, true, 1};
  const ImpactSolution last = solution_of(solve_cone_problem(space.A, u, space.mu));
  return {lambda + last.lambda, last.residual, last.converged, last.iterations};
}

bool is_one_pair(const ContactSystem& system) {
  std::set<std::pair<int, int>> pairs;
  for (const Contact& contact : system.contacts) pairs.insert({contact.body_A, contact.body_B});
  return pairs.size() == 1;
}

}  // namespace

ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            SimultaneousLaw law) {
  ImpactSpace space{delassus(system), relative_velocities(system), {}, restitutions};
  for (const Contact& contact : system.contacts) space.mu.push_back(contact.friction);
  const bool is_plastic =
      std::all_of(restitutions.begin(), restitutions.end(), [](double e) { return e == 0; });
  if (law == SimultaneousLaw::lcp || is_plastic || is_one_pair(system)) return solve_newton(space);
  return solve_reflections(space);
}

}  // namespace rigor
