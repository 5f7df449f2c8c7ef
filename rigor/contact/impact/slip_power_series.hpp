#pragma once

#include "rigor/contact/impact/impact_piece.hpp"

#include <array>

namespace rigor {

/// Slip in a rotating direction, as power series in the normal impulse:  u_t' = b - μ M û,  û = u_t/|u_t|.
///
/// Coefficients by the recurrences of automatic differentiation (s' = û·u_t', s û = u_t); u_n and W are
/// polynomials too. The stretch ends where the last terms are rounding (Jorba and Zou, A Software Package for
/// the Numerical Integration of ODEs by Means of High-Order Taylor Methods, Exp. Math. 14, 2005,
/// section 3.2): about a fifth of the way to where slip would stop.
class SlipPowerSeries final : public ImpactPiece {
 public:
  static constexpr int order = 20;

  /// Needs slip at the start.
  SlipPowerSeries(const SlipFlow& flow, const ImpactState& start);

  NormalMotion normal(double z) const override;
  ImpactState state(double z) const override;
  Vec2 direction(double z) const override;

 private:
  template <class Value>
  using Coefficients = std::array<Value, order + 1>;

  const SlipFlow& flow_;
  const ImpactState& start_;
  double speed_;                  ///< s at the start: the unit of slip.
  double unit_;                   ///< p for each unit of z: that in which slip changes by `speed_` at most.
  Coefficients<Vec2> slip_;       ///< u_t / speed.
  Coefficients<Vec2> direction_;  ///< û.
  Coefficients<double> u_n_;      ///< Of (u_n - u_n at the start) / unit: from z¹ on.
  Coefficients<double> work_;     ///< Of W's part due to it, / unit²: from z² on.
};

}  // namespace rigor
