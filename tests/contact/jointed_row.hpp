#pragma once

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/model/model_builder.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigor::test {

/// Boxes of edge 1 m in a row on the floor with joints between them; body 0 is the floor.
struct JointedRow {
  std::shared_ptr<const Model> model;
  ContactSystem system;  ///< All stand by their four corners; stops of joints are contacts too.
};

/// Boxes 1.5 m apart with joints like the one given, that move with the linear and angular momentum asked
/// for, box by box [N s, N m s].
inline JointedRow jointed_row(int boxes, ModelBuilder::JointDescription joint,
                              const std::function<std::pair<Vec3, Vec3>()>& next_momenta) {
  ModelBuilder builder;
  builder.add_material({"m", 1, 0.4, 0});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (int i = 0; i < boxes; ++i) {
    BodyDescription box;
    box.name = "box" + std::to_string(i);
    box.p_WU = Vec3(1.5 * i, 0, 0.5);
    box.shapes.push_back({Box{Vec3(0.5, 0.5, 0.5)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(box);
    if (i == 0) continue;
    joint.name = "joint" + std::to_string(i);
    joint.bodies = {"box" + std::to_string(i - 1), "box" + std::to_string(i)};
    joint.anchors = {Vec3(1.5 * i - 0.75, 0, 0.5)};
    builder.add_joint(joint);
  }
  JointedRow row{builder.build(), {}};

  std::vector<int> bodies = {0}, joints;
  std::vector<BodyKinetics> kinetics = {BodyKinetics{}};
  std::vector<Contact> contacts;
  for (int i = 0; i < boxes; ++i) {
    const Body& body = row.model->body(i + 1);
    const auto [P, L] = next_momenta();
    bodies.push_back(i + 1);
    kinetics.push_back(dynamic_kinetics(body, BodyPhase{Vec3(1.5 * i, 0, 0.5), body.q_WB, P, L}));
    if (i > 0) joints.push_back(i - 1);
    for (const Contact& contact :
         find_contacts(*row.model, 0, i + 1, kinetics[0].pose(), kinetics.back().pose(), 1e-6))
      contacts.push_back(contact);
  }
  for (const Contact& stop : joint_stops(*row.model, joints, bodies, kinetics, 1e-6))
    contacts.push_back(stop);
  row.system = make_contact_system(*row.model, std::move(contacts), bodies, kinetics,
                                   std::make_shared<JointSystem>(*row.model, joints, bodies, kinetics));
  return row;
}

}  // namespace rigor::test
