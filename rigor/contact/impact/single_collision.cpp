#include "rigor/contact/impact/single_collision.hpp"

#include "rigor/contact/impact/algebraic_impact.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/math/dense.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Of the fastest approach: slower is rounding.
constexpr double still = 1e-10;

/// Contacts that share the load of a collision, with their shares.
struct Patch {
  std::vector<std::size_t> contacts;
  std::vector<double> weights;  ///< w, sum 1.
};

bool is_same_patch(const ImpactContact& a, const ImpactContact& b) {
  constexpr double rounding = 1e-12;  // Of unit vectors.
  return a.lower == b.lower && a.higher == b.higher && (a.n_W() - b.n_W()).norm() <= rounding;
}

/// All contacts like the first that approaches; empty if another approaches too.
std::vector<std::size_t> candidates(const ImpactProblem& problem) {
  const double tolerance = still * fastest_approach(problem.u);
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    if (normal_velocity(problem.u, i) >= -tolerance) continue;
    if (!first) first = i;
    if (!is_same_patch(problem.contacts[*first], problem.contacts[i])) return {};
  }
  std::vector<std::size_t> alike;
  for (std::size_t i = 0; first && i < problem.count(); ++i) {
    if (is_same_patch(problem.contacts[*first], problem.contacts[i])) alike.push_back(i);
  }
  return alike;
}

/// The contacts alike that carry load in the plastic impact; their shares of it are the weights w.
std::optional<Patch> find_patch(const ImpactProblem& problem) {
  const std::vector<std::size_t> alike = candidates(problem);
  if (alike.empty()) return std::nullopt;
  if (alike.size() == 1) return Patch{alike, {1.0}};
  const ImpactProblem part = part_of(problem, alike, problem.u);
  const CoulombSolution plastic = solve_cones(part.A.dense(), part.u, frictions(part));
  if (!plastic.converged) return std::nullopt;
  Patch patch;
  double sum = 0;
  for (std::size_t i = 0; i < alike.size(); ++i) {
    const double normal = plastic.lambda[row_of(i) + 2];
    if (normal <= 0) continue;
    patch.contacts.push_back(alike[i]);
    patch.weights.push_back(normal);
    sum += normal;
  }
  for (double& weight : patch.weights) weight /= sum;
  return patch;
}

bool has_one_material(const ImpactProblem& problem, const Patch& patch) {
  const ImpactContact& first = problem.contacts[patch.contacts.front()];
  return std::all_of(patch.contacts.begin(), patch.contacts.end(), [&](std::size_t i) {
    const ImpactContact& contact = problem.contacts[i];
    return contact.mu == first.mu && contact.restitution == first.restitution &&
           contact.tangential_restitution == first.tangential_restitution;
  });
}

/// 3n × 3: impulses of all contacts for a unit impulse at the centre of pressure, in the frame of the first.
MatX load_shares(const ImpactProblem& problem, const Patch& patch) {
  MatX shares = MatX::Zero(problem.u.size(), 3);
  const Mat3& frame = problem.contacts[patch.contacts.front()].frame;
  for (std::size_t k = 0; k < patch.contacts.size(); ++k) {
    const std::size_t i = patch.contacts[k];
    shares.middleRows<3>(row_of(i)) = patch.weights[k] * (problem.contacts[i].frame.transpose() * frame);
  }
  return shares;
}

/// Whether the points with friction slip about alike: |u_i - u_q| ≤ ½ |u_q|, directions within 30 degrees.
bool slips_as_one(const ImpactProblem& problem, const Patch& patch, const MatX& shares) {
  if (problem.contacts[patch.contacts.front()].mu == 0) return true;
  const Mat3& frame = problem.contacts[patch.contacts.front()].frame;
  const Vec2 mean = (shares.transpose() * problem.u).head<2>();
  const double rounding = still * problem.u.cwiseAbs().maxCoeff();
  return std::all_of(patch.contacts.begin(), patch.contacts.end(), [&](std::size_t i) {
    const Vec3 u = frame.transpose() * problem.contacts[i].frame * problem.u.segment<3>(row_of(i));
    return (u.head<2>() - mean).norm() <= 0.5 * mean.norm() + rounding;
  });
}

struct Collided {
  Vec3 lambda;
  bool is_resolved;
  std::string phases;
};

/// With a tangential restitution the algebraic law, else friction integrated over the impact.
Collided collide(const Mat3& K, const Vec3& u, const ImpactContact& contact, RestitutionLaw law) {
  const Collision collision{{K, contact.mu}, u, contact.restitution};
  if (contact.tangential_restitution > 0 && is_positive_definite(K)) {
    return {resolve_algebraic_impact(collision, contact.tangential_restitution).lambda, true, {}};
  }
  const CollisionOutcome outcome = resolve_collision(collision, law);
  return {outcome.end.lambda, outcome.is_resolved, outcome.phases};
}

}  // namespace

ImpactSolution resolve_lone_contact(const ImpactProblem& problem, RestitutionLaw law) {
  RIGOR_ASSERT(problem.count() == 1);
  const ImpactContact& contact = problem.contacts[0];
  const Collided collided = collide(problem.A.block(0, 0), problem.u, contact, law);
  return {collided.lambda, 0, collided.is_resolved, 1, {}, collided.phases};
}

std::optional<ImpactSolution> find_single_collision(const ImpactProblem& problem, RestitutionLaw law) {
  // The patch that may collide as one.
  const std::optional<Patch> patch = find_patch(problem);
  if (!patch || patch->contacts.empty() || !has_one_material(problem, *patch)) return std::nullopt;
  const MatX shares = load_shares(problem, *patch);
  if (!slips_as_one(problem, *patch, shares)) return std::nullopt;

  // Its collision at the centre of pressure, K = Σ w_i w_k A_ik.
  const ImpactContact& contact = problem.contacts[patch->contacts.front()];
  MatX moved(shares.rows(), 3);
  for (Eigen::Index axis = 0; axis < 3; ++axis) moved.col(axis) = problem.A * VecX(shares.col(axis));
  Mat3 K = shares.transpose() * moved;
  K = 0.5 * (K + K.transpose()).eval();
  const Collided collided = collide(K, shares.transpose() * problem.u, contact, law);
  if (!collided.is_resolved) return std::nullopt;

  // It was one collision only if nothing approaches afterwards.
  const VecX lambda = shares * collided.lambda;
  const VecX u = problem.u + problem.A * lambda;
  if (fastest_approach(u) > still * fastest_approach(problem.u)) return std::nullopt;
  return ImpactSolution{lambda, 0, true, 1, {}, collided.phases};
}

}  // namespace rigor
