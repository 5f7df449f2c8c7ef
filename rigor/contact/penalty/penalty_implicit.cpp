#include "rigor/contact/penalty/penalty_implicit.hpp"

#include "rigor/solver/linear/node_system.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

namespace {

constexpr int most_iterations = 60;
constexpr double tolerance = 1e-11;

/// What a contact may give of the impulse that its springs ask for, and its derivative.
struct Allowed {
  Vec3 impulse = Vec3::Zero();
  Mat3 slope = Mat3::Zero();
};

Allowed allowed(const ImplicitSpring& spring, const Vec3& asked, double h) {
  Allowed result;
  // The normal spring pushes and never pulls.
  const bool pushes = spring.has_normal && asked.z() > 0;
  if (pushes) {
    result.impulse.z() = asked.z();
    result.slope(2, 2) = 1;
  }
  // Friction holds up to its limit, which grows with the normal impulse; beyond it has the direction of what
  // is asked.
  const double limit = spring.has_normal ? spring.friction * result.impulse.z() : h * spring.limit;
  const Vec2 tangential = asked.head<2>();
  const double size = tangential.norm();
  if (size <= limit) {
    result.impulse.head<2>() = tangential;
    result.slope.topLeftCorner<2, 2>().setIdentity();
  } else if (limit > 0) {
    const Vec2 direction = tangential / size;
    result.impulse.head<2>() = limit * direction;
    result.slope.topLeftCorner<2, 2>() =
        limit / size * (Mat2::Identity() - direction * direction.transpose());
    if (pushes) result.slope.topRightCorner<2, 1>() = spring.friction * direction;
  }
  return result;
}

class SpringRows {
 public:
  SpringRows(const ContactRows& rows, const VecX& u_free, const std::vector<ImplicitSpring>& springs,
             double h, double theta)
      : rows_(rows),
        plan_(elimination_plan(rows)),
        diagonal_(free_diagonal(rows)),
        u_free_(u_free),
        springs_(springs),
        h_(h),
        theta_(theta) {}

  /// j - allowed(h (f - S u_θ)).
  VecX residual(const VecX& j) const {
    const VecX u = velocities(j);
    VecX F(j.size());
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      const Eigen::Index k = 3 * static_cast<Eigen::Index>(i);
      F.segment<3>(k) = j.segment<3>(k) - allowed(springs_[i], asked(i, u), h_).impulse;
    }
    return F;
  }

  /// Of j + step and j + parts of the step the one with the smallest error of velocities: whole steps can
  /// alternate between two active sets.
  VecX best_along(const VecX& j, const VecX& step) const {
    VecX best = j + step;
    double least = error(best);
    const double before = error(j);
    for (double length = 0.5; !(least < before) && length > 0.01; length *= 0.5) {
      const VecX candidate = j + length * step;
      const double own = error(candidate);
      if (own < least) {
        least = own;
        best = candidate;
      }
    }
    return best;
  }

  VecX within_cones(const VecX& j) const {
    VecX result(j.size());
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      const Eigen::Index k = 3 * static_cast<Eigen::Index>(i);
      result.segment<3>(k) = allowed(springs_[i], j.segment<3>(k), h_).impulse;
    }
    return result;
  }

  /// x with (1 + W A) x = -F, the derivative of the residual F at j, W = h θ (slope of allowed) S: with
  /// z = M⁻¹ Jᵀ x it is (M + Jᵀ W J) z = -Jᵀ F, x = -F - W J z. Not finite where that is singular.
  VecX newton_step(const VecX& j, const VecX& F) const {
    const VecX u = velocities(j);
    std::vector<Mat3> W;
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      const Mat3 slope = allowed(springs_[i], asked(i, u), h_).slope;
      W.push_back(h_ * theta_ * slope * springs_[i].resistance.asDiagonal());
    }
    constexpr bool is_symmetric = false;  // What slides is not.
    const NodeSystem nodes(rows_, plan_, W, 1, is_symmetric);
    if (!nodes.is_regular()) return VecX::Constant(F.size(), std::numeric_limits<double>::quiet_NaN());
    const VecX rates = contact_rates(rows_, nodes.solve(contact_wrenches(rows_, -F)));
    VecX x = -F;
    for (std::size_t i = 0; i < W.size(); ++i) {
      const Eigen::Index k = 3 * static_cast<Eigen::Index>(i);
      x.segment<3>(k) -= W[i] * rates.segment<3>(k);
    }
    return x;
  }

 private:
  /// u_θ = u_free + θ A j.
  VecX velocities(const VecX& j) const {
    const VecX wrenches = with_joints(rows_, contact_wrenches(rows_, j));
    return u_free_ + theta_ * contact_rates(rows_, node_accelerations(rows_, wrenches));
  }

  Vec3 asked(std::size_t i, const VecX& u) const {
    const Vec3 own = u.segment<3>(3 * static_cast<Eigen::Index>(i));
    return h_ * (springs_[i].force - springs_[i].resistance.cwiseProduct(own));
  }

  /// Norm of the residual, each row over what an impulse changes it by.
  double error(const VecX& j) const {
    const VecX F = residual(j);
    double sum = 0;
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        const Eigen::Index row = 3 * static_cast<Eigen::Index>(i) + k;
        const double scaled = F[row] / (1 + h_ * theta_ * springs_[i].resistance[k] * diagonal_[row]);
        sum += scaled * scaled * diagonal_[row];
      }
    }
    return sum;
  }

  const ContactRows& rows_;
  EliminationPlan plan_;
  VecX diagonal_;  ///< Of A, without joints.
  const VecX& u_free_;
  const std::vector<ImplicitSpring>& springs_;
  double h_, theta_;
};

}  // namespace

ImplicitSpringSolution solve_implicit_springs(const ContactRows& contacts, const VecX& u_free,
                                              const std::vector<ImplicitSpring>& springs, double h,
                                              double theta) {
  const SpringRows rows(contacts, u_free, springs, h, theta);
  ImplicitSpringSolution best;
  VecX j = VecX::Zero(u_free.size());
  best.impulses = j;
  best.residual = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration <= most_iterations; ++iteration) {
    // The residual at j, relative to the impulses; the best point so far is kept.
    const VecX F = rows.residual(j);
    const double scale = std::max(j.cwiseAbs().maxCoeff(), (j - F).cwiseAbs().maxCoeff());
    const double residual = scale > 0 ? F.cwiseAbs().maxCoeff() / scale : 0;
    if (residual < best.residual) {
      best.impulses = rows.within_cones(j);
      best.residual = residual;
    }
    best.iterations = iteration;
    best.converged = best.residual <= tolerance;
    if (best.converged || iteration == most_iterations) break;

    // A semismooth Newton step, as far as it helps.
    const VecX step = rows.newton_step(j, F);
    if (!step.allFinite()) break;
    j = rows.best_along(j, step);
  }
  return best;
}

}  // namespace rigor
