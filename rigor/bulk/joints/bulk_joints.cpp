#include "rigor/bulk/joints/bulk_joints.hpp"

#include "rigor/bulk/joints/contact_free_chains.hpp"
#include "rigor/bulk/joints/joint_block.hpp"
#include "rigor/bulk/joints/joint_errors.hpp"
#include "rigor/bulk/joints/joint_tension.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

struct BulkJoints::Blocks {
  const Model* model = nullptr;
  LaneTarget target = LaneTarget::portable;
  float h = 0;
  std::vector<BulkJointBlock> blocks;
  std::vector<std::unique_ptr<ContactFreeChains>>
      contact_free_chains;               ///< Of each block that can be of contact-free chains.
  bool has_contact_free_chains = false;  ///< In this step.
  std::vector<char> is_free;             ///< Each body, in this step.
  std::vector<char> is_displaced;        ///< Each body, by solve_and_displace(), in this step.
  std::vector<int> other_joints;         ///< That no contact-free chains have, but for gears; ascending.
  std::vector<int> moved;                ///< A dynamic body of each joint.
  bool are_limits_new = false;           ///< Since the last step.
  std::vector<float> impulses;           ///< With which the step begins.
  bool has_driven = false;               ///< Whether something that moves as it must holds a system.

  JointEffort effort() const { return {*model, h, target}; }

  template <class Work>
  void for_each(const Executor& executor, const Work& work) {
    executor.for_ranges(static_cast<int>(blocks.size()), 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) work(blocks[at(i)]);
    });
  }
};

BulkJoints::BulkJoints(const Model& model, LaneTarget target) : blocks_(std::make_unique<Blocks>()) {
  // A dynamic body of each joint, if it has one: whether it sleeps tells whether the joint does.
  blocks_->model = &model;
  blocks_->target = target;
  for (int joint = 0; joint < static_cast<int>(model.joints().size()); ++joint) {
    const std::vector<int> bodies = model.bodies_of_joint(joint);
    const auto is_dynamic = [&](int body) { return model.body(body).motion == MotionType::dynamic; };
    const auto found = std::find_if(bodies.begin(), bodies.end(), is_dynamic);
    blocks_->moved.push_back(found == bodies.end() ? bodies.front() : *found);
  }

  // Blocks of eight alike systems, and the contact-free chains of those that can be.
  JointForest forest = make_joint_forest(model);
  std::vector<bool> is_other(model.joints().size(), true);
  for (JointSystems& systems : forest.systems) {
    const bool may_be_free = ContactFreeChains::is_possible(systems);
    for (const JointLink& link : systems.links) {
      for (const int joint : link.joints) {
        if (may_be_free && joint >= 0) is_other[at(joint)] = false;
      }
    }
    blocks_->contact_free_chains.push_back(may_be_free ? std::make_unique<ContactFreeChains>(model, systems)
                                                       : nullptr);
    blocks_->blocks.push_back(make_joint_block(model, std::move(systems)));
  }

  // The joints whose errors no contact-free chains measure.
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    if (!is_other[at(i)] || model.joint(i).type == JointType::gear) continue;
    blocks_->other_joints.push_back(i);
  }
}

BulkJoints::~BulkJoints() = default;

bool BulkJoints::may_have_contact_free_chains() const {
  return std::any_of(blocks_->contact_free_chains.begin(), blocks_->contact_free_chains.end(),
                     [](const std::unique_ptr<ContactFreeChains>& trees) { return trees != nullptr; });
}

void BulkJoints::find_contact_free_chains(const BulkBodies& bodies, const std::vector<char>& touches) {
  blocks_->is_free.assign(touches.size(), 0);
  blocks_->has_contact_free_chains = false;
  for (std::size_t i = 0; i < blocks_->blocks.size(); ++i) {
    if (blocks_->contact_free_chains[i] == nullptr) continue;
    BulkJointBlock& block = blocks_->blocks[i];
    const JointSystems& systems = block.lanes.systems;
    block.free_lanes = 0;
    // A lane is free if none of its bodies touches anything, is prescribed or sleeps.
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      bool is_free = true;
      for (std::size_t s = 0; s < systems.moved && is_free; ++s) {
        const int body = systems.bodies[s][lane];
        is_free = body >= 0 && bodies.is_dynamic(body) && touches[at(body)] == 0;
      }
      if (!is_free) continue;
      block.free_lanes |= 1u << lane;
      for (std::size_t s = 0; s < systems.moved; ++s) {
        blocks_->is_free[at(systems.bodies[s][lane])] = 1;
      }
    }
    blocks_->has_contact_free_chains |= block.free_lanes != 0;
  }
}

