#include "rigor/contact/impact/asymptotic_slip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr std::size_t order = AsymptoticSlipSeries::order;
template <class Value>
using Coefficients = AsymptoticSlipSeries::Coefficients<Value>;

double product(const Coefficients<double>& a, const Coefficients<double>& b, std::size_t j) {
  double sum = 0;
  for (std::size_t i = 0; i <= j; ++i) sum += a[i] * b[j - i];
  return sum;
}
Vec2 product(const Coefficients<double>& a, const Coefficients<Vec2>& b, std::size_t j) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i <= j; ++i) sum += a[i] * b[j - i];
  return sum;
}
double dot_product(const Coefficients<Vec2>& a, const Coefficients<Vec2>& b, std::size_t j) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i <= j; ++i) sum += a[i].cwiseProduct(b[j - i]);
  return sum.sum();
}

template <class Value>
Value value_at(const Coefficients<Value>& c, double y) {
  Value sum = c[order];
  for (std::size_t j = order; j-- > 0;) sum = sum * y + c[j];
  return sum;
}

template <class Value>
void scale(double w, Coefficients<Value>& c) {
  double power = 1;
  for (Value& coefficient : c) {
    coefficient *= power;
    power *= w;
  }
}

/// |w| up to which the last terms of the series are rounding of its first.
template <class Size>
double reach_of(const Size& size, double first) {
  constexpr double rounding = 1e-16;
  double reach = 1;
  for (const std::size_t j : {order - 1, order}) {
    if (size(j) > 0)
      reach = std::min(reach, std::pow(rounding * first / size(j), 1 / static_cast<double>(j)));
  }
  return reach;
}

}  // namespace

AsymptoticSlipSeries::AsymptoticSlipSeries(const SlipFlow& flow, const Vec2& limit) {
  // λ, k and α of the invariant direction (docs/theory/impact.md).
  const double unit = flow.rate_bound();
  const Mat2 M = flow.M * (flow.mu / unit);
  const Vec2 across = perpendicular(limit);
  radial_rate = flow.radial_rate(limit) / unit;
  slope = flow.angular_rate_slope(limit) / unit;
  exponent = radial_rate / slope;
  const double sign = radial_rate > 0 ? 1 : -1, mean = 1 / (std::abs(slope) + std::abs(radial_rate));

  // Order by order: û, û⊥ and b - μ M û give f_r and ψ of this order, these the slip speed E.
  Coefficients<Vec2> normal, rate;  // û⊥ and b - μ M û
  Coefficients<double> radial, psi, inverse_psi, log_speed;
  theta[0] = 0, theta[1] = 1;
  direction[0] = limit, normal[0] = across, rate[0] = flow.slip_rate(limit) / unit;
  radial[0] = radial_rate, psi[0] = inverse_psi[0] = speed[0] = 1, log_speed[0] = 0;
  for (std::size_t j = 1; j <= order; ++j) {
    const double number = static_cast<double>(j);
    // û' = θ' û⊥, at first without θ_j, which is not known yet.
    Vec2 d = Vec2::Zero();
    for (std::size_t i = 1; i < j; ++i) d += static_cast<double>(i) * theta[i] * normal[j - i];
    direction[j] = d / number;
    if (j > 1) {
      // θ_j from w ψ k θ' = f_θ, where it enters f_θ as k θ_j.
      normal[j] = perpendicular(direction[j]);
      rate[j] = -(M * direction[j]);
      double lower = dot_product(normal, rate, j) / slope;
      for (std::size_t i = 1; i < j; ++i) lower -= psi[i] * static_cast<double>(j - i) * theta[j - i];
      theta[j] = lower / (number - 1);
    }
    direction[j] += theta[j] * across;
    normal[j] = perpendicular(direction[j]);
    rate[j] = -(M * direction[j]);
    radial[j] = dot_product(direction, rate, j);
    // ψ = (|k| ± f_r)/(|k| + |λ|) and 1/ψ.
    psi[j] = sign * mean * radial[j];
    inverse_psi[j] = 0;
    inverse_psi[j] = -product(psi, inverse_psi, j);
    // (ln E)' = (f_r/(k ψ) - α)/w, and E' = E (ln E)'.
    log_speed[j] = product(radial, inverse_psi, j) / (slope * number);
    double s = 0;
    for (std::size_t i = 1; i <= j; ++i) s += static_cast<double>(i) * log_speed[i] * speed[j - i];
    speed[j] = s / number;
  }
  for (std::size_t j = 0; j <= order; ++j) dp[j] = product(speed, inverse_psi, j) / slope;

  // The series hold as far as the last terms of all of them are rounding.
  reach_ = std::min({reach_of([&](std::size_t j) { return direction[j].norm(); }, 1),
                     reach_of([&](std::size_t j) { return std::abs(dp[j]); }, std::abs(dp[0])),
                     reach_of([&](std::size_t j) { return std::abs(speed[j]); }, 1)});

  // Integrals of w^(α + j - 1) and w^(2 α + j - 1), j ≥ 1, that are nearly logarithms cancel.
  constexpr double resonance = 0.01;
  const double twice = 2 * exponent, nearest = std::round(twice);
  is_usable_ = exponent != 0 && (nearest >= 0 || std::abs(twice - nearest) > resonance);
}

