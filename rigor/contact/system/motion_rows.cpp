#include "rigor/contact/system/motion_rows.hpp"

#include "rigor/core/index.hpp"

#include <tuple>
#include <utility>

namespace rigor {

namespace {

Mat6 block_diagonal(double linear, const Mat3& angular) {
  Mat6 block = Mat6::Zero();
  block.diagonal().head<3>().setConstant(linear);
  block.bottomRightCorner<3, 3>() = angular;
  return block;
}

int add_node(const Mat6& mass, const Mat6& inverse_mass, ContactRows& rows) {
  rows.masses.push_back(mass);
  rows.inverse_masses.push_back(inverse_mass);
  return static_cast<int>(rows.masses.size()) - 1;
}

}  // namespace

ContactRows motion_rows(const ContactSystem& system) {
  ContactRows rows;

  // One node per dynamic body.
  std::vector<int> nodes;
  for (const BodyKinetics& body : system.kinetics) {
    const bool gives_way = body.inverse_mass > 0;
    nodes.push_back(gives_way ? add_node(block_diagonal(1 / body.inverse_mass, body.inertia),
                                         block_diagonal(body.inverse_mass, body.inverse_inertia), rows)
                              : -1);
  }

  // J of each contact on the nodes of its bodies, and on that of its load.
  int loads = 0, load_node = -1;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const ContactJacobian& jacobian = system.rows[i];
    ContactRows::Sides sides;
    for (const auto& [k, body, J] :
         {std::tuple{0, contact.body_A, &jacobian.A}, std::tuple{1, contact.body_B, &jacobian.B}}) {
      ContactRows::Side& side = sides[at(k)];
      side.node = nodes[at(system.local_index(body))];
      if (side.node >= 0) side.J = *J;
    }
    if (jacobian.mobility > 0) {
      // Loads share nodes, a velocity each.
      const int velocity = loads++ % 6;
      if (velocity == 0) load_node = add_node(Mat6::Identity(), Mat6::Identity(), rows);
      rows.masses.back()(velocity, velocity) = 1 / jacobian.mobility;
      rows.inverse_masses.back()(velocity, velocity) = jacobian.mobility;
      sides[2].node = load_node;
      sides[2].J(2, velocity) = 1;
    }
    rows.contacts.push_back(sides);
  }

  // The nodes that joints hold respond together.
  if (!system.joints || system.joints->held_bodies().empty()) return rows;
  std::vector<int> held;
  for (const std::size_t body : system.joints->held_bodies()) held.push_back(nodes[body]);
  constrain_nodes(std::shared_ptr<const ConstrainedMass>(system.joints, &system.joints->equations()),
                  std::move(held), rows);
  return rows;
}

ContactRows moment_rows(const ContactSystem& system) {
  ContactRows rows = motion_rows(system);
  std::vector<ContactRows::Sides> entries;
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    ContactRows::Sides moments = rows.contacts[i];
    for (ContactRows::Side& side : moments) {
      // The axes along which forces act on a body's velocity are those about which moments act on its
      // angular velocity.
      const Mat3 axes = side.J.leftCols<3>();
      side.J.setZero();
      if (!system.contacts[i].stop) side.J.rightCols<3>() = axes;
    }
    // Forces and moments of each contact in turn.
    entries.push_back(rows.contacts[i]);
    entries.push_back(moments);
  }
  rows.contacts = std::move(entries);
  return rows;
}

}  // namespace rigor
