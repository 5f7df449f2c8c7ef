#include "rigor/bulk/joints/joint_gears.hpp"

#include "rigor/core/index.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

constexpr double revolution = 2 * std::numbers::pi;

/// The period of a gear in the difference of its coordinates [rad], GearLanes::period. For two angles it
/// follows from the numbers of teeth p and q, ratio = p/q with q at most 1000: whole revolutions add
/// multiples of 2π/q.
double period_of(double ratio, bool first_rotates, bool second_rotates) {
  if (first_rotates && second_rotates) {
    // The least number of teeth q for which the ratio times q is a whole number to rounding.
    for (int q = 1; q <= 1000; ++q) {
      const double p = std::round(ratio * q);
      if (std::abs(ratio * q - p) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(p)) {
        return revolution / q;
      }
    }
    return 0;
  }
  // A rack: whole revolutions of its wheel move the rod by multiples of this.
  if (first_rotates) return revolution * std::abs(ratio);
  return second_rotates ? revolution : std::numeric_limits<double>::infinity();
}

double dot_lane(const FloatVec3& a, const FloatVec3& b, int lane) {
  return static_cast<double>(a.x[lane]) * b.x[lane] + static_cast<double>(a.y[lane]) * b.y[lane] +
         static_cast<double>(a.z[lane]) * b.z[lane];
}

/// The row of the first coordinate of a wheel.
int wheel_row(const JointLink& wheel) {
  return held_row_count(wheel.type, true);
}

double wheel_rate(const JointBlock& block, int index, int lane) {
  const JointLink& wheel = block.systems.links[at(index)];
  const JointLanes& joint = block.joints[at(index)];
  const JointSlot& child = block.slots[at(wheel.child)];
  const JointSlot& parent = block.slots[at(wheel.parent)];
  // The sides of the joint in the order of its row, whichever of them is the child.
  const JointSlot &A = wheel.child_is_B ? parent : child, &B = wheel.child_is_B ? child : parent;
  const int r = wheel_row(wheel);
  return dot_lane(joint.n[r], B.v, lane) - dot_lane(joint.n[r], A.v, lane) +
         dot_lane(joint.a_B[r], B.w, lane) - dot_lane(joint.a_A[r], A.w, lane);
}

double wheel_coordinate(const JointBlock& block, int index, int lane) {
  const int r = wheel_row(block.systems.links[at(index)]);
  return block.joints[at(index)].coordinate[r][lane];
}

double gear_rate(const JointBlock& block, std::size_t g, std::size_t lane) {
  const GearLink& link = block.systems.gears[g];
  const int l = static_cast<int>(lane);
  return wheel_rate(block, link.second, l) - block.gears[g].ratio[lane] * wheel_rate(block, link.first, l);
}

/// By how much it is off where the bodies are.
double gear_offset(const JointBlock& block, std::size_t g, std::size_t lane) {
  const GearLink& link = block.systems.gears[g];
  const GearLanes& gear = block.gears[g];
  // Without a period whole revolutions make any difference, so that positions tell nothing.
  if (gear.period[lane] == 0) return 0;
  const int l = static_cast<int>(lane);
  const double off =
      wheel_coordinate(block, link.second, l) - gear.ratio[lane] * wheel_coordinate(block, link.first, l);
  return std::remainder(off, gear.period[lane]);
}

/// Calls residual(gear, lane) for all gears.
template <class Residual>
void set_residuals(JointBlock& block, const Residual& residual) {
  for (std::size_t g = 0; g < block.gears.size(); ++g) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      if (block.systems.gears[g].joints[lane] < 0) continue;
      block.gears[g].residual[lane] = static_cast<float>(residual(g, lane));
    }
  }
}

}  // namespace

std::vector<GearLanes> make_gears(const Model& model, const JointSystems& systems) {
  std::vector<GearLanes> gears;
  const auto is_rotation = [&](int joint) { return is_angle(model.joint(joint).type, 0); };
  for (const GearLink& link : systems.gears) {
    GearLanes gear{};
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      if (link.joints[lane] < 0) continue;
      const Joint& joint = model.joint(link.joints[lane]);
      gear.ratio[lane] = joint.parameter;
      gear.period[lane] =
          period_of(joint.parameter, is_rotation(joint.first_joint), is_rotation(joint.second_joint));
    }
    gears.push_back(gear);
  }
  return gears;
}

void set_gear_errors(float h, JointBlock& block) {
  set_residuals(block, [&](std::size_t g, std::size_t lane) {
    // The rate that would be left, and what is off where the bodies would be, taken back within one substep.
    return gear_rate(block, g, lane) + gear_offset(block, g, lane) / h;
  });
}

void set_gear_drifts(JointBlock& block) {
  set_residuals(block, [&](std::size_t g, std::size_t lane) { return gear_rate(block, g, lane); });
}

}  // namespace rigor