std::optional<double> AsymptoticSlipSeries::find_w(double target) const {
  if (!is_usable_ || std::abs(target) > 1.5 * reach_) return std::nullopt;
  // Newton's method on θ(w) = target.
  double w = target;
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps && std::abs(w) <= 1; ++step) {
    double value = theta[order], derivative = static_cast<double>(order) * theta[order];
    for (std::size_t j = order; j-- > 0;) {
      value = value * w + theta[j];
      if (j > 0) derivative = derivative * w + static_cast<double>(j) * theta[j];
    }
    const double change = (value - target) / derivative;
    w -= change;
    if (std::abs(change) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(w)) {
      if (std::abs(w) <= reach_) return w;
      break;
    }
  }
  return std::nullopt;
}

std::optional<Vec2> find_near_attractor(const SlipFlow& flow, const Vec2& direction) {
  constexpr double near = 0.35;
  constexpr int most_steps = 10;
  // Newton's method on f_θ(θ) = 0, which must stay where f_θ falls: an attractor.
  const double unit = flow.rate_bound();
  Vec2 d = direction;
  double angle = 0;
  for (int step = 0; step < most_steps; ++step) {
    const double slope = flow.angular_rate_slope(d);
    if (slope >= 0) return std::nullopt;
    const double change = -flow.angular_rate(d) / slope;
    angle += change;
    if (!(std::abs(angle) < near)) return std::nullopt;
    d = (d + std::tan(change) * perpendicular(d)).normalized();
    if (std::abs(change) < 1e-9) {
      // Quadratic convergence: this was the last step that could be seen.
      return std::abs(flow.angular_rate(d)) <= 1e-14 * unit ? std::optional<Vec2>(d) : std::nullopt;
    }
  }
  return std::nullopt;
}

