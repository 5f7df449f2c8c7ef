#pragma once

#include "rigor/bulk/joints/joint_forest.hpp"
#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace rigor {

/// Eight doubles, one a lane.
using DoubleLanes = double __attribute__((vector_size(64)));
using NumberLanes = std::int64_t __attribute__((vector_size(64)));
struct DoubleVec3 {
  DoubleLanes x, y, z;
};

/// Trees of ball joints without laws of which no body touches anything in a step take all its substeps at
/// once, eight trees side by side, by the method of docs/theory/bulk_joints.md, §1 and §2. Since nothing else
/// acts on them between two substeps, bodies are read and written once a step.
class ContactFreeChains {
 public:
  /// For `systems` for which is_possible() holds.
  ContactFreeChains(const Model& model, const JointSystems& systems);
  static bool is_possible(const JointSystems& systems);

  /// A step: `substeps` substeps of h [s], with the accelerations of all bodies.
  struct Step {
    float h;
    int substeps;
    const std::vector<MotionRow>& accelerations;
    const std::vector<float>& impulses;  ///< Of all joints in a substep before, six numbers each, or none.
    LaneTarget target;
  };
  /// Advances the trees in the lanes of `lanes`, one bit each; the others stay as they are.
  void advance(const Step& step, unsigned lanes, BulkBodies& bodies);
  /// The greatest distance of the two anchors of a joint at the beginning of a step [m], and the index of
  /// that joint in the Model (-1: all anchors meet).
  std::pair<double, int> worst_gap(LaneTarget target, const BulkBodies& bodies) const;
  /// Of joint i of the systems in the last substep, on body B [N s].
  const FloatVec3& impulse(std::size_t i) const { return impulses_[i].on_B; }

  /// Of eight bodies that joints move.
  struct alignas(64) Body {
    DoubleVec3 axes_B[2];  ///< The first two principal axes; the first is that of bodies of revolution.
    FloatLanes mass;       ///< [kg].
    FloatLanes inverse_mass;
    FloatLanes moments[3];  ///< About the axes [kg m²].
    FloatLanes ratios[3];   ///< The same in units of a power of two near the largest: cubes do not underflow.
    FloatLanes spin;        ///< Of bodies of revolution: moments[0] / moments[1] - 1.
    FloatLanes reach;       ///< Greatest distance of a joint from the centre of mass, squared [m²].
  };
  /// A body's joint on the way to the root.
  struct alignas(64) Joint {
    DoubleVec3 arm_child_B, arm_parent_B;   ///< Of the anchor, in the frames of the bodies [m].
    FloatLanes slack;                       ///< Below which it makes nothing taut (Slack).
    FloatLanes sign;                        ///< 1 if the child is body B of the joint, else -1.
    std::array<int, kLaneCount> numbers{};  ///< In the Model; -1: none.
    int parent = -1;                        ///< Number of the slot; -1: a tree that floats.
    bool parent_is_free = false;
    bool is_first = false;      ///< Of the joints of which this parent is the parent.
    bool has_children = false;  ///< Whether the child is a parent too.
  };
  struct alignas(64) Impulse {
    FloatVec3 on_B;
  };
  struct Tables {
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    std::vector<std::array<std::int32_t, kLaneCount>> slots;  ///< Bodies by number; -1: none.
    bool are_of_revolution = true;                            ///< All bodies.
    bool are_round = true;                                    ///< All have three equal moments.
  };

 private:
  Tables tables_;
  std::vector<Impulse> impulses_;
};

}  // namespace rigor
