#include "rigor/solver/motion/motion_modes.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/solver/coulomb/cone.hpp"

#include <cmath>
#include <limits>

namespace rigor {

using Eigen::Index;

namespace {

// Parts of A's largest entry that make the node matrices regular. What they do to the solution the next round
// takes away, by about their ratio to the stiffness of the contacts; but motions that the contacts leave free
// are known to round-off divided by them. So the larger one comes first, and the smaller one where it is
// slow.
constexpr double kRegular = 1e-9;
constexpr double kLessRegular = 1e-12;

Vec3 generator_of(double mu, const Vec2& slip) {
  if (mu == 0) return Vec3::UnitZ();
  return Vec3(-mu * slip(0), -mu * slip(1), 1.0) / std::sqrt(1.0 + mu * mu);
}

}  // namespace

MotionModesSystem::MotionModesSystem(const MotionProblem& problem, const EliminationPlan& plan,
                                     const ContactModes& modes)
    : problem_(problem),
      plan_(plan),
      modes_(modes.modes),
      generators_(modes.modes.size(), Vec3::Zero()),
      lambda_(VecX::Zero(problem.laws.b.size())),
      z_(VecX::Zero(6 * static_cast<Index>(problem.rows.node_count()))) {
  const VecX diagonal = free_diagonal(problem.rows);
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    if (modes_[k] == ContactMode::slide) generators_[k] = generator_of(problem.laws.mu[k], modes.slips[k]);
    if (modes_[k] != ContactMode::open)
      scale_ = std::max(scale_, diagonal.segment<3>(3 * static_cast<Index>(k)).maxCoeff());
  }
  if (scale_ > 0) iterate();
}

// D Dᵀ c and its like: what of the contacts' vectors the forces can make, and what the equations see.
VecX MotionModesSystem::restrict_to_forces(const VecX& contacts) const {
  VecX restricted = VecX::Zero(contacts.size());
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] == ContactMode::stick) restricted.segment<3>(row) = contacts.segment<3>(row);
    if (modes_[k] == ContactMode::slide)
      restricted.segment<3>(row) = generators_[k].dot(contacts.segment<3>(row)) * generators_[k];
  }
  return restricted;
}

VecX MotionModesSystem::restrict_to_equations(const VecX& contacts) const {
  VecX restricted = VecX::Zero(contacts.size());
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] == ContactMode::stick) restricted.segment<3>(row) = contacts.segment<3>(row);
    if (modes_[k] == ContactMode::slide) restricted(row + 2) = contacts(row + 2);
  }
  return restricted;
}

// D r: a sliding contact's miss acts along its force.
VecX MotionModesSystem::expand_equations(const VecX& misses) const {
  VecX expanded = misses;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] == ContactMode::slide) expanded.segment<3>(row) = misses(row + 2) * generators_[k];
  }
  return expanded;
}

double MotionModesSystem::size_of_terms(const VecX& lambda) const {
  return std::max(problem_.laws.b.cwiseAbs().maxCoeff(), largest_term(problem_.rows, lambda));
}

/// A λ + b.
VecX MotionModesSystem::rates_of(const VecX& lambda) const {
  const ContactRows& rows = problem_.rows;
  const VecX p = with_joints(rows, contact_wrenches(rows, lambda));
  return contact_rates(rows, node_accelerations(rows, p)) + problem_.laws.b;
}

void MotionModesSystem::iterate() {
  std::vector<Mat3> forces(modes_.size(), Mat3::Zero()), equations = forces;
  bool is_symmetric = true;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    if (modes_[k] == ContactMode::stick) forces[k] = equations[k] = Mat3::Identity();
    if (modes_[k] != ContactMode::slide) continue;
    forces[k] = generators_[k] * generators_[k].transpose();
    equations[k] = generators_[k] * Vec3::UnitZ().transpose();
    is_symmetric = is_symmetric && problem_.laws.mu[k] == 0;
  }
  miss_ = std::numeric_limits<double>::infinity();
  for (const double regular : {kRegular, kLessRegular}) {
    const NodeSystem to_forces(problem_.rows, plan_, forces, regular * scale_, true);
    if (!to_forces.is_regular()) return;
    if (is_symmetric) {
      refine(to_forces, to_forces);
    } else {
      const NodeSystem to_motion(problem_.rows, plan_, equations, regular * scale_, false);
      if (to_motion.is_regular()) refine(to_motion, to_forces);
    }
    if (is_exact()) return;
  }
}

