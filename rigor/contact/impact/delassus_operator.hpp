#pragma once

#include "rigor/solver/linear/contact_rows.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace rigor {

/// The Delassus operator A = J M⁻¹ Jᵀ of n contacts (3n × 3n) [1/kg]: as a matrix, or where contacts are many
/// by the rows that it is made of, which a product passes once. A matrix of 700 contacts has 35 MB.
class DelassusOperator {
 public:
  DelassusOperator() = default;
  /// The matrix itself.
  DelassusOperator(MatX A) : A_(std::move(A)) {}  // NOLINT(google-explicit-constructor): a matrix is one.
  /// By rows without joints. The operator shares them.
  explicit DelassusOperator(std::shared_ptr<const ContactRows> rows) : rows_(std::move(rows)) {}

  /// A λ (3n).
  VecX operator*(const VecX& lambda) const;
  /// The rows of contact i and the columns of contact k.
  Mat3 block(std::size_t i, std::size_t k) const;
  /// A as a matrix, formed if it is not one.
  MatX dense() const { return rows_ ? contact_response(*rows_) : A_; }

  /// A normal impulse of one contact moves the normal of another by so much.
  struct Coupling {
    std::size_t contact;
    double response;  ///< [1/kg].
  };
  /// For each contact those that it is coupled with by the normals, itself among them, in order.
  std::vector<std::vector<Coupling>> normal_couplings() const;

 private:
  std::size_t count() const;

  MatX A_;
  std::shared_ptr<const ContactRows> rows_;
};

}  // namespace rigor
