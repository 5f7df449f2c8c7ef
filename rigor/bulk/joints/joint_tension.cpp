#include "rigor/bulk/joints/joint_tension.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <vector>

namespace rigor {

double square_of_vibration(float h, const JointBlock& block) {
  // tr(I⁻¹ K) of each body, by its place in the block.
  std::vector<FloatLanes> squares(block.slots.size(), float_lanes(0));
  const auto add = [&](int place, const FloatVec3& f, const FloatVec3& r) {
    const JointSlot& slot = block.slots[at(place)];
    const FloatSym3& W = slot.inverse_inertia;
    const FloatLanes trace = W.xx + W.yy + W.zz;
    squares[at(place)] += float_max(float_lanes(0), dot(f, r) * trace - dot(f, W * r));
  };
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    const JointLink& link = block.systems.links[i];
    const JointLanes& joint = block.joints[i];
    if (!link.has_joint || !joint_traits(link.type).holds_point()) continue;
    // Rows along the axes of W: the impulses are the force on B, and the rows have its arms.
    const FloatVec3 f{joint.impulse[0], joint.impulse[1], joint.impulse[2]};
    const auto arm = [](const FloatVec3* a) { return FloatVec3{a[1].z, -a[0].z, a[0].y}; };
    const int A = link.child_is_B ? link.parent : link.child, B = link.child_is_B ? link.child : link.parent;
    add(B, f, arm(joint.a_B));
    add(A, float_lanes(-1) * f, arm(joint.a_A));
  }
  float most = 0;
  for (std::size_t s = 0; s < block.systems.moved; ++s) {
    for (int lane = 0; lane < kLaneCount; ++lane) most = std::max(most, squares[s][lane]);
  }
  return static_cast<double>(most) / static_cast<double>(h);
}

}  // namespace rigor