bool BulkJoints::is_free(int body) const {
  return blocks_->has_contact_free_chains && blocks_->is_free[at(body)] != 0;
}

void BulkJoints::advance_contact_free_chains(const std::vector<MotionRow>& accelerations, int substeps,
                                             BulkBodies& bodies, const Executor& executor) {
  if (!blocks_->has_contact_free_chains) return;
  const ContactFreeChains::Step step{blocks_->h, substeps, accelerations, blocks_->impulses, blocks_->target};
  executor.for_ranges(static_cast<int>(blocks_->blocks.size()), 1, [&](int begin, int end) {
    for (std::size_t i = at(begin); i < at(end); ++i) {
      const unsigned lanes = blocks_->blocks[i].free_lanes;
      if (lanes != 0) blocks_->contact_free_chains[i]->advance(step, lanes, bodies);
    }
  });
}

void BulkJoints::take_limits() {
  blocks_->are_limits_new = true;
}

void BulkJoints::prepare(BulkBodies& bodies, double h, const Executor& executor,
                         const std::vector<float>& impulses) {
  // Of joints that came or went it is not known.
  const bool are_known = impulses.size() == at(kMostJointRows) * blocks_->model->joints().size();
  blocks_->impulses = are_known ? impulses : std::vector<float>();
  blocks_->h = static_cast<float>(h);
  if (blocks_->are_limits_new) {
    for (BulkJointBlock& block : blocks_->blocks) read_limits(*blocks_->model, block);
    blocks_->are_limits_new = false;
  }
  blocks_->for_each(executor, [&](BulkJointBlock& block) {
    prepare_joint_block(blocks_->effort(), blocks_->impulses, bodies, block);
  });
  // Who is displaced with the joints.
  blocks_->has_driven = false;
  blocks_->is_displaced.assign(blocks_->blocks.empty() ? 0 : bodies.x.size(), 0);
  for (const BulkJointBlock& block : blocks_->blocks) {
    blocks_->has_driven = blocks_->has_driven || block.is_driven;
    if (!block.is_moving || block.is_driven) continue;
    for_moved_bodies(bodies, block, [&](int body) { blocks_->is_displaced[at(body)] = 1; });
  }
}

void BulkJoints::find_flying(const BulkBodies& bodies, std::vector<char>& flies) {
  for (BulkJointBlock& block : blocks_->blocks) find_flying_lanes(bodies, flies, block);
}

void BulkJoints::solve_rates_of_flying(bool are_displaced, const Executor& executor) {
  blocks_->for_each(executor, [&](BulkJointBlock& block) {
    if (!block.flying_records.empty()) solve_flying_rates(blocks_->effort(), are_displaced, block);
  });
}

void BulkJoints::solve(JointPass pass, const Executor& executor) {
  blocks_->for_each(executor, [&](BulkJointBlock& block) {
    if (!block.is_moving) return;
    if (pass == JointPass::rates) {
      solve_after_displacements(blocks_->effort(), false, block);
    } else {
      solve_before_displacements(blocks_->effort(), pass == JointPass::places_anew, block);
    }
  });
}

void BulkJoints::solve_and_displace(BulkBodies& bodies, const Executor& executor) {
  blocks_->for_each(executor, [&](BulkJointBlock& block) {
    if (!block.is_moving) return;
    solve_before_displacements(blocks_->effort(), true, block);
    if (block.is_driven) return;
    displace_bodies(blocks_->h, bodies, block);
    solve_after_displacements(blocks_->effort(), true, block);
  });
}

bool BulkJoints::displaces(int body) const {
  return !blocks_->is_displaced.empty() && blocks_->is_displaced[at(body)] != 0;
}

void BulkJoints::solve_rates_of_driven(const Executor& executor) {
  if (!blocks_->has_driven) return;
  blocks_->for_each(executor, [&](BulkJointBlock& block) {
    if (block.is_moving && block.is_driven) solve_after_displacements(blocks_->effort(), true, block);
  });
}

void BulkJoints::keep_impulses() {
  for (BulkJointBlock& block : blocks_->blocks) rigor::keep_impulses(block);
}

