#include "rigor/contact/impact/tangential_compliance.hpp"

#include "rigor/core/assert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

constexpr double quarter = 0.5 * std::numbers::pi;
constexpr double fastest = 100;  ///< Tangential by normal frequency: each swing can slip and stick.
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The normal force cos(ν y) of compression or restitution.
struct NormalPhase {
  double rate;        ///< ν.
  double begin, end;  ///< Of y.

  double force(double y) const { return std::cos(rate * y); }
  double force_rate(double y) const { return -rate * std::sin(rate * y); }
};

/// Tangential motion along u_t⁻, without units: speed u of the bodies by |u_n⁻|, deflection x of the spring
/// by |u_n⁻|/ω_n, and its force -r x by that of the greatest compression. So u' = -α r x, α = M/κ.
struct TangentialMotion {
  double y = -quarter;
  double u = 0, x = 0;
  int slip = 0;
};

class CompliantImpactPath {
 public:
  CompliantImpactPath(double alpha, double ratio, double mu) : alpha_(alpha), ratio_(ratio), mu_(mu) {}

  /// Sticks at first if the spring's force grows more slowly than friction, r u < μ.
  TangentialMotion begin(double u) const {
    const double excess = ratio_ * std::abs(u) - mu_;
    const bool sticks = excess < 0 || (excess == 0 && alpha_ * ratio_ > 1);
    return {.u = u, .slip = sticks ? 0 : u > 0 ? 1 : -1};
  }

  /// The motion at y, with nothing but the present slip or stick since `from`.
  TangentialMotion moved(const NormalPhase& phase, const TangentialMotion& from, double y) const {
    TangentialMotion to = from;
    to.y = y;
    // Slip: the spring carries the limit μ cos(ν y), whose impulse brakes the bodies. Stick: x' = u and
    // u' = -α r x, an oscillation.
    if (from.slip != 0) {
      to.x = mu_ * from.slip * phase.force(y) / ratio_;
      const double impulse = (std::sin(phase.rate * y) - std::sin(phase.rate * from.y)) / phase.rate;
      to.u = from.u - alpha_ * mu_ * from.slip * impulse;
    } else {
      const double omega = std::sqrt(alpha_ * ratio_), angle = omega * (y - from.y);
      to.x = from.x * std::cos(angle) + from.u / omega * std::sin(angle);
      to.u = from.u * std::cos(angle) - from.x * omega * std::sin(angle);
    }
    return to;
  }

  /// The motion where slip or stick ends, or at the end of the phase.
  TangentialMotion next(const NormalPhase& phase, const TangentialMotion& from) const {
    return from.slip != 0 ? after_slip(phase, from) : after_stick(phase, from);
  }

 private:
  TangentialMotion after_slip(const NormalPhase& phase, const TangentialMotion& from) const {
    // Slip u - x' is linear in sin(ν y); it shrinks where the spring is stiff enough, α r > ν².
    const double nu = phase.rate;
    const double shrinking = mu_ * (alpha_ / nu - nu / ratio_);
    const double sine = (from.slip * from.u + alpha_ * mu_ * std::sin(nu * from.y) / nu) / shrinking;
    if (!(shrinking > 0) || !(sine < std::sin(nu * phase.end))) return moved(phase, from, phase.end);
    TangentialMotion to = moved(phase, from, std::max(from.y, std::asin(std::max(-1.0, sine)) / nu));
    to.slip = 0;
    return to;
  }

  TangentialMotion after_stick(const NormalPhase& phase, const TangentialMotion& from) const {
    if (!std::isfinite(mu_)) return moved(phase, from, phase.end);
    const double forwards = end_of_stick(phase, from, 1), backwards = end_of_stick(phase, from, -1);
    const double y = std::min(forwards, backwards);
    TangentialMotion to = moved(phase, from, std::min(y, phase.end));
    if (y > phase.end) return to;
    to.slip = forwards < backwards ? 1 : -1;
    to.x = mu_ * to.slip * phase.force(to.y) / ratio_;
    return to;
  }

  /// First y at which the force of the spring leaves the cone on that side; infinite if not in this phase.
  /// The margin F(y) = μ cos(ν y) - side r x(y) has |F''| ≤ C, so it stays positive for a step h with
  /// F + F' h - ½ C h² = 0: near the end this is Newton's method. Rounding of F counts as positive.
  double end_of_stick(const NormalPhase& phase, const TangentialMotion& from, int side) const {
    constexpr int most_steps = 20000;
    const double omega2 = alpha_ * ratio_;
    const double amplitude = ratio_ * std::hypot(from.x, from.u / std::sqrt(omega2));
    const double bend = mu_ * phase.rate * phase.rate + omega2 * amplitude;
    const double noise = 8 * epsilon * (mu_ + amplitude);
    double y = from.y;
    for (int step = 0; step < most_steps && y <= phase.end; ++step) {
      const TangentialMotion at = moved(phase, from, y);
      const double margin = mu_ * phase.force(y) - side * ratio_ * at.x + noise;
      const double slope = mu_ * phase.force_rate(y) - side * ratio_ * at.u;
      if (!(margin > 0)) return y;
      const double root = std::sqrt(slope * slope + 2 * bend * margin);
      // The same root both ways, without cancellation.
      const double h = slope > 0 ? (root + slope) / bend : 2 * margin / (root - slope);
      if (h <= 2 * epsilon) return y;
      y += h;
    }
    return y <= phase.end ? y : std::numeric_limits<double>::infinity();
  }

