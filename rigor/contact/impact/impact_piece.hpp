#pragma once

#include "rigor/contact/impact/restitution_law.hpp"
#include "rigor/contact/impact/slip_flow.hpp"

#include <optional>

namespace rigor {

/// Where an impact is between its beginning and its end.
struct ImpactState {
  Vec3 u = Vec3::Zero();       ///< Relative velocity, contact frame [m/s].
  Vec3 lambda = Vec3::Zero();  ///< Impulse so far, contact frame [N s].
  double p = 0;     ///< What drives the impact: the normal impulse λ_n (see SlipFlow::drive) [N s].
  double work = 0;  ///< W = ∫ u_n dp [J].

  Vec2 slip() const { return u.head<2>(); }
};

/// The normal motion at a point of a piece.
struct NormalMotion {
  double p, u_n, work;
  double dp_dz;  ///< > 0.
  double rate;   ///< du_n/dp.
};
struct PiecePoint {
  double z;
  NormalMotion at;
};
double value_of(const NormalMotion& motion, ImpactQuantity quantity);

/// A stretch of an impact during which one formula gives everything, over a parameter z in [0, end()] that
/// grows with p.
class ImpactPiece {
 public:
  virtual ~ImpactPiece() = default;

  double end() const { return end_; }  ///< May be infinite.
  virtual NormalMotion normal(double z) const = 0;
  virtual ImpactState state(double z) const = 0;
  /// Unit slip direction; zero where nothing slips.
  virtual Vec2 direction(double z) const = 0;

  /// z in [a.z, b.z] where the quantity, monotone there, is `target`, a value between those at a and b. To
  /// rounding.
  virtual double where(ImpactQuantity quantity, double target, const PiecePoint& a,
                       const PiecePoint& b) const;

 protected:
  double end_ = 0;
  bool ends_in_stop_ = false;  ///< Whether slip has come to rest at end().
};

/// Constant rates: the contact sticks, slips straight along an invariant direction until it stops or for
/// ever, or slips without friction. z = p - p at the start.
class StraightPiece final : public ImpactPiece {
 public:
  /// Slips along the invariant direction (unit), which is that of u_t unless u_t is zero.
  StraightPiece(const SlipFlow& flow, const Vec2& direction, const ImpactState& start);
  /// Sticks.
  StraightPiece(const StickTest& sticking, const ImpactState& start);
  /// Slips without friction (μ = 0), wherever it goes.
  StraightPiece(const SlipFlow& frictionless, const ImpactState& start);

  NormalMotion normal(double z) const override;
  ImpactState state(double z) const override;
  Vec2 direction(double z) const override;
  double where(ImpactQuantity quantity, double target, const PiecePoint& a,
               const PiecePoint& b) const override;

 private:
  ImpactState start_;
  Vec2 direction_ = Vec2::Zero();
  Vec3 u_rate_ = Vec3::Zero(), lambda_rate_ = Vec3::Zero();  ///< Per unit of p.
};

}  // namespace rigor