AsymptoticSlip::AsymptoticSlip(const SlipFlow& flow, const AsymptoticSlipSeries& series, double w,
                               const ImpactState& start)
    : flow_(flow),
      start_(start),
      growth_(series.radial_rate > 0 ? 1 : -1),
      exponent_(series.exponent),
      speed_(start.slip().norm()),
      unit_(speed_ / flow.rate_bound()),
      slip_direction_(series.direction),
      slip_speed_(series.speed),
      dp_(series.dp) {
  // In powers of y = w/w_start, with the slip speed 1 at the start.
  scale(w, slip_direction_);
  scale(w, slip_speed_);
  scale(w, dp_);
  const double norm = 1 / value_at(slip_speed_, 1);
  for (std::size_t j = 0; j <= order; ++j) slip_speed_[j] *= norm, dp_[j] *= norm;

  // The integrals, term by term. With E_c = ∫ y^(c-1) dy from 1 = (y^c - 1)/c: p changes by Σ dp_j E_(α+j).
  // The first term, E_α, is kept apart: it may be large.
  const double alpha = exponent_;
  Coefficients<double> u_n_rate;
  for (std::size_t j = 0; j <= order; ++j) {
    u_n_rate[j] = (j == 0 ? flow.drive * flow.kappa : 0) - flow.mu * flow.b.dot(slip_direction_[j]);
  }
  first_ = {dp_[0], dp_[0] * u_n_rate[0], dp_[0] * slip_direction_[0]};
  p_[0] = u_n_[0] = work_[0] = 0, friction_[0] = Vec2::Zero();
  for (std::size_t j = 1; j <= order; ++j) {
    const double c = alpha + static_cast<double>(j);
    p_[j] = dp_[j] / c;
    u_n_[j] = product(dp_, u_n_rate, j) / c;
    friction_[j] = product(dp_, slip_direction_, j) / c;
  }
  // W = ∫ u_n dp; the product of the first term of u_n with the others by parts.
  for (std::size_t j = 1; j <= order; ++j) {
    work_[j] = (product(u_n_, dp_, j) - first_.u_n * p_[j]) / (2 * alpha + static_cast<double>(j));
  }
  sums_ = {value_at(p_, 1), value_at(u_n_, 1), value_at(friction_, 1)};
  work_sum_ = value_at(work_, 1);

  // z = |v - 1| ends at the stop, v = 0; where slip grows, before y is rounding.
  ends_in_stop_ = growth_ < 0;
  constexpr double most_growth = 1e6, log_rounding = -40;
  end_ = ends_in_stop_ ? 1 : std::min(most_growth, std::exp(std::min(20.0, log_rounding * exponent_)) - 1);
}

AsymptoticSlip::Place AsymptoticSlip::place(double z) const {
  const double v = std::max(0.0, 1 + growth_ * z);
  return {v, v > 0 ? std::exp(std::log1p(growth_ * z) / exponent_) : 0, growth_ * z / exponent_};
}

NormalMotion AsymptoticSlip::normal(double z) const {
  const auto [v, y, first] = place(z);
  double p = p_[order], u_n = u_n_[order], work = work_[order], dp = dp_[order];
  Vec2 d = slip_direction_[order];
  for (std::size_t j = order; j-- > 0;) {
    p = p * y + p_[j];
    u_n = u_n * y + u_n_[j];
    work = work * y + work_[j];
    dp = dp * y + dp_[j];
    d = d * y + slip_direction_[j];
  }
  const double p_change = first_.p * first + v * p - sums_.p;
  const double u_n_change = first_.u_n * first + v * u_n - sums_.u_n;
  const double work_change =
      first_.u_n * first * (0.5 * first_.p * first + v * p) + v * v * work - work_sum_ - sums_.u_n * p_change;
  return {start_.p + unit_ * p_change, start_.u.z() + unit_ * u_n_change,
          start_.work + unit_ * (start_.u.z() * p_change + unit_ * work_change),
          unit_ * growth_ * dp / exponent_, flow_.normal_rate(d)};
}

ImpactState AsymptoticSlip::state(double z) const {
  const auto [v, y, first] = place(z);
  const NormalMotion motion = normal(z);
  ImpactState state;
  state.u << speed_ * v * value_at(slip_speed_, y) * value_at(slip_direction_, y), motion.u_n;
  state.lambda = start_.lambda;
  state.lambda.head<2>() -=
      flow_.mu * unit_ * (first_.friction * first + v * value_at(friction_, y) - sums_.friction);
  state.lambda.z() += flow_.drive * (motion.p - start_.p);
  state.p = motion.p;
  state.work = motion.work;
  return state;
}

Vec2 AsymptoticSlip::direction(double z) const {
  return value_at(slip_direction_, place(z).y).normalized();
}

}  // namespace rigor
