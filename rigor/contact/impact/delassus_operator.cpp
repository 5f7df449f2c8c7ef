#include "rigor/contact/impact/delassus_operator.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <utility>

namespace rigor {

using Eigen::Index;

VecX DelassusOperator::operator*(const VecX& lambda) const {
  if (!rows_) return A_ * lambda;
  return contact_rates(*rows_, node_accelerations(*rows_, contact_wrenches(*rows_, lambda)));
}

Mat3 DelassusOperator::block(std::size_t i, std::size_t k) const {
  if (!rows_) return A_.block<3, 3>(3 * static_cast<Index>(i), 3 * static_cast<Index>(k));
  Mat3 sum = Mat3::Zero();
  for (const ContactRows::Side& of_i : rows_->contacts[i]) {
    for (const ContactRows::Side& of_k : rows_->contacts[k]) {
      if (of_i.node >= 0 && of_i.node == of_k.node)
        sum += of_i.J * rows_->inverse_masses[at(of_i.node)] * of_k.J.transpose();
    }
  }
  return sum;
}

std::size_t DelassusOperator::count() const {
  return rows_ ? rows_->contacts.size() : static_cast<std::size_t>(A_.rows() / 3);
}

std::vector<std::vector<DelassusOperator::Coupling>> DelassusOperator::normal_couplings() const {
  // Contacts of one body may be coupled; without bodies, all may.
  std::vector<std::vector<std::size_t>> candidates(count());
  if (rows_) {
    std::vector<std::vector<std::size_t>> of_node(rows_->node_count());
    for (std::size_t i = 0; i < count(); ++i) {
      for (const ContactRows::Side& side : rows_->contacts[i])
        if (side.node >= 0) of_node[at(side.node)].push_back(i);
    }
    for (const std::vector<std::size_t>& contacts : of_node) {
      for (const std::size_t i : contacts)
        candidates[i].insert(candidates[i].end(), contacts.begin(), contacts.end());
    }
  } else {
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t k = 0; k < count(); ++k) candidates[i].push_back(k);
    }
  }

  // Those among them that move each other.
  std::vector<std::vector<Coupling>> couplings(count());
  for (std::size_t i = 0; i < count(); ++i) {
    for (const std::size_t k : sorted_unique(std::move(candidates[i]))) {
      const double response = block(i, k)(2, 2);
      if (response != 0) couplings[i].push_back({k, response});
    }
  }
  return couplings;
}

}  // namespace rigor
