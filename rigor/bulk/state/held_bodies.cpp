#include "rigor/bulk/state/held_bodies.hpp"

#include <array>

namespace rigor {

HeldBodies::HeldBodies(const Model& model) : is_held_(at(model.body_count()), 0) {
  // From what stands or moves as it must over fixed joints, as far as they lead.
  const auto is_holding = [&](int body) {
    return body == world_body || model.body(body).motion != MotionType::dynamic || contains(body);
  };
  std::vector<std::array<int, 2>> welds;
  for (const Joint& joint : model.joints())
    if (joint.type == JointType::fixed) welds.push_back({joint.body_A, joint.body_B});
  for (bool is_new = !welds.empty(); is_new;) {
    is_new = false;
    for (const auto& [A, B] : welds) {
      if (is_holding(A) == is_holding(B)) continue;
      is_held_[at(is_holding(A) ? B : A)] = 1;
      is_new = true;
    }
  }
  for (int body = 0; body < model.body_count(); ++body)
    if (contains(body)) held_.push_back(body);
  if (!held_.empty()) strikes_.assign(is_held_.size(), {});
}

void HeldBodies::strike(int body, const Vec3& dv, const Vec3& dw) {
  MotionRow& row = strikes_[at(body)];
  for (int k = 0; k < 3; ++k) {
    row[at(k)] += static_cast<float>(dv[k]);
    row[at(4 + k)] += static_cast<float>(dw[k]);
  }
}

bool HeldBodies::take_strikes(BulkBodies& bodies) {
  bool was_struck = false;
  for (const int body : held_) {
    MotionRow& row = strikes_[at(body)];
    if (row == MotionRow{}) continue;
    MotionRecord& motion = bodies.motion[at(body)];
    for (std::size_t k = 0; k < 3; ++k) {
      motion.v[k] += row[k];
      motion.w[k] += row[4 + k];
    }
    row = {};
    was_struck = true;
  }
  return was_struck;
}

}  // namespace rigor