  double alpha_, ratio_, mu_;
};

/// The impact path in physical units.
class ImpactPathScale {
 public:
  explicit ImpactPathScale(const Collision& collision)
      : collision_(collision), kappa_(collision.matrix.K(2, 2)), approach_(-collision.u.z()) {
    const Vec2 slip = collision.u.head<2>();
    if (slip.norm() > 0) direction_ = slip.normalized();
    inertia_ = direction_.dot(collision.matrix.K.topLeftCorner<2, 2>() * direction_);
  }

  double alpha() const { return inertia_ / kappa_; }
  double start() const { return collision_.u.head<2>().norm() / approach_; }
  CollisionPoint at(const NormalPhase& phase, const TangentialMotion& motion) const {
    const double angle = phase.rate * motion.y;
    CollisionPoint point;
    point.u << approach_ * motion.u * direction_, approach_ * std::sin(angle) / phase.rate;
    const double tangential = approach_ * (motion.u - start());
    point.lambda << tangential / inertia_ * direction_,
        approach_ / kappa_ * (1 + std::sin(angle) / phase.rate);
    point.work = 0.5 * (point.u.z() * point.u.z() - approach_ * approach_) / kappa_;
    return point;
  }

 private:
  const Collision& collision_;
  double kappa_, approach_;
  Vec2 direction_ = Vec2::UnitX();
  double inertia_;
};

}  // namespace

std::string check_compliant_collision(const CompliantCollision& compliant) {
  constexpr double rounding = 1e-12;
  const Mat3& K = compliant.collision.matrix.K;
  const double size = K.cwiseAbs().maxCoeff();
  if (K.topRightCorner<2, 1>().norm() > rounding * size) {
    return fmt::format(
        "the compliant law needs normal and tangential motion without coupling (K13 = K23 = 0); "
        "here K13 is {:g} and K23 {:g}",
        K(0, 2), K(1, 2));
  }
  const Vec2 slip = compliant.collision.u.head<2>();
  const Vec2 direction = slip.norm() > 0 ? Vec2(slip.normalized()) : Vec2::UnitX();
  const Vec2 rate = K.topLeftCorner<2, 2>() * direction;
  const double across = direction.x() * rate.y() - direction.y() * rate.x();
  if (slip.norm() > 0 && std::abs(across) > rounding * size) {
    return "the compliant law needs slip along a principal direction of the tangential part of K (any, if "
           "K11 = K22 and K12 = 0)";
  }
  if (!(direction.dot(rate) > 0)) return "the compliant law needs K11 and K22 > 0";
  const double alpha = direction.dot(rate) / K(2, 2);
  if (!(alpha * compliant.ratio <= fastest * fastest)) {
    return fmt::format(
        "the compliant law needs a tangential spring at most {:g} times as fast as the normal one; "
        "here the square root of M k_t/(K33 k_n) is {:g}",
        fastest, std::sqrt(alpha * compliant.ratio));
  }
  return {};
}

CompliantOutcome resolve_compliant_collision(const CompliantCollision& compliant,
                                             std::vector<CollisionPoint>* path) {
  constexpr int most_changes = 10000, points = 24;
  const Collision& collision = compliant.collision;
  const double e = collision.restitution;
  RIGOR_ASSERT(compliant.ratio > 0 && e >= 0 && e <= 1 && collision.matrix.mu >= 0);
  RIGOR_ASSERT(check_compliant_collision(compliant).empty());
  CompliantOutcome outcome;
  outcome.end.u = collision.u;
  if (path) path->push_back(outcome.end);
  if (collision.u.z() >= 0) return outcome;

  // Without units: times in 1/ω_n, speeds in that of the approach.
  const ImpactPathScale scale(collision);
  const CompliantImpactPath impact(scale.alpha(), compliant.ratio, collision.matrix.mu);
  TangentialMotion motion = impact.begin(scale.start());
  outcome.changes.push_back({0, motion.slip});

  // Compression and restitution, each from one change between slip and stick to the next.
  for (const NormalPhase& phase :
       {NormalPhase{1, -quarter, 0}, NormalPhase{e > 0 ? 1 / e : 1, 0, e * quarter}}) {
    for (int change = 0; motion.y < phase.end && change < most_changes; ++change) {
      const TangentialMotion next = impact.next(phase, motion);
      for (int k = 1; path && k <= points; ++k) {
        const double y = motion.y + (next.y - motion.y) * k / points;
        path->push_back(scale.at(phase, impact.moved(phase, motion, y)));
      }
      if (next.slip != motion.slip)
        outcome.changes.push_back({next.y + quarter, next.slip, scale.at(phase, next).lambda.z()});
      motion = next;
    }
    outcome.is_resolved = outcome.is_resolved && motion.y >= phase.end;
    outcome.end = scale.at(phase, motion);
    if (phase.begin < 0) outcome.compression = outcome.end;
  }

  // u_n as the law names it, without the rounding of sin(π/2).
  outcome.end.u.z() = -e * collision.u.z();
  outcome.energy_change = 0.5 * outcome.end.lambda.dot(collision.u + outcome.end.u);
  return outcome;
}

}  // namespace rigor
