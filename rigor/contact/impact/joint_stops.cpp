#include "rigor/contact/impact/joint_stops.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// A stop as a contact; its gap is the distance to the limit.
Contact make_stop(const Joint& joint, const JointStop& stop, double gap, const Vec3& p_W) {
  Contact contact{};
  contact.body_A = joint.body_A == world_body ? joint.body_B : joint.body_A;
  contact.body_B = joint.body_B == world_body ? joint.body_A : joint.body_B;
  contact.shape_A = -1 - stop.joint;
  contact.shape_B = -1 - (4 * stop.axis + static_cast<int>(stop.kind));
  contact.point.p_WA = contact.point.p_WB = p_W;
  contact.point.n_W = Vec3::UnitZ();
  contact.point.gap = gap;
  contact.stop = stop;
  contact.friction = contact.is_bounded_force() ? 1 : 0;
  contact.restitution = joint.axes[at(stop.axis)].restitution;
  return contact;
}

bool holds(const std::vector<Contact>& contacts, const JointStop& stop) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    return contact.stop && contact.stop->joint == stop.joint && contact.stop->axis == stop.axis &&
           contact.stop->kind == stop.kind;
  });
}

/// Calls visit(stop, gap, anchor) for both limits of every limited coordinate.
template <class Visit>
void for_each_limit(const Model& model, int index, const std::vector<int>& bodies,
                    const std::vector<BodyKinetics>& kinetics, const Visit& visit) {
  const Joint& joint = model.joint(index);
  for (int k = 0; k < static_cast<int>(joint.axes.size()); ++k) {
    const JointAxis& axis = joint.axes[at(k)];
    if (!axis.is_limited()) continue;
    const BodyMotion A = motion_of(joint.body_A, bodies, kinetics),
                     B = motion_of(joint.body_B, bodies, kinetics);
    const double value = joint_coordinate(joint, k, A, B).value;
    const Vec3 anchor = B.x + B.R * joint.X_BK.p;
    if (std::isfinite(axis.lower))
      visit(JointStop{index, k, JointStop::Kind::lower}, value - axis.lower, anchor);
    if (std::isfinite(axis.upper))
      visit(JointStop{index, k, JointStop::Kind::upper}, axis.upper - value, anchor);
  }
}

}  // namespace

std::vector<Contact> joint_stops(const Model& model, const std::vector<int>& joints,
                                 const std::vector<int>& bodies, const std::vector<BodyKinetics>& kinetics,
                                 double tolerance) {
  std::vector<Contact> stops;
  for (const int index : joints) {
    const Joint& joint = model.joint(index);
    for_each_limit(model, index, bodies, kinetics,
                   [&](const JointStop& stop, double gap, const Vec3& anchor) {
                     // A motor without a limit of force stands at its limits by itself.
                     const auto& motor = joint.axes[at(stop.axis)].motor;
                     if (motor && std::isinf(motor->max_force)) return;
                     if (gap <= tolerance) stops.push_back(make_stop(joint, stop, gap, anchor));
                   });
    for (int k = 0; k < static_cast<int>(joint.axes.size()); ++k) {
      const JointAxis& axis = joint.axes[at(k)];
      const BodyMotion B = motion_of(joint.body_B, bodies, kinetics);
      const Vec3 anchor = B.x + B.R * joint.X_BK.p;
      if (axis.friction > 0)
        stops.push_back(make_stop(joint, {index, k, JointStop::Kind::friction}, 0, anchor));
      if (axis.motor && std::isfinite(axis.motor->max_force))
        stops.push_back(make_stop(joint, {index, k, JointStop::Kind::motor}, 0, anchor));
    }
  }
  return stops;
}

std::vector<double> limit_clearances(const Model& model, const std::vector<int>& joints,
                                     const std::vector<int>& bodies,
                                     const std::vector<BodyKinetics>& kinetics,
                                     const std::vector<Contact>& without) {
  std::vector<double> clearances;
  for (const int index : joints) {
    for_each_limit(model, index, bodies, kinetics, [&](const JointStop& stop, double gap, const Vec3&) {
      if (!holds(without, stop)) clearances.push_back(gap);
    });
  }
  return clearances;
}

}  // namespace rigor
