#include "rigor/bulk/sleep/sleep.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace rigor {

namespace {

float speed_of(const MotionRecord& motion, float radius) {
  const auto norm = [](const float* a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); };
  return norm(motion.v) + norm(motion.w) * radius;
}

bool is_driving(const JointAxis& axis) {
  return axis.motor && axis.motor->velocity != 0;
}

/// Pairs of bodies that joints and springs tie together.
std::vector<std::pair<int, int>> ties_of(const Model& model) {
  std::vector<std::pair<int, int>> ties;
  // A joint ties its first body to each of the others; a spring to the world ties nothing.
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    const std::vector<int> bodies = model.bodies_of_joint(i);
    for (std::size_t k = 1; k < bodies.size(); ++k) ties.emplace_back(bodies[0], bodies[k]);
  }
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring && spring->body_A != world_body && spring->body_B != world_body)
      ties.emplace_back(spring->body_A, spring->body_B);
  }
  return ties;
}

}  // namespace

namespace {

float radius_of(const Body& body) {
  return body.motion == MotionType::dynamic ? static_cast<float>(body.bounding_radius) : -1;
}

}  // namespace

SleepManager::SleepManager(const Model& model, const SleepRules& rules) : rules_(rules), islands_(model) {
  for (const Body& body : model.bodies()) radius_.push_back(radius_of(body));
  find_driven(model);
}

void SleepManager::change(const Model& model, const ChangedBodies& changed) {
  for (const int body : changed.bodies) radius_[at(body)] = radius_of(model.body(body));
  if (changed.are_ties_new) find_driven(model);
  islands_.change(model, changed);
}

void SleepManager::find_driven(const Model& model) {
  drivers_.clear();
  driven_.clear();
  // Kinematic bodies keep awake what is tied to them, while they move.
  for (const auto& [a, b] : ties_of(model)) {
    if (model.body(b).motion == MotionType::kinematic) drivers_.emplace_back(a, b);
    if (model.body(a).motion == MotionType::kinematic) drivers_.emplace_back(b, a);
  }
  // Motors keep their bodies awake.
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    const std::vector<JointAxis>& axes = model.joint(i).axes;
    if (std::none_of(axes.begin(), axes.end(), is_driving)) continue;
    for (const int body : model.bodies_of_joint(i)) driven_.push_back(body);
  }
}

bool SleepManager::is_quiet(const BulkBodies& bodies, int body) const {
  return speed_of(bodies.motion[at(body)], radius_[at(body)]) < static_cast<float>(rules_.speed);
}

bool SleepManager::wake(const BulkBodies& bodies, const ManifoldMemories& before,
                        const std::vector<ManifoldMemory>& now, const Disturbances& disturbances,
                        std::vector<float>& quiet_time) {
  RIGOR_ASSERT(quiet_time.size() == radius_.size());
  bool has_woken = false;
  const auto disturb = [&](int body) {
    if (radius_[at(body)] < 0) return;
    has_woken = has_woken || quiet_time[at(body)] == asleep;
    quiet_time[at(body)] = 0;
  };
  // Of bodies that are not dynamic, only those that move wake others.
  const auto is_moved_by = [&](int body, int other) {
    return radius_[at(body)] >= 0 && radius_[at(other)] < 0 && speed_of(bodies.motion[at(other)], 1) > 0;
  };
  // The user's disturbances, motors, and kinematic bodies that move keep awake the bodies that they act on or
  // are tied to.
  for (const int body : disturbances.bodies) disturb(body);
  for (const int body : driven_) disturb(body);
  for (const auto& [body, driver] : drivers_) {
    if (is_moved_by(body, driver)) disturb(body);
  }
  // A body that lost a contact wakes. Both lists are in the order of keys, so one pass finds the contacts
  // that are gone.
  std::size_t k = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    while (k < now.size() && now[k].key() < before.key(i)) ++k;
    if (k < now.size() && now[k].key() == before.key(i)) continue;
    for (const int body : {before.body_A(i), before.body_B(i)}) {
      if (quiet_time[at(body)] == asleep) disturb(body);
    }
  }
  // A kinematic body that moves wakes what it touches.
  for (const ManifoldMemory& contact : now) {
    for (const auto& [body, other] :
         {std::pair(contact.body_A, contact.body_B), std::pair(contact.body_B, contact.body_A)}) {
      if (is_moved_by(body, other)) disturb(body);
    }
  }
  // An island wakes as a whole if one of its bodies is awake, so that a chain of any length wakes in one
  // step.
  islands_.build(now);
  least_quiet_.assign(radius_.size(), asleep);
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    if (const int island = islands_.island_of(i); island >= 0)
      least_quiet_[at(island)] = std::min(least_quiet_[at(island)], quiet_time[at(i)]);
  }
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    const int island = islands_.island_of(i);
    if (island >= 0 && quiet_time[at(i)] == asleep && least_quiet_[at(island)] != asleep) disturb(i);
  }
  return has_woken;
}

void SleepManager::settle(double h, const ManifoldMemories& contacts, BulkBodies& bodies,
                          std::vector<float>& quiet_time) {
  RIGOR_ASSERT(quiet_time.size() == radius_.size());
  // Each body counts how long it has been quiet; its island takes the least of its bodies.
  islands_.build(contacts);
  least_quiet_.assign(radius_.size(), asleep);
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    const int island = islands_.island_of(i);
    if (island < 0) continue;
    float& quiet = quiet_time[at(i)];
    quiet = is_quiet(bodies, i) ? quiet + static_cast<float>(h) : 0;
    least_quiet_[at(island)] = std::min(least_quiet_[at(island)], quiet);
  }
  // An island falls asleep as a whole once all of its bodies have been quiet for the delay.
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    const int island = islands_.island_of(i);
    if (island < 0 || least_quiet_[at(island)] < static_cast<float>(rules_.delay)) continue;
    quiet_time[at(i)] = asleep;
    for (int axis = 0; axis < 3; ++axis) bodies.motion[at(i)].v[axis] = bodies.motion[at(i)].w[axis] = 0;
    bodies.L[at(i)] = Vec3::Zero();
  }
}

}  // namespace rigor
