#pragma once

#include "rigor/contact/impact/impact_piece.hpp"

#include <array>
#include <optional>

namespace rigor {

/// Slip near an invariant direction û* that attracts it: power series in a coordinate w of the direction that
/// goes to zero there,  dw/dτ = k w ψ,  k = f_θ'(θ*) < 0,
///
///   θ = θ* + w + ...,   s = c w^α E(w),  α = λ/k,   dp = s dw/(k w ψ),
///
/// with E analytic, E(0) = 1 and ψ = (|k| ± f_r)/(|k| + |λ|), + where slip grows (λ > 0). Integrals of
/// w^(α + j - 1) are exact, so one piece reaches the stop (λ < 0), or as far as slip grows (λ > 0), where
/// series in p need ever shorter steps. For ψ = 1 this is Koenigs' coordinate; with |λ| ≫ |k| (nearly every
/// direction invariant) w^α is the slip speed; ψ serves both. Derivation: docs/theory/impact.md.
class AsymptoticSlipSeries {
 public:
  static constexpr std::size_t order = 20;
  template <class Value>
  using Coefficients = std::array<Value, order + 1>;

  /// Near the invariant direction, where f_θ' < 0.
  AsymptoticSlipSeries(const SlipFlow& flow, const Vec2& direction);

  const Vec2& limit() const { return direction[0]; }
  /// Whether the integrals can be formed: where slip grows, not for α near -1/2, -1, -3/2, ...
  bool is_usable() const { return is_usable_; }
  /// w of this angle, if the series give everything to rounding there.
  std::optional<double> find_w(double angle) const;

  // In units of SlipFlow::rate_bound().
  double slope, radial_rate, exponent;  ///< k, λ, α.
  Coefficients<double> theta;           ///< θ - θ*, from w¹ on.
  Coefficients<Vec2> direction;         ///< û.
  Coefficients<double> speed;           ///< E.
  Coefficients<double> dp;              ///< s/(k ψ) without c w^α.

 private:
  double reach_ = 0;  ///< Largest |w|.
  bool is_usable_;
};

/// The invariant direction that attracts slip from this direction, if it is near.
std::optional<Vec2> find_near_attractor(const SlipFlow& flow, const Vec2& direction);

/// Slip from w at the start to where it stops, or grows: z = |v - 1| with v = (w/w_start)^α, about the change
/// of the slip speed over the speed at the start.
class AsymptoticSlip final : public ImpactPiece {
 public:
  AsymptoticSlip(const SlipFlow& flow, const AsymptoticSlipSeries& series, double w,
                 const ImpactState& start);

  NormalMotion normal(double z) const override;
  ImpactState state(double z) const override;
  Vec2 direction(double z) const override;

 private:
  template <class Value>
  using Coefficients = AsymptoticSlipSeries::Coefficients<Value>;
  /// v, y = w/w_start and E_α = (v - 1)/α at z.
  struct Place {
    double v, y, first;
  };
  Place place(double z) const;
  /// Of the changes of p, u_n and ∫ û dp.
  struct Changes {
    double p, u_n;
    Vec2 friction;
  };

  const SlipFlow& flow_;
  const ImpactState& start_;
  double growth_;  ///< +1 where slip grows, else -1.
  double exponent_;
  double speed_, unit_;  ///< Units of slip and of p, as in SlipPowerSeries.
  // In powers of y; integrals without their factor v (v² for the work).
  Coefficients<Vec2> slip_direction_;
  Coefficients<double> slip_speed_, dp_, p_, u_n_, work_;
  Coefficients<Vec2> friction_;
  Changes first_;  ///< Factors of E_α.
  Changes sums_;   ///< The integrals at y = 1.
  double work_sum_;
};

}  // namespace rigor
