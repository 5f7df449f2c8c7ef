#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"
#include "rigor/solver/linear/contact_motion.hpp"

namespace rigor {

/// What is added to the normal rates of cones so that their problem is Coulomb's: μ |w_t|. Without it the
/// problem is convex and another one (convex_cone.hpp).
enum class NormalShift { de_saxce, none };

struct ProximalOptions {
  NormalShift normal_shift = NormalShift::de_saxce;
  /// Whether the forces themselves are wanted to round-off, not only what the contacts do: each inner problem
  /// is then solved to round-off.
  bool makes_digits = false;
  /// Whether the start is near the solution: the shifts begin with its motion, and ρ begins large.
  bool is_warm = false;
};

/// Proximal Newton method for a CoulombProblem, for what Gauss–Seidel is too slow for (stacks, large mass
/// ratios).
///
/// With A = L M⁻¹ Lᵀ, De Saxcé's shift s_i = μ_i |w_t,i| held and the friction of slide rows held, the
/// problem is convex: minimise ½ vᵀM v subject to L v + b + s n in the dual cones. One step is one step of
/// the augmented Lagrangian method,
///   v ← argmin ½ vᵀM v + Σ |proj(λ_i - ρ_i (L_i v + b_i + s_i n))|² / (2 ρ_i),   λ_i ← that projection,
/// (a Newton iteration whose matrix M + Lᵀ D L is always definite, however redundant the contacts), followed
/// by new shifts from the new w and a larger ρ. Its forces are always in the cones. Holds references to the
/// problem, of which A is not read, and to the motion.
///
/// Sources: the reformulation is De Saxcé and Feng's; augmented Lagrangian with Newton inside is a standard
/// method.
class CoulombProximal {
 public:
  CoulombProximal(const CoulombProblem& problem, const ContactMotion& motion, CoulombGuess start,
                  ProximalOptions options = {});

  /// One outer step.
  void step();

  const CoulombGuess& guess() const { return guess_; }

 private:
  /// Value of the inner function at v, its gradient, and what led to it.
  struct Inner {
    double value;
    VecX gradient;
    VecX argument;           ///< λ - ρ (L v + q): 3n.
    VecX force;              ///< Its projection: 3n.
    VecX generalised_force;  ///< Lᵀ force.
  };

  Inner evaluate(const VecX& v) const;
  std::vector<Mat3> stiffnesses(const VecX& argument) const;
  VecX moved(const VecX& lambda) const;
  void minimise();
  void update_guess(const Inner& inner);
  void update_shift(const VecX& w, double damping);
  double capped_mu(std::size_t contact) const;
  Vec3 project(Eigen::Index contact, const Vec3& x) const;

  const CoulombProblem& problem_;
  const ContactMotion& motion_;
  ProximalOptions options_;
  CoulombGuess guess_;
  VecX masses_;  ///< effective_masses: n.
  VecX v_;       ///< w = L v + b (without the held friction of slide rows).
  VecX q_;       ///< b, shift and held friction: 3n.
  VecX shift_;   ///< s: n.
  double rho_ = 10;
  int steps_ = 0;
};

}  // namespace rigor
