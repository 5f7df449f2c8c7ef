#include "rigor/bulk/joints/joint_laws.hpp"

#include "rigor/bulk/joints/approach_speed.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far the coordinate is from the rest of its spring; angles the shorter way round.
double deviation(const Joint& joint, int k, double value) {
  const double difference = value - joint.axes[static_cast<std::size_t>(k)].rest;
  return is_periodic(joint.type, k) ? std::remainder(difference, 2 * std::numbers::pi) : difference;
}

}  // namespace

CoordinateLaw::CoordinateLaw(const Joint& joint, int k, const CoordinateMotion& motion, double h)
    : mobility_(motion.mobility), low_(-infinity), high_(infinity) {
  const JointAxis& axis = joint.axes[static_cast<std::size_t>(k)];
  if (axis.stiffness > 0 || axis.damping > 0) {
    // θ = s / (4 + s): stable for all s = h² k mobility, see the derivation.
    const double s = h * h * axis.stiffness * mobility_;
    const double theta = std::max(s / (4 + s), 1e-4);
    slope_ = h * (theta * h * axis.stiffness + axis.damping);
    rest_rate_ = -h * axis.stiffness * deviation(joint, k, motion.value) / slope_;
  }
  if (axis.motor) {
    motor_rate_ = axis.motor->velocity;
    motor_ = h * axis.motor->max_force;
  }
  friction_ = h * axis.friction;
  low_ = std::min((axis.lower - motion.value) / h, kApproachSpeed);
  high_ = std::max((axis.upper - motion.value) / h, -kApproachSpeed);
}

double CoordinateLaw::jump_sum(double rate, bool above) const {
  const auto side = [&](double at) { return rate < at || (rate == at && !above) ? 1.0 : -1.0; };
  double sum = 0;
  if (motor_ > 0) sum += side(motor_rate_) * motor_;
  if (friction_ > 0) sum += side(0) * friction_;
  if (side(low_) > 0) sum = infinity;
  if (side(high_) < 0) sum = -infinity;
  return sum;
}

int CoordinateLaw::find_jumps(std::array<double, 4>& jumps) const {
  int count = 0;
  for (const double u : {motor_ > 0 ? motor_rate_ : infinity, friction_ > 0 ? 0 : infinity, low_, high_}) {
    if (std::isfinite(u)) jumps[at(count++)] = u;
  }
  std::sort(jumps.begin(), jumps.begin() + count);
  return static_cast<int>(std::unique(jumps.begin(), jumps.begin() + count) - jumps.begin());
}

LawPiece CoordinateLaw::piece_of(int place) const {
  std::array<double, 4> jumps;
  const int count = find_jumps(jumps), next = place / 2;
  if (place % 2 == 1) {
    const double u = jumps[at(next)];
    return {true, u, 0, 0, u == low_ ? -1 : (u == high_ ? 1 : 0), place};
  }
  // Between two jumps the sum is that below the upper, or above the last.
  const double between = next < count ? jump_sum(jumps[at(next)], false)
                         : count > 0  ? jump_sum(jumps[at(count - 1)], true)
                                      : 0;
  if (slope_ == 0) return {false, 0, 0, between, 0, place};
  return {true, rest_rate_ + between / slope_, 1 / slope_, 0, 0, place};
}

LawPiece CoordinateLaw::piece_at(double rate, double impulse) const {
  // Impulses that the rates u need: (u - free rate) / mobility, rising; where this line meets the law is the
  // answer.
  const double free_rate = rate - mobility_ * impulse;
  std::array<double, 4> jumps;
  const int count = find_jumps(jumps);
  for (int i = 0; i < count; ++i) {
    const double u = jumps[at(i)];
    const double needed = (u - free_rate) / mobility_ + slope_ * (u - rest_rate_);
    if (needed > jump_sum(u, false)) return piece_of(2 * i);
    if (needed >= jump_sum(u, true)) return piece_of(2 * i + 1);
  }
  return piece_of(2 * count);
}

LawPiece CoordinateLaw::piece_towards(double rate, double impulse, int from) const {
  const LawPiece found = piece_at(rate, impulse);
  return from < 0 || std::abs(found.place - from) <= 1 ? found
                                                       : piece_of(from + (found.place > from ? 1 : -1));
}

}  // namespace rigor
