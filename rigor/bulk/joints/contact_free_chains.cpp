#include "rigor/bulk/joints/contact_free_chains.hpp"

#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"
#include "rigor/bulk/joints/contact_free_chain_kernels.hpp"
#include "rigor/bulk/joints/taut_links.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rigor {

namespace {

void set_lane(const Vec3& a, std::size_t lane, DoubleVec3& to) {
  const int k = static_cast<int>(lane);
  to.x[k] = a.x();
  to.y[k] = a.y();
  to.z[k] = a.z();
}

/// Of the body in one lane; without a body: of unit mass.
void set_body(const Body* body, std::size_t lane, ContactFreeChains::Body& to) {
  const int i = static_cast<int>(lane);
  const int first = body == nullptr ? 0 : axis_of_revolution(*body).value_or(0);
  for (int k = 0; k < 2; ++k) set_lane(Vec3::Unit((first + k) % 3), lane, to.axes_B[k]);
  for (int k = 0; k < 3; ++k) {
    to.moments[k][i] = body == nullptr ? 1 : static_cast<float>(body->moments[(first + k) % 3]);
  }
  // Of bodies of revolution the two are equal but for rounding.
  if (body != nullptr && axis_of_revolution(*body)) to.moments[1][i] = to.moments[2][i];
  const float largest = std::max({to.moments[0][i], to.moments[1][i], to.moments[2][i]});
  for (int k = 0; k < 3; ++k) to.ratios[k][i] = std::ldexp(to.moments[k][i], -std::ilogb(largest));
  to.spin[i] = to.moments[0][i] / to.moments[1][i] - 1;
  to.mass[i] = body == nullptr ? 1 : static_cast<float>(body->mass);
  to.inverse_mass[i] = body == nullptr ? 1 : static_cast<float>(1 / body->mass);
  to.reach[i] = 0;
}

}  // namespace

bool ContactFreeChains::is_possible(const JointSystems& systems) {
  return !systems.has_loops && std::all_of(systems.links.begin(), systems.links.end(), [](const auto& link) {
    return !link.has_joint || link.is_plain_ball();
  });
}

ContactFreeChains::ContactFreeChains(const Model& model, const JointSystems& systems)
    : impulses_(systems.links.size()) {
  tables_.slots = systems.bodies;
  tables_.bodies.resize(systems.moved, Body{});
  tables_.joints.resize(systems.links.size(), Joint{});
  // The bodies.
  for (std::size_t s = 0; s < systems.moved; ++s) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const int index = systems.bodies[s][lane];
      const rigor::Body* body = index < 0 ? nullptr : &model.body(index);
      set_body(body, lane, tables_.bodies[s]);
      tables_.are_of_revolution &= body == nullptr || axis_of_revolution(*body).has_value();
      tables_.are_round &= body == nullptr || body->moments.minCoeff() == body->moments.maxCoeff();
    }
  }

  // The joints: a link leads from the child of the same number to its parent.
  const std::vector<int> joints_of = joint_counts(systems);
  std::vector<bool> is_parent(systems.bodies.size());
  for (std::size_t i = 0; i < systems.links.size(); ++i) {
    const JointLink& link = systems.links[i];
    Joint& joint = tables_.joints[i];

    // The shape of the trees, which the eight lanes share.
    joint.slack = float_lanes(std::numeric_limits<float>::infinity());
    joint.has_children = is_parent[i];
    joint.numbers = link.joints;
    if (!link.has_joint) continue;
    const std::size_t parent = at(link.parent);
    joint.parent = link.parent;
    joint.parent_is_free = link.parent_is_free;
    joint.is_first = !is_parent[parent];
    is_parent[parent] = true;

    // Of each lane: arms, and the reach of the bodies.
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const int k = static_cast<int>(lane);
      joint.sign[k] = link.child_is_B ? 1 : -1;
      if (link.joints[lane] < 0) continue;
      const rigor::Joint& own = model.joint(link.joints[lane]);
      const Vec3 &arm_A = own.X_AF.p, &arm_B = own.X_BK.p;
      const Vec3 &arm_child = link.child_is_B ? arm_B : arm_A, &arm_parent = link.child_is_B ? arm_A : arm_B;
      set_lane(arm_child, lane, joint.arm_child_B);
      set_lane(arm_parent, lane, joint.arm_parent_B);
      const auto widen = [&](std::size_t body, const Vec3& arm) {
        float& reach = reinterpret_cast<float*>(&tables_.bodies[body].reach)[lane];
        reach = std::max(reach, static_cast<float>(arm.squaredNorm()));
      };
      widen(i, arm_child);
      if (link.parent_is_free) widen(parent, arm_parent);
      Slack slack;
      slack.add_body(model.body(systems.bodies[i][lane]).moments, joints_of[i], arm_child);
      if (link.parent_is_free)
        slack.add_body(model.body(systems.bodies[parent][lane]).moments, joints_of[parent], arm_parent);
      joint.slack[k] = static_cast<float>(slack.squared);
    }
  }
}

std::pair<double, int> ContactFreeChains::worst_gap(LaneTarget target, const BulkBodies& bodies) const {
  return target == LaneTarget::avx2 ? avx2_lanes::worst_gap(tables_, bodies)
                                    : portable_lanes::worst_gap(tables_, bodies);
}

void ContactFreeChains::advance(const Step& step, unsigned lanes, BulkBodies& bodies) {
  step.target == LaneTarget::avx2 ? avx2_lanes::advance(tables_, step, lanes, bodies, impulses_)
                                  : portable_lanes::advance(tables_, step, lanes, bodies, impulses_);
}

}  // namespace rigor
