#include "rigor/contact/impact/impact_piece.hpp"

#include "rigor/math/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

double value_of(const NormalMotion& motion, ImpactQuantity quantity) {
  switch (quantity) {
    case ImpactQuantity::p:
      return motion.p;
    case ImpactQuantity::u_n:
      return motion.u_n;
    case ImpactQuantity::work:
      return motion.work;
  }
  return 0;
}

namespace {

double slope_of(const NormalMotion& motion, ImpactQuantity quantity) {
  switch (quantity) {
    case ImpactQuantity::p:
      return motion.dp_dz;
    case ImpactQuantity::u_n:
      return motion.rate * motion.dp_dz;
    case ImpactQuantity::work:
      return motion.u_n * motion.dp_dz;
  }
  return 0;
}

}  // namespace

double ImpactPiece::where(ImpactQuantity quantity, double target, const PiecePoint& a,
                          const PiecePoint& b) const {
  // Newton's method inside a bracket that it shrinks; where it leaves the bracket, bisection.
  constexpr int most_steps = 100;
  const double sign = value_of(b.at, quantity) >= value_of(a.at, quantity) ? 1 : -1;
  const double share =
      (target - value_of(a.at, quantity)) / (value_of(b.at, quantity) - value_of(a.at, quantity));
  if (!(share > 0)) return a.z;
  if (!(share < 1)) return b.z;
  double lo = a.z, hi = b.z;
  // Work starts like a parabola where u_n = 0.
  double z = lo + (hi - lo) * (quantity == ImpactQuantity::work ? std::sqrt(share) : share);
  for (int step = 0; step < most_steps; ++step) {
    const NormalMotion here = normal(z);
    const double miss = value_of(here, quantity) - target;
    if (miss == 0) return z;
    (sign * miss > 0 ? hi : lo) = z;
    const double newton = z - miss / slope_of(here, quantity);
    const double next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
    const bool is_close = std::abs(next - z) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(z);
    z = next;
    if (is_close) return z;
  }
  return z;
}

StraightPiece::StraightPiece(const SlipFlow& flow, const Vec2& direction, const ImpactState& start)
    : start_(start), direction_(direction) {
  const double radial_rate = flow.radial_rate(direction);
  u_rate_ << radial_rate * direction, flow.normal_rate(direction);
  lambda_rate_ << -flow.mu * direction, flow.drive;
  ends_in_stop_ = radial_rate < 0;
  end_ = ends_in_stop_ ? start.slip().norm() / -radial_rate : std::numeric_limits<double>::infinity();
}

StraightPiece::StraightPiece(const StickTest& sticking, const ImpactState& start) : start_(start) {
  u_rate_ << 0, 0, sticking.normal_rate;
  lambda_rate_ << sticking.friction, 1;
  end_ = std::numeric_limits<double>::infinity();
}

StraightPiece::StraightPiece(const SlipFlow& frictionless, const ImpactState& start) : start_(start) {
  u_rate_ << frictionless.b, frictionless.kappa;
  lambda_rate_ << 0, 0, 1;
  end_ = std::numeric_limits<double>::infinity();
}

NormalMotion StraightPiece::normal(double z) const {
  const double c = u_rate_.z();
  // Without rate, infinite z must not make NaN.
  const double change = c == 0 ? 0 : c * z;
  const double u_mean = start_.u.z() + 0.5 * change;
  return {start_.p + z, start_.u.z() + change, start_.work + (u_mean == 0 ? 0 : u_mean * z), 1, c};
}

ImpactState StraightPiece::state(double z) const {
  ImpactState state = start_;
  state.u += z * u_rate_;
  if (ends_in_stop_ && z >= end_) state.u.head<2>().setZero();
  state.lambda += z * lambda_rate_;
  const NormalMotion motion = normal(z);
  state.p = motion.p;
  state.work = motion.work;
  return state;
}

Vec2 StraightPiece::direction(double) const {
  return direction_;
}

double StraightPiece::where(ImpactQuantity quantity, double target, const PiecePoint& a,
                            const PiecePoint& b) const {
  const double c = u_rate_.z();
  double step = 0;
  switch (quantity) {
    case ImpactQuantity::p:
      step = target - a.at.p;
      break;
    case ImpactQuantity::u_n:
      step = (target - a.at.u_n) / c;
      break;
    case ImpactQuantity::work: {
      // W grows by u Δ + ½ c Δ²; the root with u + c Δ ≥ 0, without cancellation.
      const double gain = target - a.at.work;
      const double u_end = std::sqrt(std::max(0.0, a.at.u_n * a.at.u_n + 2 * c * gain));
      step = u_end + a.at.u_n > 0 ? 2 * gain / (u_end + a.at.u_n) : 0;
      break;
    }
  }
  return std::clamp(a.z + step, a.z, b.z);
}

}  // namespace rigor
