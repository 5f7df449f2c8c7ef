#include "rigor/bulk/joints/joint_approach.hpp"

#include "rigor/bulk/joints/approach_speed.hpp"
#include "rigor/bulk/joints/joint_errors.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Whether the joint surely holds to `most` [m] and [rad]: a cheap test, which most joints pass.
bool surely_holds(const JointTraits& traits, const JointStart& start, double most) {
  if (!traits.holds_point() || start.offset.squaredNorm() > most * most) return false;
  if (traits.held_rotation == LockedRotation::none) return true;
  // Twice the vector of the quaternion from F to K is the rotation vector, to third order; a hinge rotates
  // freely about z.
  const Quat &J = start.J, &K = start.K;
  const double x = J.w() * K.x() - J.x() * K.w() - J.y() * K.z() + J.z() * K.y(),
               y = J.w() * K.y() + J.x() * K.z() - J.y() * K.w() - J.z() * K.x();
  const double swing = 4 * (x * x + y * y);
  if (traits.held_rotation == LockedRotation::swing) return swing <= most * most;
  const double z = J.w() * K.z() - J.x() * K.y() + J.y() * K.x() - J.z() * K.w();
  return traits.held_rotation == LockedRotation::all && swing + 4 * z * z <= most * most;
}

/// The part of what is missed that is still left out when `done` of it has been put back.
double share_left(double done, double whole) {
  return whole > done ? 1 - done / whole : 0;
}

}  // namespace

void note_approach(const Joint& joint, const JointStart& start, int link, int lane, double h,
                   std::vector<JointApproach>& approaches) {
  const double most = kApproachSpeed * h;
  const JointTraits& traits = joint_traits(joint.type);
  if (surely_holds(traits, start, most)) return;

  // What it misses of the offset and of the rotation, along F's axes.
  const Quat q_FK = start.J.conjugate() * start.K;
  const Vec3 d_F = start.J.conjugate() * start.offset,
             held_F = held_displacement(joint, d_F, 2 * std::atan2(q_FK.z(), q_FK.w())),
             turn_F = held_turn(joint.type, q_FK);
  if (!(held_F.norm() > most || turn_F.norm() > most)) return;

  JointApproach& found = approaches.emplace_back();
  found.link = link;
  found.lane = lane;
  found.start = start;
  found.length = joint.length;
  found.turn = start.J * turn_F;
  if (traits.relation == JointRelation::distance)
    found.stretch = held_F.x();
  else
    found.gap = start.J * held_F;
}

void approach(double h, std::vector<JointApproach>& approaches, JointBlock& block) {
  for (JointApproach& a : approaches) {
    // So much more is put back.
    a.moved += kApproachSpeed * h;
    a.rotated += kApproachSpeed * h;
    const double gap_left = share_left(a.moved, std::max(a.gap.norm(), std::abs(a.stretch))),
                 turn_left = share_left(a.rotated, a.turn.norm());

    // What is left is no error yet.
    JointLanes& joint = block.joints[at(a.link)];
    set_lane(Vec3(a.start.offset - gap_left * a.gap), a.lane, joint.offset);
    set_lane(Quat(rotation_exp(-turn_left * a.turn) * a.start.K), a.lane, joint.K);
    joint.length[a.lane] = static_cast<float>(a.length + gap_left * a.stretch);
  }
}

void set_lane(const Vec3& a, int lane, FloatVec3& to) {
  to.x[lane] = static_cast<float>(a.x());
  to.y[lane] = static_cast<float>(a.y());
  to.z[lane] = static_cast<float>(a.z());
}

void set_lane(const Quat& q, int lane, FloatQuat& to) {
  to.w[lane] = static_cast<float>(q.w());
  set_lane(Vec3(q.vec()), lane, to.v);
}

}  // namespace rigor
