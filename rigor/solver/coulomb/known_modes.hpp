#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/least_norm.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// What the contacts of a CoulombProblem do, with the slip directions of those that slide.
struct ContactModes {
  std::vector<ContactMode> modes;  ///< n.
  std::vector<Vec2> slips;  ///< n; unit direction of w_t where the mode is slide and μ > 0, else unused.
};

/// A vector of the contact's own three rows: an unknown's force direction, or an equation's weights.
struct ContactVector {
  Eigen::Index contact;
  Vec3 direction;
};

/// The matrix with entries rowᵀ A column.
MatX reduce(const MatX& A, const std::vector<ContactVector>& rows, const std::vector<ContactVector>& columns);

/// The linear problem of known modes: forces λ = E x with orthonormal columns E (stick: the three axes;
/// slide: the generator of the cone opposite to the slip; open: none), equations w = 0 (stick) and w_n = 0
/// (slide).
class KnownModesSystem {
 public:
  KnownModesSystem(const CoulombProblem& problem, const ContactModes& modes);

  /// λ (3n) of least norm. The equations hold to round-off if any forces can make them hold.
  VecX solve() const { return expand(x_least_); }

  /// λ (3n) that satisfies the equations as well and is nearest to `lambda` (of which the parts outside the
  /// span of the force directions are dropped).
  VecX solve_near(const VecX& lambda) const;

  /// Whether the forces are unique.
  bool is_regular() const { return system_.rank() == x_least_.size(); }

  /// λ (3n) of least norm that is in the product of the cones; nothing if there is none (or it was not found:
  /// a set of forces that only touches the cones has no stable answer).
  std::optional<VecX> find_in_cones() const;

 private:
  /// The columns of one contact that is not open.
  struct Block {
    Eigen::Index contact;
    Eigen::Index column;  ///< First of three (stick) or the only one (slide).
    bool sticks;
    double mu;
  };

  /// A point of the minimisation in find_in_cones.
  struct DualPoint {
    VecX y, x, gradient;  ///< x = proj_C(Z y).
    double value;
  };

  DualPoint evaluate_dual(const VecX& y, const MatX& Z, const VecX& d) const;
  VecX expand(const VecX& x) const;
  VecX project(const VecX& x) const;
  MatX project_derivative(const VecX& x, const MatX& basis) const;

  Eigen::Index contact_count_;
  std::vector<ContactVector> columns_;
  std::vector<Block> blocks_;
  LeastNormSystem system_;
  VecX right_side_;
  VecX x_least_;
};

}  // namespace rigor
