#pragma once

#include "rigor/math/pose.hpp"
#include "rigor/model/joint.hpp"

#include <array>
#include <span>

namespace rigor {

/// What a joint has given to its body B.
struct JointImpulse {
  Vec3 linear_W = Vec3::Zero();   ///< [N s].
  Vec3 angular_W = Vec3::Zero();  ///< About its anchor on B [N m s].
  /// Of these what acts along each coordinate: motor, limits, spring, damper and dry friction [N m s] or
  /// [N s].
  std::array<double, 3> along{};
};

/// The impulses of the six rows of a joint (State::joint_impulses) as such, where its bodies are at these
/// poses X_WB. A gear has no bodies of its own, and gives none here.
JointImpulse joint_impulse(const Joint& joint, std::span<const float, 6> rows, const Pose& X_WA,
                           const Pose& X_WB);

}  // namespace rigor
