#pragma once

#include "rigor/solver/coulomb/proximal_point.hpp"

namespace rigor {

/// Proximal points with motion and forces as unknowns and a moderate c: λ = P(λ - c w) and M v = Lᵀ λ, with
/// w = L v + b + (λ - λ⁰) / ρ. One search serves all points of a problem: what a Newton step has factored is
/// tried again while the contacts do the same.
class SearchByForces {
 public:
  SearchByForces() = default;
  /// The point of this start. Nothing where the search along Newton's direction stops, or takes twenty steps:
  /// contacts go to and fro between modes then.
  std::optional<ProximalPoint> find(const ProximalStart& from);

 private:
  /// A motion v and forces λ, with what the search along a line needs of them: all of it is linear.
  struct Iterate {
    VecX v;
    VecX rates;              ///< L v (3n).
    VecX momentum;           ///< M v.
    VecX lambda;             ///< 3n.
    VecX generalised_force;  ///< Lᵀ λ.
  };
  /// How an iterate misses the law.
  struct Residual {
    VecX F;  ///< λ - P(λ - c w) (3n).
    std::vector<ContactMode> modes;
    VecX x;            ///< λ - c w (3n), what P projects.
    double error = 0;  ///< Of F and of M v - Lᵀ λ.
  };
  /// λ - c w of a contact.
  Vec3 argument(const Iterate& iterate, Eigen::Index contact) const;
  void measure(const Iterate& iterate, Residual& residual);
  void linearise(const Residual& residual);
  void direct(const Iterate& iterate, const Residual& residual, Iterate& step);
  static void move(const Iterate& iterate, double length, const Iterate& step, Iterate& next);
  bool repeats();
  bool search_line();
  bool contracts(double length);
  bool search_kinks();
  void find_kinks();
  double size_of(const Iterate& step) const;

  const ProximalStart* from_ = nullptr;
  Iterate iterate_, next_, step_, simplified_, best_iterate_;
  Residual residual_, trial_, best_;
  // Of the last linearisation.
  double rho_ = 0;
  std::vector<ContactMode> modes_;
  std::vector<Mat3> D_, inverse_;  ///< dλ = -D L dv - inverse F.
  // Scratch.
  VecX momentum_, velocity_, r_;
  std::vector<double> kinks_;
};

}  // namespace rigor