void MotionModesSystem::refine(const NodeSystem& to_motion, const NodeSystem& to_forces) {
  constexpr int kMaxRounds = 10;
  const ContactRows& rows = problem_.rows;
  VecX lambda = lambda_, z = z_;
  double least = std::numeric_limits<double>::infinity(), negligible = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    // The misses of the equations; rounds continue while these fall.
    const bool is_at_zero = round == 0 && lambda.isZero(0);
    const VecX w = is_at_zero ? problem_.laws.b : rates_of(lambda);
    const VecX misses = restrict_to_equations(-w);
    const double miss = misses.cwiseAbs().maxCoeff();
    if (round > 0 && !(miss < 0.7 * least)) break;
    least = miss;
    lambda_ = lambda;
    z_ = z;
    // The terms hardly change after the first round.
    if (round <= 1)
      negligible = 0.5 * kEpsilon * (is_at_zero ? w.cwiseAbs().maxCoeff() : size_of_terms(lambda));
    if (miss <= negligible) break;

    // Accelerations a that take away the misses, and forces along the force directions that make them.
    const VecX a = to_motion.solve(contact_wrenches(rows, expand_equations(misses)));
    const VecX dz = to_forces.solve(node_wrenches(rows, a));
    z += dz;
    lambda += restrict_to_forces(contact_rates(rows, dz));
  }
  miss_ = least / size_of_terms(lambda_);
}

// Nearest λ in the cones: Coulomb cone for a stick contact, half-line for a slide.
VecX MotionModesSystem::project(const VecX& lambda) const {
  VecX projected = VecX::Zero(lambda.size());
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    const Vec3 force = lambda.segment<3>(row);
    if (modes_[k] == ContactMode::stick)
      projected.segment<3>(row) = project_on_cone(force, problem_.laws.mu[k]);
    if (modes_[k] == ContactMode::slide)
      projected.segment<3>(row) = std::max(0.0, generators_[k].dot(force)) * generators_[k];
  }
  return projected;
}

std::vector<Mat3> MotionModesSystem::projection_weights(const VecX& lambda) const {
  std::vector<Mat3> weights(modes_.size(), Mat3::Zero());
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Vec3 force = lambda.segment<3>(3 * static_cast<Index>(k));
    if (modes_[k] == ContactMode::stick) weights[k] = cone_projection_derivative(force, problem_.laws.mu[k]);
    if (modes_[k] == ContactMode::slide && generators_[k].dot(force) > 0)
      weights[k] = generators_[k] * generators_[k].transpose();
  }
  return weights;
}

MotionModesSystem::Dual MotionModesSystem::evaluate(const VecX& z, const VecX& p) const {
  Dual dual{z, project(restrict_to_forces(contact_rates(problem_.rows, z))), VecX(), 0.0};
  dual.gradient = with_joints(problem_.rows, contact_wrenches(problem_.rows, dual.lambda)) - p;
  dual.value = 0.5 * dual.lambda.squaredNorm() - p.dot(z);
  return dual;
}

// The least-norm point of {x : E x = p} in a cone C is proj_C(Eᵀ z) where z minimises the convex, once
// differentiable  φ(z) = ½|proj_C(Eᵀ z)|² - pᵀz:  Newton's method with a line search. Without such a point z
// grows without bound.
std::optional<VecX> MotionModesSystem::find_in_cones(int patience) const {
  constexpr int kMaxSteps = 40;
  constexpr double kRunaway = 1e6;
  if (!is_exact()) return std::nullopt;
  const VecX nearest = project(lambda_);
  if ((nearest - lambda_).norm() <= 2 * kEpsilon * lambda_.norm()) return nearest;
  const ContactRows& rows = problem_.rows;
  const VecX p = with_joints(rows, contact_wrenches(rows, lambda_));
  const double size = size_of_terms(lambda_);
  const auto error_of = [&](const Dual& dual) {
    return contact_rates(rows, node_accelerations(rows, dual.gradient)).cwiseAbs().maxCoeff() / size;
  };
  Dual at = evaluate(z_, p);
  double error = error_of(at);
  double least_error = error;
  for (int step = 0, stalls = 0; step < kMaxSteps && error > 4 * kEpsilon; ++step) {
    if (!(at.lambda.norm() <= kRunaway * lambda_.norm())) return std::nullopt;

    // Newton's direction; the matrix is made regular by a little that vanishes with the error.
    const double softening = scale_ * (1e-3 * std::min(1e-3, error) + kLessRegular);
    const NodeSystem hessian(rows, plan_, projection_weights(restrict_to_forces(contact_rates(rows, at.z))),
                             softening, true);
    if (!hessian.is_regular()) return std::nullopt;
    const VecX direction = -hessian.solve(at.gradient);
    const double slope = at.gradient.dot(direction);
    double length = 1;
    Dual trial = evaluate(at.z + direction, p);
    double trial_error = error_of(trial);
    const auto is_better = [&] {
      return trial.value <= at.value + 1e-4 * length * slope || trial_error <= 0.5 * error;
    };

    // Halving until the value falls enough, or, near the minimum, the error does.
    for (int halving = 0; halving < 30 && !is_better(); ++halving) {
      length *= 0.5;
      trial = evaluate(at.z + length * direction, p);
      trial_error = error_of(trial);
    }
    if (!is_better()) break;
    at = std::move(trial);
    error = trial_error;
    stalls = error < 0.5 * least_error ? 0 : stalls + 1;
    least_error = std::min(least_error, error);
    if (stalls > patience) break;
  }
  return error <= kExact ? std::optional<VecX>(at.lambda) : std::nullopt;
}

}  // namespace rigor
