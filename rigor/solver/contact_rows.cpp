#include "rigor/solver/contact_rows.hpp"

namespace rigor {

using Eigen::Index;

VecX contact_rates(const ContactRows& rows, const VecX& V) {
  VecX rates = VecX::Zero(3 * static_cast<Index>(rows.contacts.size()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i)
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0) rates.segment<3>(3 * static_cast<Index>(i)) += side.J * V.segment<6>(6 * side.node);
  return rates;
}

VecX contact_wrenches(const ContactRows& rows, const VecX& lambda) {
  VecX wrenches = VecX::Zero(6 * static_cast<Index>(rows.node_count()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i)
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0)
        wrenches.segment<6>(6 * side.node) +=
            side.J.transpose() * lambda.segment<3>(3 * static_cast<Index>(i));
  return wrenches;
}

VecX node_accelerations(const ContactRows& rows, const VecX& p) {
  VecX a(p.size());
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    a.segment<6>(row) = rows.inverse_masses[k] * p.segment<6>(row);
  }
  return a;
}

VecX node_wrenches(const ContactRows& rows, const VecX& V) {
  VecX p(V.size());
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    p.segment<6>(row) = rows.masses[k] * V.segment<6>(row);
  }
  return p;
}

VecX contact_diagonal(const ContactRows& rows) {
  VecX diagonal = VecX::Zero(3 * static_cast<Index>(rows.contacts.size()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    for (const ContactRows::Side& side : rows.contacts[i]) {
      if (side.node < 0) continue;
      const ContactRows::Block moved = side.J * rows.inverse_masses[static_cast<std::size_t>(side.node)];
      diagonal.segment<3>(3 * static_cast<Index>(i)) += moved.cwiseProduct(side.J).rowwise().sum();
    }
  }
  return diagonal;
}

VecX term_sizes(const ContactRows& rows, const VecX& lambda) {
  VecX wrenches = VecX::Zero(6 * static_cast<Index>(rows.node_count()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i)
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0)
        wrenches.segment<6>(6 * side.node) +=
            side.J.cwiseAbs().transpose() * lambda.segment<3>(3 * static_cast<Index>(i)).cwiseAbs();
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    wrenches.segment<6>(row) = rows.inverse_masses[k].cwiseAbs() * wrenches.segment<6>(row).eval();
  }
  VecX sizes = VecX::Zero(lambda.size());
  for (std::size_t i = 0; i < rows.contacts.size(); ++i)
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0)
        sizes.segment<3>(3 * static_cast<Index>(i)) += side.J.cwiseAbs() * wrenches.segment<6>(6 * side.node);
  return sizes;
}

}  // namespace rigor