void BulkJoints::take_back_impulses(const std::function<bool(int)>& is_wanted) {
  for (BulkJointBlock& block : blocks_->blocks) {
    for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
      const auto& before = block.kept[i];
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int joint = block.lanes.systems.links[i].joints[at(lane)];
        if (joint < 0 || !is_wanted(joint)) continue;
        for (int r = 0; r < kMostJointRows; ++r) block.lanes.joints[i].impulse[r][lane] = before[at(r)][lane];
      }
    }
  }
}

void BulkJoints::hold_tauter() {
  for (BulkJointBlock& block : blocks_->blocks) {
    if (block.is_moving) find_tauter(blocks_->h, block.lanes);
  }
}

void BulkJoints::raise_inertia(BulkBodies& bodies) const {
  for (const BulkJointBlock& block : blocks_->blocks) {
    if (!block.is_moving || !block.lanes.is_taut) continue;
    for (std::size_t s = 0; s < block.lanes.systems.moved; ++s) {
      FloatSym3 W;
      invert_raised(block.lanes, s, W);
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int body = block.lanes.systems.bodies[s][at(lane)];
        if (body < 0 || !(block.lanes.taut_bodies[s].share[lane] > 0) || !bodies.is_dynamic(body)) continue;
        InverseInertia& to = bodies.inertia[at(body)];
        to.xx = W.xx[lane], to.yy = W.yy[lane], to.zz = W.zz[lane];
        to.xy = W.xy[lane], to.xz = W.xz[lane], to.yz = W.yz[lane];
      }
    }
  }
}

bool BulkJoints::has_loops() const {
  return std::any_of(blocks_->blocks.begin(), blocks_->blocks.end(),
                     [](const BulkJointBlock& block) { return block.lanes.loops != nullptr; });
}

double BulkJoints::fastest_vibration() const {
  double square = 0;
  for (const BulkJointBlock& block : blocks_->blocks) {
    if (block.lanes.loops && block.is_moving)
      square = std::max(square, square_of_vibration(blocks_->h, block.lanes));
  }
  return std::sqrt(square);
}

void BulkJoints::read_impulses(const BulkBodies& bodies, std::vector<float>& impulses) const {
  impulses.resize(6 * blocks_->model->joints().size(), 0);
  for (std::size_t b = 0; b < blocks_->blocks.size(); ++b) {
    const BulkJointBlock& block = blocks_->blocks[b];
    for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
      const JointLink& link = block.lanes.systems.links[i];
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int joint = link.joints[at(lane)];
        if (joint < 0 || !bodies.is_dynamic(blocks_->moved[at(joint)])) continue;
        // Contact-free chains keep their impulses themselves.
        if ((block.free_lanes >> lane & 1) != 0) {
          const FloatVec3& impulse = blocks_->contact_free_chains[b]->impulse(i);
          float* const to = &impulses[at(6 * joint)];
          to[0] = impulse.x[lane];
          to[1] = impulse.y[lane];
          to[2] = impulse.z[lane];
          continue;
        }
        // Rows that there are no more, of a motor that was taken away, have none.
        for (int r = 0; r < kMostJointRows; ++r) {
          impulses[at(kMostJointRows * joint + r)] =
              r < row_count(link) ? block.lanes.joints[i].impulse[r][lane] : 0;
        }
      }
    }
  }
}

std::pair<double, int> BulkJoints::worst_error(const BulkBodies& bodies) const {
  // Ball joints without laws in trees.
  std::pair<double, int> worst{0, -1};
  const Model& model = *blocks_->model;
  for (const std::unique_ptr<ContactFreeChains>& trees : blocks_->contact_free_chains) {
    if (trees == nullptr) continue;
    const std::pair<double, int> found = trees->worst_gap(blocks_->target, bodies);
    if (found.first > worst.first) worst = found;
  }

  // All others but gears.
  for (const int i : blocks_->other_joints) {
    const Joint& joint = model.joint(i);
    const BodyPlace A = place_of(bodies, joint.body_A), B = place_of(bodies, joint.body_B);
    double error = 0;
    if (joint.type == JointType::ball) {
      error = ((B.x - A.x) + B.q * joint.X_BK.p - A.q * joint.X_AF.p).norm();
    } else {
      const double lever = std::max({joint.X_AF.p.norm(), joint.X_BK.p.norm(), model.length_scale()});
      error = joint_error(joint, {rotation_matrix(A.q), A.x}, {rotation_matrix(B.q), B.x}, lever);
    }
    if (error > worst.first) worst = {error, i};
  }
  return worst;
}

}  // namespace rigor
