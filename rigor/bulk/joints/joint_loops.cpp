#include "rigor/bulk/joints/joint_loops.hpp"

#include "rigor/core/index.hpp"

#include <map>

namespace rigor {

namespace {

std::array<int, 8> in_first_lane(int index) {
  std::array<int, 8> lanes;
  lanes.fill(-1);
  lanes[0] = index;
  return lanes;
}

}  // namespace

JointLoops::JointLoops(const Model& model, const std::vector<bool>& has_coordinates,
                       const std::vector<int>& joints) {
  systems_.has_loops = true;
  const auto add_slot = [&](int body) {
    systems_.bodies.push_back(in_first_lane(body));
    return static_cast<int>(systems_.bodies.size()) - 1;
  };
  // Bodies that joints move come first, each with one slot, in the order in which joints name them.
  std::map<int, int> moved;  // Slots of the bodies that joints move.
  for (const int j : joints) {
    for (const int body : {model.joint(j).body_A, model.joint(j).body_B}) {
      if (moves_freely(model, body) && !moved.contains(body)) moved[body] = add_slot(body);
    }
  }
  systems_.moved = systems_.bodies.size();
  // Bodies that joints do not move have a slot for each joint.
  const auto slot_of = [&](int body) {
    const auto found = moved.find(body);
    return found == moved.end() ? add_slot(body) : found->second;
  };

  // Joints with rows are links; gears refer to those of their wheels.
  std::map<int, int> link_of;
  for (const int j : joints) {
    const Joint& joint = model.joint(j);
    if (joint.type == JointType::gear) {
      gears_.push_back(j);
      continue;
    }
    JointLink link;
    link.joints = in_first_lane(j);
    link.type = joint.type;
    link.has_laws = has_coordinates[at(j)];
    link.parent_is_free = moves_freely(model, joint.body_A);
    link.parent = slot_of(joint.body_A);
    link.child = slot_of(joint.body_B);
    link_of[j] = static_cast<int>(systems_.links.size());
    systems_.links.push_back(link);
  }
  // Gears act between the links of their wheels.
  for (const int g : gears_) {
    const Joint& gear = model.joint(g);
    systems_.gears.push_back({in_first_lane(g), link_of.at(gear.first_joint), link_of.at(gear.second_joint)});
  }
}

std::vector<int> JointLoops::signature() const {
  std::vector<int> signs{static_cast<int>(systems_.moved)};
  for (const JointLink& link : systems_.links) {
    signs.insert(signs.end(), {static_cast<int>(link.type), link.has_laws ? 1 : 0, link.child, link.parent});
  }
  for (const GearLink& gear : systems_.gears) signs.insert(signs.end(), {-1, gear.first, gear.second});
  return signs;
}

JointSystems JointLoops::begin() const {
  JointSystems systems = systems_;
  for (std::array<int, 8>& bodies : systems.bodies) bodies.fill(-1);
  for (JointLink& link : systems.links) link.joints.fill(-1);
  for (GearLink& gear : systems.gears) gear.joints.fill(-1);
  return systems;
}

void JointLoops::add_lane(std::size_t lane, JointSystems& systems) const {
  for (std::size_t s = 0; s < systems_.bodies.size(); ++s) systems.bodies[s][lane] = systems_.bodies[s][0];
  for (std::size_t i = 0; i < systems_.links.size(); ++i) {
    systems.links[i].joints[lane] = systems_.links[i].joints[0];
  }
  for (std::size_t g = 0; g < gears_.size(); ++g) systems.gears[g].joints[lane] = gears_[g];
}

}  // namespace rigor
