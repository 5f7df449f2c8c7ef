#include "rigor/bulk/sleep.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace rigor {

namespace {

constexpr float asleep = std::numeric_limits<float>::infinity();

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

float speed_of(const MotionRecord& motion, float radius) {
  const auto norm = [](const float* a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); };
  return norm(motion.v) + norm(motion.w) * radius;
}

}  // namespace

SleepKeeper::SleepKeeper(const Model& model, const SleepRules& rules) : rules_(rules), islands_(model) {
  for (const Body& body : model.bodies())
    radius_.push_back(body.motion == MotionType::dynamic ? static_cast<float>(body.bounding_radius) : -1);
}

bool SleepKeeper::is_quiet(const BulkBodies& bodies, int body) const {
  return speed_of(bodies.motion[at(body)], radius_[at(body)]) < static_cast<float>(rules_.speed);
}

void SleepKeeper::wake(const BulkBodies& bodies, const std::vector<ManifoldMemory>& before,
                       const std::vector<ManifoldMemory>& now, const Disturbances& disturbances,
                       std::vector<float>& quiet_time) {
  RIGOR_ASSERT(quiet_time.size() == radius_.size());
  const auto disturb = [&](int body) {
    if (radius_[at(body)] >= 0) quiet_time[at(body)] = 0;
  };
  for (const int body : disturbances.bodies) disturb(body);
  std::size_t k = 0;
  for (const ManifoldMemory& contact : before) {
    while (k < now.size() && now[k].key() < contact.key()) ++k;
    if (k < now.size() && now[k].key() == contact.key()) continue;
    disturb(contact.body_A);
    disturb(contact.body_B);
  }
  for (const ManifoldMemory& contact : now) {
    for (const auto& [body, other] :
         {std::pair(contact.body_A, contact.body_B), std::pair(contact.body_B, contact.body_A)}) {
      // Of bodies that are not dynamic only those that move do anything.
      if (radius_[at(other)] < 0 && speed_of(bodies.motion[at(other)], 1) > 0) disturb(body);
    }
  }
  islands_.build(now);
  least_quiet_.assign(radius_.size(), asleep);
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    if (const int island = islands_.island_of(i); island >= 0)
      least_quiet_[at(island)] = std::min(least_quiet_[at(island)], quiet_time[at(i)]);
  }
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    const int island = islands_.island_of(i);
    if (island >= 0 && quiet_time[at(i)] == asleep && least_quiet_[at(island)] != asleep)
      quiet_time[at(i)] = 0;
  }
}

void SleepKeeper::settle(double h, const std::vector<ManifoldMemory>& contacts, BulkBodies& bodies,
                         std::vector<float>& quiet_time) {
  RIGOR_ASSERT(quiet_time.size() == radius_.size());
  islands_.build(contacts);
  least_quiet_.assign(radius_.size(), asleep);
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    const int island = islands_.island_of(i);
    if (island < 0) continue;
    float& quiet = quiet_time[at(i)];
    quiet = is_quiet(bodies, i) ? quiet + static_cast<float>(h) : 0;
    least_quiet_[at(island)] = std::min(least_quiet_[at(island)], quiet);
  }
  for (int i = 0; i < static_cast<int>(radius_.size()); ++i) {
    const int island = islands_.island_of(i);
    if (island < 0 || least_quiet_[at(island)] < static_cast<float>(rules_.delay)) continue;
    quiet_time[at(i)] = asleep;
    for (int axis = 0; axis < 3; ++axis) bodies.motion[at(i)].v[axis] = bodies.motion[at(i)].w[axis] = 0;
  }
}

}  // namespace rigor
