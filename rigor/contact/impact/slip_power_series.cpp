#include "rigor/contact/impact/slip_power_series.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

SlipPowerSeries::SlipPowerSeries(const SlipFlow& flow, const ImpactState& start)
    : flow_(flow), start_(start), speed_(start.slip().norm()), unit_(speed_ / flow.rate_bound()) {
  // In units of speed_ and unit_ all coefficients are of order one at most.
  const Vec2 b = flow.b * (flow.drive / flow.rate_bound());
  const Mat2 M = flow.M * (flow.mu / flow.rate_bound());

  // The first two orders, by hand.
  Coefficients<Vec2> rate;  // of u_t
  Coefficients<double> speed;
  slip_[0] = direction_[0] = start.slip() / speed_;
  speed[0] = 1;
  rate[0] = b - M * direction_[0];
  slip_[1] = rate[0];
  speed[1] = direction_[0].dot(rate[0]);
  direction_[1] = rate[0] - speed[1] * direction_[0];

  // s' = û·u_t' and s û = u_t, order by order:
  //   (k + 1) s_{k+1} = Σ û_j·r_{k-j},   û_{k+1} = r_k/(k + 1) - Σ s_j û_{k+1-j} - s_{k+1} û_0,   r_k = -M
  //   û_k.
  // Written so that little waits for û_k: its terms in both are those of one constant matrix, and the sum is
  // symmetric.
  const Vec2 newest = 2 * rate[0] - b;
  const Mat2 N = -(M + direction_[0] * newest.transpose());
  for (std::size_t k = 1; k < order; ++k) {
    rate[k] = -(M * direction_[k]);
    Vec2 half = Vec2::Zero(), even = Vec2::Zero(), odd = speed[1] * direction_[k];
    for (std::size_t j = 1; 2 * j < k; ++j) half += direction_[j].cwiseProduct(rate[k - j]);
    double older = 2 * half.sum();
    if (k % 2 == 0) older += direction_[k / 2].dot(rate[k / 2]);
    std::size_t j = 2;
    for (; j + 1 <= k; j += 2) {
      even += speed[j] * direction_[k + 1 - j];
      odd += speed[j + 1] * direction_[k - j];
    }
    if (j == k) even += speed[k] * direction_[1];
    const double share = 1 / static_cast<double>(k + 1);
    slip_[k + 1] = share * rate[k];
    speed[k + 1] = share * (older + newest.dot(direction_[k]));
    direction_[k + 1] = share * (N * direction_[k] - older * direction_[0]) - (even + odd);
  }

  // u_n' = κ - μ b·û, and W' = u_n.
  u_n_[0] = work_[0] = work_[1] = 0;
  for (std::size_t k = 0; k < order; ++k) {
    const double normal_rate = (k == 0 ? flow.drive * flow.kappa : 0) - flow.mu * flow.b.dot(direction_[k]);
    u_n_[k + 1] = normal_rate / static_cast<double>(k + 1);
    if (k + 2 <= order) work_[k + 2] = u_n_[k + 1] / static_cast<double>(k + 2);
  }

  // The stretch ends where the last two terms are rounding (Jorba and Zou).
  constexpr double log_rounding = -36.8;  // of 1e-16
  const auto log_reach = [&](std::size_t k) {
    return (log_rounding - std::log(direction_[k].cwiseAbs().maxCoeff())) / static_cast<double>(k);
  };
  constexpr double farthest = 7;
  end_ = std::exp(std::min({log_reach(order), log_reach(order - 1), farthest}));

  // Where the direction hardly rotates the series do not show that slip stops.
  const auto speed_at = [&](double z) {
    double sum = speed[order];
    for (std::size_t k = order; k-- > 0;) sum = sum * z + speed[k];
    return sum;
  };
  constexpr double least_speed = 0.1;
  while (end_ > 1 - least_speed && speed_at(end_) < least_speed) end_ *= 0.7;
}

NormalMotion SlipPowerSeries::normal(double z) const {
  double u_n = u_n_[order], work = work_[order], rate = order * u_n_[order];
  for (std::size_t k = order; k-- > 0;) {
    u_n = u_n * z + u_n_[k];
    work = work * z + work_[k];
    if (k > 0) rate = rate * z + static_cast<double>(k) * u_n_[k];
  }
  return {start_.p + unit_ * z, start_.u.z() + unit_ * u_n,
          start_.work + unit_ * (start_.u.z() * z + unit_ * work), unit_, rate};
}

ImpactState SlipPowerSeries::state(double z) const {
  // Friction impulse: -μ ∫ û dp.
  Vec2 slip = slip_[order], direction_integral = direction_[order] / (order + 1);
  for (std::size_t k = order; k-- > 0;) {
    slip = slip * z + slip_[k];
    direction_integral = direction_integral * z + direction_[k] / static_cast<double>(k + 1);
  }
  const NormalMotion motion = normal(z);
  ImpactState state;
  state.u << speed_ * slip, motion.u_n;
  state.lambda = start_.lambda;
  state.lambda.head<2>() -= flow_.mu * unit_ * z * direction_integral;
  state.lambda.z() += flow_.drive * unit_ * z;
  state.p = motion.p;
  state.work = motion.work;
  return state;
}

Vec2 SlipPowerSeries::direction(double z) const {
  Vec2 slip = slip_[order];
  for (std::size_t k = order; k-- > 0;) slip = slip * z + slip_[k];
  return slip.normalized();
}

}  // namespace rigor
