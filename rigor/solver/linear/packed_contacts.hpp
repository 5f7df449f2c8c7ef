#pragma once

#include "rigor/solver/linear/contact_rows.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// The rows J of contacts laid out for many products with them: sides that are there, one after the other,
/// each as rows and as columns, so that all numbers of a product lie side by side.
class PackedContacts {
 public:
  explicit PackedContacts(const ContactRows& rows);

  /// J V (3n).
  void rates(const VecX& V, VecX& rates) const;
  /// Jᵀ λ (6 × nodes).
  void wrenches(const VecX& lambda, VecX& wrenches) const;

 private:
  struct Side {
    std::ptrdiff_t node;             ///< Place of the node's six numbers.
    std::array<double, 18> rows;     ///< J.
    std::array<double, 24> columns;  ///< Its columns, each filled up to four numbers.
  };

  Eigen::Index size_;  ///< 6 × nodes.
  std::vector<Side> sides_;
  std::vector<std::size_t> ends_;  ///< Of the sides of each contact.
};

}  // namespace rigor
