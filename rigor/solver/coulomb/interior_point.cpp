#include "rigor/solver/coulomb/interior_point.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/solver/coulomb/second_order_cone.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rigor {

using Eigen::Index;

namespace {

/// A contact in the cone's coordinates: force x and rate y with their steps, and how y changes with the
/// motion.
struct ConeContact {
  // (n, t₁, t₂) of the cone from (t₁, t₂, n) by T: λ = Tᵀ x, w = T⁻¹ (y - |y_t| e₀). Its rows are (0, 0,
  // normal), (tangent, 0, 0) and (0, tangent, 0).
  double normal = 1;   ///< 1 / μ; of a contact without friction 1,
  double tangent = 0;  ///< and this 0 in place of 1.
  Vec3 b, x, y, dx = Vec3::Zero(), dy = Vec3::Zero();
  double square_x, square_y;  ///< jordan_squares.
  Mat3 W, inverse;            ///< Scaling of x and y.
  Mat3 stiffness;             ///< -dx / dy.
  Vec2 slope;                 ///< dy / d(T w) = 1 + e₀ (0, slope)ᵀ: what |w_t| adds.
  Vec3 misfit;                ///< y - |y_t| e₀ - T (L v) - b.
  Vec3 driven;                ///< dx where dy = 0.

  Vec3 to_cone(const Vec3& w) const { return {normal * w(2), tangent * w(0), tangent * w(1)}; }
  Vec3 from_cone(const Vec3& force) const {
    return {tangent * force(1), tangent * force(2), normal * force(0)};
  }
  /// The change of y when T w changes by this.
  Vec3 with_slope(const Vec3& change) const {
    return {change(0) + slope.dot(change.tail<2>()), change(1), change(2)};
  }
  /// -dλ / dw.
  Mat3 contact_stiffness() const {
    Mat3 K = stiffness;
    K.rightCols<2>() += stiffness.col(0) * slope.transpose();
    Mat3 D;
    D.topLeftCorner<2, 2>() = (tangent * tangent) * K.bottomRightCorner<2, 2>();
    D.topRightCorner<2, 1>() = (tangent * normal) * K.bottomLeftCorner<2, 1>();
    D.bottomLeftCorner<1, 2>() = (tangent * normal) * K.topRightCorner<1, 2>();
    D(2, 2) = normal * normal * K(0, 0);
    return D;
  }
};

class InteriorPoint {
 public:
  InteriorPoint(const CoulombProblem& laws, const ContactMotion& motion, const InteriorPointOptions& options)
      : motion_(motion), options_(options), contacts_(laws.mu.size()), D_(laws.mu.size()) {
    const VecX masses = effective_masses(motion.diagonal());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      ConeContact& contact = contacts_[k];
      const double mu = laws.mu[k];
      contact.normal = mu > 0 ? 1 / mu : 1;
      contact.tangent = mu > 0 ? 1 : 0;
      contact.b = contact.to_cone(laws.b.segment<3>(3 * static_cast<Index>(k)));
      speed_ = std::max(speed_, contact.b.cwiseAbs().maxCoeff());
    }
    // The start: all forces and rates on the axes of their cones.
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      ConeContact& contact = contacts_[k];
      contact.y = Vec3(speed_, 0, 0);
      contact.x = Vec3(masses(static_cast<Index>(k)) * speed_ / (contact.normal * contact.normal), 0, 0);
    }
    energy_ = speed_ * speed_ * masses.mean();
    rates_ = motion_.rates(motion_.apply_inverse_mass(motion_.apply_transpose(forces())));
  }

  std::optional<VecX> run() {
    constexpr double kShortest = 0.1;
    double length = 1;
    for (int step = 0; step < options_.most_steps; ++step) {
      poll_interrupt();
      count_work(contacts_.size());
      // It ends where it is near, and where what holds it back lets it go no farther.
      const double worst = misfit(), gap = mean_gap(0);
      const bool is_near = gap <= options_.gap * energy_ && worst <= std::sqrt(options_.gap) * speed_;
      if (is_near || length < kShortest) break;
      linearise();
      const std::optional<double> found = advance(gap);
      if (!found) return std::nullopt;
      length = *found;
    }
    return forces();
  }

 private:
  /// λ (3n).
  VecX forces() const {
    VecX lambda(3 * static_cast<Index>(contacts_.size()));
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      lambda.segment<3>(3 * static_cast<Index>(k)) = contacts_[k].from_cone(contacts_[k].x);
    return lambda;
  }

  /// Mean of x · y after so long a step.
  double mean_gap(double length) const {
    double sum = 0;
    for (const ConeContact& contact : contacts_)
      sum += (contact.x + length * contact.dx).dot(contact.y + length * contact.dy);
    return sum / static_cast<double>(contacts_.size());
  }

  /// How the rates y miss those of the motion; returns the largest miss.
  double misfit() {
    constexpr double kRounding = 1e-10;
    double worst = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      ConeContact& contact = contacts_[k];
      const double rounding = kRounding * speed_;
      const double slip = std::sqrt(contact.y.tail<2>().squaredNorm() + rounding * rounding);
      contact.slope = (1 / slip) * contact.y.tail<2>();
      contact.misfit = contact.y - contact.to_cone(rates_.segment<3>(3 * static_cast<Index>(k))) - contact.b;
      contact.misfit(0) -= slip;
      worst = std::max(worst, contact.misfit.cwiseAbs().maxCoeff());
    }
    return worst;
  }

  /// W dx + W⁻¹ dy is given, so dx = driven - W⁻² dy; with dy = slope (T L dv - misfit) what is left is one
  /// system for dv.
  void linearise() {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      ConeContact& contact = contacts_[k];
      contact.square_x = jordan_square(contact.x);
      contact.square_y = jordan_square(contact.y);
      const NesterovToddScaling scaling(contact.x, contact.square_x, contact.y, contact.square_y);
      contact.W = scaling.W;
      contact.inverse = scaling.inverse;
      contact.stiffness = scaling.inverse_square;
      D_[k] = contact.contact_stiffness();
    }
    motion_.factor(D_, Symmetry::none);
  }

  /// Steps of all contacts from `driven`; the rates of the motion's step.
  void direct() {
    lambda_.resize(rates_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const ConeContact& contact = contacts_[k];
      const Vec3 missing = contact.with_slope(contact.misfit);
      lambda_.segment<3>(3 * static_cast<Index>(k)) =
          contact.from_cone(contact.driven + contact.stiffness * missing);
    }
    motion_.apply_transpose(lambda_, momentum_);
    motion_.solve(momentum_, motion_step_);
    motion_.rates(motion_step_, rates_step_);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      ConeContact& contact = contacts_[k];
      const Vec3 rate = contact.to_cone(rates_step_.segment<3>(3 * static_cast<Index>(k)));
      contact.dy = contact.with_slope(rate - contact.misfit);
      contact.dx = contact.driven - contact.stiffness * contact.dy;
    }
  }

  double length_to_border(double most) const {
    for (const ConeContact& contact : contacts_)
      most = std::min({most, step_to_border(contact.x, contact.square_x, contact.dx),
                       step_to_border(contact.y, contact.square_y, contact.dy)});
    return most;
  }

  /// Mehrotra's step: how far the way to x · y = 0 leads says how much of the gap to keep, and what it bends.
  /// Returns its length.
  std::optional<double> advance(double gap) {
    constexpr double kInside = 0.99;
    // Straight to x · y = 0.
    for (ConeContact& contact : contacts_) contact.driven = -contact.x;
    direct();
    const double share = std::clamp(mean_gap(length_to_border(1)) / gap, 0.0, 1.0);

    // To a share of the gap, with what the products of the first step leave.
    const Vec3 centre(share * share * share * gap, 0, 0);
    for (ConeContact& contact : contacts_) {
      const Vec3 bend = jordan_product(contact.inverse * contact.dy, contact.W * contact.dx);
      contact.driven += contact.inverse * jordan_quotient(centre - bend, contact.W * contact.x);
    }
    direct();
    if (!rates_step_.allFinite()) return std::nullopt;

    // As far as all stay inside.
    const double length = kInside * length_to_border(1 / kInside);
    for (ConeContact& contact : contacts_) {
      contact.x += length * contact.dx;
      contact.y += length * contact.dy;
    }
    rates_ += length * rates_step_;
    return length;
  }

  const ContactMotion& motion_;
  const InteriorPointOptions& options_;
  std::vector<ConeContact> contacts_;
  std::vector<Mat3> D_;  ///< Of the Newton step.
  double speed_ = 0;     ///< Largest of b.
  double energy_ = 0;    ///< speed² times the mean mass.
  VecX rates_, rates_step_, momentum_, motion_step_, lambda_;
};

}  // namespace

std::optional<VecX> interior_forces(const CoulombProblem& laws, const ContactMotion& motion,
                                    const InteriorPointOptions& options) {
  const bool are_free = std::all_of(laws.rows.begin(), laws.rows.end(),
                                    [](FrictionRow row) { return row == FrictionRow::cone; });
  if (!are_free || laws.b.isZero(0)) return std::nullopt;
  std::optional<VecX> forces = InteriorPoint(laws, motion, options).run();
  return forces && forces->allFinite() ? forces : std::nullopt;
}

}  // namespace rigor
