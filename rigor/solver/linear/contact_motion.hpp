#pragma once

#include "rigor/solver/linear/contact_rows.hpp"
#include "rigor/solver/linear/jointed_matrix.hpp"
#include "rigor/solver/linear/node_system.hpp"
#include "rigor/solver/linear/packed_contacts.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// Of the matrices D of a Newton step.
enum class Symmetry { positive, none };

/// Contacts as a map from motions v to contact velocities L v, with a metric M for v, such that
/// A = L M⁻¹ Lᵀ. What CoulombProximal works with.
class ContactMotion {
 public:
  virtual ~ContactMotion() = default;
  virtual void rates(const VecX& v, VecX& w) const = 0;  ///< L v (3n).
  /// Lᵀ λ, with what joints do about it.
  virtual void apply_transpose(const VecX& lambda, VecX& p) const = 0;
  virtual void apply_mass(const VecX& v, VecX& p) const = 0;          ///< M v.
  virtual void apply_inverse_mass(const VecX& p, VecX& v) const = 0;  ///< M⁻¹ p.
  virtual const VecX& diagonal() const = 0;                           ///< Of A (3n).
  /// Begins with the matrix M + Lᵀ D L of a Newton step, with one 3 × 3 matrix D a contact, positive
  /// semidefinite or any.
  virtual void factor(const std::vector<Mat3>& D, Symmetry symmetry) const = 0;
  /// (M + Lᵀ D L)⁻¹ g of the matrix begun with last; of the motions that joints allow the one that solves it
  /// on them.
  virtual void solve(const VecX& g, VecX& v) const = 0;

  VecX rates(const VecX& v) const { return result_of(&ContactMotion::rates, v); }
  VecX apply_transpose(const VecX& lambda) const {
    return result_of(&ContactMotion::apply_transpose, lambda);
  }
  VecX apply_mass(const VecX& v) const { return result_of(&ContactMotion::apply_mass, v); }
  VecX apply_inverse_mass(const VecX& p) const { return result_of(&ContactMotion::apply_inverse_mass, p); }
  VecX solve(const VecX& g) const { return result_of(&ContactMotion::solve, g); }
  VecX newton_step(const std::vector<Mat3>& D, const VecX& g, Symmetry symmetry) const {
    factor(D, symmetry);
    return solve(g);
  }

 private:
  VecX result_of(void (ContactMotion::*map)(const VecX&, VecX&) const, const VecX& x) const {
    VecX result;
    (this->*map)(x, result);
    return result;
  }
};

/// Of a matrix A: L is its Cholesky factor with diagonal pivoting, which stops at round-off (1e-14 of the
/// largest diagonal), and M is 1.
class FactoredMotion : public ContactMotion {
 public:
  explicit FactoredMotion(const MatX& A);
  /// Nothing if a Newton step takes more multiplications than this; then A is not factored to its end.
  static std::unique_ptr<FactoredMotion> of_little_work(const MatX& A, double work);
  using ContactMotion::apply_inverse_mass, ContactMotion::apply_transpose, ContactMotion::rates,
      ContactMotion::apply_mass, ContactMotion::solve;
  void rates(const VecX& v, VecX& w) const override { w.noalias() = L_ * v; }
  void apply_transpose(const VecX& lambda, VecX& p) const override { p.noalias() = L_.transpose() * lambda; }
  void apply_mass(const VecX& v, VecX& p) const override { p = v; }
  void apply_inverse_mass(const VecX& p, VecX& v) const override { v = p; }
  const VecX& diagonal() const override { return diagonal_; }
  void factor(const std::vector<Mat3>& D, Symmetry symmetry) const override;
  void solve(const VecX& g, VecX& v) const override;

 private:
  FactoredMotion(MatX factor, VecX diagonal);

  MatX L_;  ///< 3n × rank.
  VecX diagonal_;
  mutable MatX matrix_;  ///< Of the Newton step.
  mutable Symmetry symmetry_ = Symmetry::none;
};

/// Of rows on bodies: L is J, M the masses; each Newton step is one sparse factorisation.
class SparseMotion : public ContactMotion {
 public:
  /// Holds a reference to the rows.
  explicit SparseMotion(const ContactRows& rows);
  SparseMotion(const SparseMotion&) = delete;
  SparseMotion& operator=(const SparseMotion&) = delete;
  const EliminationPlan& plan() const { return plan_; }
  using ContactMotion::apply_inverse_mass, ContactMotion::apply_transpose, ContactMotion::rates,
      ContactMotion::apply_mass, ContactMotion::solve;
  void rates(const VecX& v, VecX& w) const override { packed_.rates(v, w); }
  void apply_transpose(const VecX& lambda, VecX& p) const override {
    packed_.wrenches(lambda, p);
    if (rows_.joints) p = with_joints(rows_, p);
  }
  void apply_mass(const VecX& v, VecX& p) const override { node_wrenches(rows_, v, p); }
  void apply_inverse_mass(const VecX& p, VecX& v) const override { node_accelerations(rows_, p, v); }
  const VecX& diagonal() const override { return diagonal_; }
  void factor(const std::vector<Mat3>& D, Symmetry symmetry) const override;
  void solve(const VecX& g, VecX& v) const override;

 private:
  const ContactRows& rows_;
  PackedContacts packed_;
  EliminationPlan plan_;
  VecX diagonal_;
  mutable JointedMatrix matrix_;            ///< Of the Newton steps;
  mutable std::optional<NodeSystem> held_;  ///< where that is not possible.
};

/// 1 / mean diagonal of A of each contact (n, [kg] where A is in [1/kg]); a contact whose block vanishes
/// against the others gets the mass of the largest entry; 1 where all vanish.
VecX effective_masses(const VecX& diagonal);

}  // namespace rigor
