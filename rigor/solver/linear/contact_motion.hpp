#pragma once

#include "rigor/solver/linear/contact_matrix.hpp"
#include "rigor/solver/linear/contact_rows.hpp"
#include "rigor/solver/linear/node_system.hpp"

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
  virtual VecX rates(const VecX& v) const = 0;      ///< L v (3n).
  virtual VecX pull(const VecX& lambda) const = 0;  ///< Lᵀ λ, with what joints do about it.
  virtual VecX weigh(const VecX& v) const = 0;      ///< M v.
  virtual VecX lift(const VecX& p) const = 0;       ///< M⁻¹ p.
  virtual const VecX& diagonal() const = 0;         ///< Of A (3n).
  /// (M + Lᵀ D L)⁻¹ g, with one 3 × 3 matrix D a contact, positive semidefinite or any; of the motions that
  /// joints allow the one that solves it on them.
  virtual VecX newton_step(const std::vector<Mat3>& D, const VecX& g, Symmetry symmetry) const = 0;
};

/// Of a matrix A: L is its Cholesky factor with diagonal pivoting, which stops at round-off (1e-14 of the
/// largest diagonal), and M is 1.
class FactoredMotion : public ContactMotion {
 public:
  explicit FactoredMotion(const MatX& A);
  VecX rates(const VecX& v) const override { return L_ * v; }
  VecX pull(const VecX& lambda) const override { return L_.transpose() * lambda; }
  VecX weigh(const VecX& v) const override { return v; }
  VecX lift(const VecX& p) const override { return p; }
  const VecX& diagonal() const override { return diagonal_; }
  VecX newton_step(const std::vector<Mat3>& D, const VecX& g, Symmetry symmetry) const override;

 private:
  MatX L_;  ///< 3n × rank.
  VecX diagonal_;
};

/// Of rows on bodies: L is J, M the masses; each Newton step is one sparse factorisation.
class SparseMotion : public ContactMotion {
 public:
  /// Holds a reference to the rows.
  explicit SparseMotion(const ContactRows& rows);
  SparseMotion(const SparseMotion&) = delete;
  SparseMotion& operator=(const SparseMotion&) = delete;
  const EliminationPattern& pattern() const { return pattern_; }
  VecX rates(const VecX& v) const override { return contact_rates(rows_, v); }
  VecX pull(const VecX& lambda) const override { return with_joints(rows_, contact_wrenches(rows_, lambda)); }
  VecX weigh(const VecX& v) const override { return node_wrenches(rows_, v); }
  VecX lift(const VecX& p) const override { return node_accelerations(rows_, p); }
  const VecX& diagonal() const override { return diagonal_; }
  VecX newton_step(const std::vector<Mat3>& D, const VecX& g, Symmetry symmetry) const override;

 private:
  const ContactRows& rows_;
  EliminationPattern pattern_;
  VecX diagonal_;
  mutable std::optional<ContactMatrix> matrix_;  ///< Of the Newton steps; with joints NodeSystem has them.
};

/// 1 / mean diagonal of A of each contact (n, [kg] where A is in [1/kg]); a contact whose block vanishes
/// against the others gets the mass of the largest entry.
VecX effective_masses(const VecX& diagonal);

}  // namespace rigor
