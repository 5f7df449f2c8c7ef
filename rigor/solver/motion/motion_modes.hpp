#pragma once

#include "rigor/solver/coulomb/known_modes.hpp"
#include "rigor/solver/linear/contact_rows.hpp"
#include "rigor/solver/linear/node_system.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A Coulomb problem in motion space: the rows in place of A.
struct MotionProblem {
  ContactRows rows;
  CoulombProblem laws;  ///< b, mu, rows and slips; its A stays empty.
};

/// The linear problem of known modes as KnownModesSystem has it, without A. With E the force directions and R
/// the equations of the contacts on the nodes (columns of Jᵀ D, rows of Wᵀ J), wanted is the x of least norm
/// with
///
///   R M⁻¹ E x = c.
///
/// Each round solves (ε M + E R) a = E r for the accelerations that the misses r ask for and (ε M + E Eᵀ) z =
/// M a for forces Eᵀ z that make them, of least norm for this a because every Eᵀ z is in the span of Eᵀ. So
/// the sum of the rounds is the least-norm solution where R has the rank of E; where redundant contacts slide
/// in different directions it is another one (docs/theory/resting.md). Both matrices have a block for each
/// two bodies in contact and no more. With joints a and z are of the motions that these allow (NodeSystem),
/// and so λ alone is of least norm, whatever the joints bear.
class MotionModesSystem {
 public:
  /// Holds references to the problem and to the plan of its rows.
  MotionModesSystem(const MotionProblem& problem, const EliminationPlan& plan, const ContactModes& modes);

  /// λ (3n) of least norm; where redundant contacts slide in different directions, of those with its motion.
  const VecX& least_norm() const { return lambda_; }
  /// Whether the equations hold to round-off: else the rows are too close to dependent for this method, or
  /// contradict each other.
  bool is_exact() const { return miss_ <= kExact; }
  /// λ (3n) of least norm in the product of the cones; nothing if there is none or it was not found: the
  /// search ends where so many steps do not halve its error.
  std::optional<VecX> find_in_cones(int patience = 8) const;

 private:
  static constexpr double kExact = 1e-13;
  struct Dual {
    VecX z, lambda, gradient;  ///< λ = proj_C(Eᵀ z), gradient E x - p.
    double value;
  };

  VecX restrict_to_forces(const VecX& contacts) const;
  VecX restrict_to_equations(const VecX& contacts) const;
  VecX expand_equations(const VecX& misses) const;
  VecX project(const VecX& lambda) const;
  std::vector<Mat3> projection_weights(const VecX& lambda) const;
  Dual evaluate(const VecX& z, const VecX& p) const;
  double size_of_terms(const VecX& lambda) const;
  VecX rates_of(const VecX& lambda) const;
  void iterate();
  void refine(const NodeSystem& to_motion, const NodeSystem& to_forces);

  const MotionProblem& problem_;
  const EliminationPlan& plan_;
  std::vector<ContactMode> modes_;
  std::vector<Vec3> generators_;  ///< Of the contacts that slide: unit.
  double scale_ = 0;              ///< Largest diagonal entry of A without joints.
  double miss_ = 0;               ///< |c - R M⁻¹ E x| relative to the largest term.
  VecX lambda_, z_;               ///< λ_ is about the part of J z_ along the forces.
};

}  // namespace rigor
