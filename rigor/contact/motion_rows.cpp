#include "rigor/contact/motion_rows.hpp"

#include "rigor/math/rotation.hpp"

#include <tuple>

namespace rigor {

namespace {

Mat6 block_diagonal(double linear, const Mat3& angular) {
  Mat6 block = Mat6::Zero();
  block.diagonal().head<3>().setConstant(linear);
  block.bottomRightCorner<3, 3>() = angular;
  return block;
}

}  // namespace

ContactRows motion_rows(const ContactSystem& system) {
  ContactRows rows;
  std::vector<int> nodes;
  for (const BodyKinetics& body : system.kinetics) {
    const bool gives_way = body.inverse_mass > 0;
    nodes.push_back(gives_way ? static_cast<int>(rows.masses.size()) : -1);
    if (!gives_way) continue;
    rows.masses.push_back(block_diagonal(1 / body.inverse_mass, body.inertia));
    rows.inverse_masses.push_back(block_diagonal(body.inverse_mass, body.inverse_inertia));
  }
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    std::array<ContactRows::Side, 2> sides;
    for (const auto& [k, body, sign] :
         {std::tuple{0, contact.body_A, -1.0}, std::tuple{1, contact.body_B, 1.0}}) {
      const std::size_t local = static_cast<std::size_t>(system.local_index(body));
      ContactRows::Side& side = sides[static_cast<std::size_t>(k)];
      side.node = nodes[local];
      if (side.node < 0) continue;
      // The velocity of the contact's point is v + ω × r.
      const Mat3 axes = sign * system.frames[i].transpose();
      side.J << axes, -axes * skew(contact.p_W() - system.kinetics[local].x);
    }
    rows.contacts.push_back(sides);
  }
  return rows;
}

}  // namespace rigor
