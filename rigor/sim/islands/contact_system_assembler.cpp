#include "rigor/sim/islands/contact_system_assembler.hpp"

#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

Pose pose_of(const BodyPhase& phase) {
  return {rotation_matrix(phase.q), phase.x};
}

}  // namespace

Environment::BodyView view_of(const BodyKinetics& body) {
  return {body.x, body.v, body.w, body.R, body.inverse_mass > 0};
}

ContactSystemAssembler::ContactSystemAssembler(const Model& model, const Environment& environment,
                                               double motor_horizon)
    : model_(model),
      environment_(environment),
      motor_horizon_(motor_horizon),
      joints_by_body_(joints_by_body(model)) {}

ContactSystem ContactSystemAssembler::assemble(double t, const std::vector<int>& bodies,
                                               std::span<const BodyPhase> phases,
                                               std::vector<Contact> contacts) const {
  // Which bodies take part, and how they move.
  std::vector<int> joints = joints_of(bodies);
  Bodies all = bodies_at(t, bodies, phases, contacts, joints);

  // The constraint rows of the joints, then those of the contacts.
  std::shared_ptr<const JointSystem> of_joints;
  if (!joints.empty())
    of_joints = std::make_shared<JointSystem>(model_, std::move(joints), all.indices, all.kinetics,
                                              JointSystem::RowRules{.motor_horizon = motor_horizon_});
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             std::move(of_joints));
}

ContactSystem ContactSystemAssembler::assemble(const Island& island, double t,
                                               std::span<const BodyPhase> phases,
                                               std::shared_ptr<JointSystem>* joint_room) const {
  // Which bodies take part, how they move, and where their contacts have gone with them.
  std::vector<int> joints = joints_of(island.bodies);
  Bodies all = bodies_at(t, island.bodies, phases, island.contacts, joints);
  std::vector<Contact> contacts = island.contacts;
  if (t != island.begin) track_contacts(island, all, contacts);

  // The constraint rows of the joints, in the room of an earlier stage if there is one, then those of the
  // contacts.
  const JointSystem::RowRules rules{island.joint_rows ? &*island.joint_rows : nullptr, motor_horizon_};
  std::shared_ptr<JointSystem> of_joints = joint_room ? *joint_room : nullptr;
  if (of_joints) {
    of_joints->update(model_, all.indices, all.kinetics, rules);
  } else if (!joints.empty()) {
    of_joints = std::make_shared<JointSystem>(model_, std::move(joints), all.indices, all.kinetics, rules);
    if (joint_room) *joint_room = of_joints;
  }
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             std::move(of_joints));
}

/// Moves the points of the contacts along with the surfaces from where the island began to where its bodies
/// are now.
void ContactSystemAssembler::track_contacts(const Island& island, const Bodies& now,
                                            std::vector<Contact>& contacts) const {
  const auto pose_at_begin = [&](int body) {
    return holds(island.bodies, body) ? pose_of(island.start[place_of(island.bodies, body)])
                                      : prescribed_kinetics(model_.body(body), island.begin).pose();
  };
  const auto pose_now = [&](int body) { return now.kinetics[place_of(now.indices, body)].pose(); };
  for (Contact& contact : contacts) {
    if (contact.stop) continue;
    contact.point =
        tracked_contact(model_, contact, pose_at_begin(contact.body_A), pose_at_begin(contact.body_B),
                        pose_now(contact.body_A), pose_now(contact.body_B));
  }
}

ContactSystemAssembler::Bodies ContactSystemAssembler::bodies_at(double t, const std::vector<int>& bodies,
                                                                 std::span<const BodyPhase> phases,
                                                                 const std::vector<Contact>& contacts,
                                                                 const std::vector<int>& joints) const {
  // The group, with what joints and contacts tie to it.
  std::vector<int> indices = bodies_of_joints(joints);
  indices.insert(indices.end(), bodies.begin(), bodies.end());
  for (const Contact& contact : contacts) {
    indices.push_back(contact.body_A);
    indices.push_back(contact.body_B);
  }
  Bodies result{sorted_unique(std::move(indices)), {}};

  // Bodies of the group move as their phases say, the others as prescribed.
  for (const int body : result.indices) {
    result.kinetics.push_back(holds(bodies, body)
                                  ? dynamic_kinetics(model_.body(body), phases[place_of(bodies, body)])
                                  : prescribed_kinetics(model_.body(body), t));
  }
  return result;
}

std::vector<Wrench> ContactSystemAssembler::environment_wrenches(const ContactSystem& system,
                                                                 double t) const {
  // Springs may end at bodies that are not in the system: prescribed ones.
  const auto view = [&](int body) {
    if (holds(system.bodies, body)) return view_of(system.of(body));
    return view_of(prescribed_kinetics(model_.body(body), t));
  };
  std::vector<Wrench> wrenches(system.bodies.size());
  environment_.apply_env_forces(system.bodies, view, wrenches);

  // No force moves a prescribed body.
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) wrenches[b] = Wrench{};
  }
  return wrenches;
}

std::vector<int> ContactSystemAssembler::joints_of(const std::vector<int>& bodies) const {
  std::vector<int> joints;
  for (const int body : bodies) {
    const std::vector<int>& own = joints_by_body_[at(body)];
    joints.insert(joints.end(), own.begin(), own.end());
  }
  return sorted_unique(std::move(joints));
}

std::vector<int> ContactSystemAssembler::bodies_of_joints(const std::vector<int>& joints) const {
  std::vector<int> bodies;
  for (const int joint : joints) {
    const std::vector<int> own = model_.bodies_of_joint(joint);
    bodies.insert(bodies.end(), own.begin(), own.end());
  }
  return sorted_unique(std::move(bodies));
}

std::vector<int> ContactSystemAssembler::jointed_prescribed(const std::vector<int>& bodies) const {
  std::vector<int> result = bodies_of_joints(joints_of(bodies));
  std::erase_if(result, [this](int body) { return model_.body(body).motion == MotionType::dynamic; });
  return result;
}

double ContactSystemAssembler::joint_residual(double t, const std::vector<int>& bodies,
                                              std::span<const BodyPhase> phases) const {
  if (joints_of(bodies).empty()) return 0;
  return assemble(t, bodies, phases, {}).joints->largest_residual().first;
}

}  // namespace rigor
