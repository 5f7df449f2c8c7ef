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
      joints_by_body_(joints_by_body(model)),
      groups_(at(model.body_count()) + 1) {}

ContactSystem ContactSystemAssembler::assemble(double t, const std::vector<int>& bodies,
                                               std::span<const BodyPhase> phases,
                                               std::vector<Contact> contacts) const {
  // Which bodies take part, and how they move.
  Group& group = group_of(bodies);
  Bodies all = bodies_at(t, group, phases, contacts);

  // The constraint rows of the joints, then those of the contacts.
  std::shared_ptr<const JointSystem> joints = equations_of(group, all, {.motor_horizon = motor_horizon_});
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             std::move(joints));
}

ContactSystem ContactSystemAssembler::assemble_joints(double t, const std::vector<int>& bodies,
                                                      std::span<const BodyPhase> phases,
                                                      bool with_motors) const {
  Group& group = group_of(bodies);
  Bodies all = bodies_at(t, group, phases, {});
  std::shared_ptr<const JointSystem> joints =
      equations_of(group, all, {.motor_horizon = motor_horizon_, .without_motors = !with_motors});
  return make_contact_system(model_, {}, std::move(all.indices), std::move(all.kinetics), std::move(joints));
}

ContactSystem ContactSystemAssembler::assemble(const Island& island, double t,
                                               std::span<const BodyPhase> phases) const {
  // Which bodies take part, how they move, and where their contacts have gone with them.
  Group& group = group_of(island.bodies);
  Bodies all = bodies_at(t, group, phases, island.contacts);
  std::vector<Contact> contacts = island.contacts;
  if (t != island.begin) track_contacts(island, all, contacts);

  // The constraint rows of the joints, then those of the contacts.
  std::shared_ptr<const JointSystem> joints =
      equations_of(group, all, {island.joint_rows ? &*island.joint_rows : nullptr, motor_horizon_});
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             std::move(joints));
}

ContactSystem ContactSystemAssembler::assemble_contacts(const Island& island, double t,
                                                        std::span<const BodyPhase> phases) const {
  Bodies all = bodies_at(t, group_of(island.bodies), phases, island.contacts);
  std::vector<Contact> contacts = island.contacts;
  if (t != island.begin) track_contacts(island, all, contacts);
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             nullptr);
}

ContactSystem ContactSystemAssembler::assemble_contacts(const Cluster& cluster,
                                                        std::vector<Contact> contacts) const {
  Bodies all = bodies_at(cluster.t, group_of(cluster.bodies), cluster.phases, contacts);
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             nullptr);
}

ContactSystemAssembler::Bodies ContactSystemAssembler::bodies_at(double t, const std::vector<int>& bodies,
                                                                 std::span<const BodyPhase> phases) const {
  return bodies_at(t, group_of(bodies), phases, {});
}

/// What is known of the bodies since the last question about them, or what is found out now.
ContactSystemAssembler::Group& ContactSystemAssembler::group_of(const std::vector<int>& bodies) const {
  Group& group = groups_[bodies.empty() ? groups_.size() - 1 : at(bodies.front())];
  if (group.bodies == bodies) return group;
  group.bodies = bodies;
  group.joints = joints_of(bodies);
  group.with_jointed = bodies_of_joints(group.joints);
  group.with_jointed.insert(group.with_jointed.end(), bodies.begin(), bodies.end());
  group.with_jointed = sorted_unique(std::move(group.with_jointed));
  group.equations.reset();
  return group;
}

/// The equations of the group's joints, none if it has none: in the room of the last ones where nobody looks
/// at these any more.
std::shared_ptr<const JointSystem> ContactSystemAssembler::equations_of(
    Group& group, const Bodies& bodies, const JointSystem::RowRules& rules) const {
  if (group.joints.empty()) return nullptr;
  if (group.equations.use_count() == 1) {
    group.equations->update(model_, bodies.indices, bodies.kinetics, rules);
  } else {
    group.equations =
        std::make_shared<JointSystem>(model_, group.joints, bodies.indices, bodies.kinetics, rules);
  }
  return group.equations;
}

void ContactSystemAssembler::forget_factors() const {
  for (Group& group : groups_)
    if (group.equations) group.equations->forget_factors();
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

ContactSystemAssembler::Bodies ContactSystemAssembler::bodies_at(double t, const Group& group,
                                                                 std::span<const BodyPhase> phases,
                                                                 const std::vector<Contact>& contacts) const {
  // The group, with what joints and contacts tie to it.
  Bodies result{group.with_jointed, {}};
  if (!contacts.empty()) {
    for (const Contact& contact : contacts) {
      result.indices.push_back(contact.body_A);
      result.indices.push_back(contact.body_B);
    }
    result.indices = sorted_unique(std::move(result.indices));
  }

  // Bodies of the group move as their phases say, the others as prescribed. Both lists ascend.
  result.kinetics.reserve(result.indices.size());
  std::size_t next = 0;
  for (const int body : result.indices) {
    if (next < group.bodies.size() && group.bodies[next] == body) {
      result.kinetics.push_back(dynamic_kinetics(model_.body(body), phases[next++]));
    } else {
      result.kinetics.push_back(prescribed_kinetics(model_.body(body), t));
    }
  }
  return result;
}

Environment::BodyView ContactSystemAssembler::view_in(const ContactSystem& system, double t, int body) const {
  // Springs may end at bodies that are not in the system: prescribed ones.
  const std::size_t place = place_of(system.bodies, body);
  if (place < system.bodies.size() && system.bodies[place] == body) return view_of(system.kinetics[place]);
  return view_of(prescribed_kinetics(model_.body(body), t));
}

double ContactSystemAssembler::supplied_power(const ContactSystem& system, double t) const {
  const auto view = [&](int body) { return view_in(system, t, body); };
  double power = 0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) continue;
    power += environment_.supplied_power(system.bodies[b], view_of(system.kinetics[b])) +
             environment_.power_of_anchors(system.bodies[b], view);
  }
  return power;
}

double ContactSystemAssembler::supplied_power(double t, const std::vector<int>& bodies,
                                              std::span<const BodyPhase> phases) const {
  ContactSystem system;
  system.bodies = bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    system.kinetics.push_back(dynamic_kinetics(model_.body(bodies[i]), phases[i]));
  return supplied_power(system, t);
}

std::vector<Wrench> ContactSystemAssembler::environment_wrenches(const ContactSystem& system,
                                                                 double t) const {
  const auto view = [&](int body) { return view_in(system, t, body); };
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
