// The substeps of contact-free chains of ball joints (docs/theory/bulk_joints.md, section 2). Included once
// for each target, after gyroscopic_kernels.inl and contact_free_trees.inl.

/// Anchors that a correction leaves farther apart than about this [m] get another one in the same substep.
constexpr float kLeastMiss = 4e-5F;

/// What of the trees joints hold taut (taut_links.hpp): nothing if there are no bodies.
struct TautTrees {
  std::vector<TautBody> bodies;
  std::vector<TautLink> links;
};

/// Before a substep: kApproachSpeed h more of what was left out is seen.
RIGOR_FLOAT_LANES void see_more(float h, FreeNode& node) {
  const FloatLanes length = root(fused_dot(node.left_out, node.left_out)),
                   most = splat(static_cast<float>(kApproachSpeed) * h);
  const FloatLanes part = length > most ? most / length : splat(1);
  const FloatVec3 more = part * node.left_out;
  node.apart = node.apart + more;
  node.left_out = node.left_out - more;
}

struct FreeStep {
  const FreeTables& tables;
  std::vector<FreeNode>& nodes;
  TautTrees& taut;
  float h;
  bool approaches;  ///< Whether anchors are farther apart than a substep puts back.

  const FloatSym3* stiffening(std::size_t i) const {
    return taut.bodies.empty() ? nullptr : &taut.bodies[i].stiffening;
  }

  RIGOR_FLOAT_LANES std::size_t moved() const { return tables.joints.size(); }
  RIGOR_FLOAT_LANES FreeNode* parent_of(std::size_t i) const {
    const int parent = tables.joints[i].parent;
    return parent < 0 ? nullptr : &nodes[at(parent)];
  }
};

/// Whether the last impulses may hold a body taut, in any lane.
RIGOR_FLOAT_LANES bool is_any_taut(const FreeStep& step) {
  IntLanes is_more = {};
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FloatVec3 f = splat(step.h) * step.nodes[i].impulse;
    is_more |= fused_dot(f, f) > step.tables.joints[i].slack;
  }
  return bits_of(is_more) != 0;
}

/// How far the last impulses ask for raised inertia.
template <bool of_revolution>
RIGOR_FLOAT_LANES void stiffen_all(const FreeStep& step, TautTrees& taut) {
  taut.bodies.resize(step.nodes.size(), TautBody{});
  for (std::size_t i = 0; i < step.moved(); ++i) {
    ContactFreeChains::Body inverse = step.tables.bodies[i];
    for (FloatLanes& moment : inverse.moments) moment = splat(1) / moment;
    taut.bodies[i].inverse_inertia = inertia_of<of_revolution>(inverse, step.nodes[i]);
  }
  taut.links.clear();
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeNode& node = step.nodes[i];
    const int parent = step.tables.joints[i].parent;
    if (parent < 0) continue;
    taut.links.push_back({static_cast<int>(i), parent, node.impulse, node.arm_child, node.arm_parent});
  }
  stiffen(step.h, taut.links, taut.bodies);
}

/// Finds by the last impulses what is taut.
template <bool of_revolution>
RIGOR_FLOAT_LANES void find_taut(bool may_be, const FreeStep& step) {
  step.taut.bodies.clear();
  if (may_be) stiffen_all<of_revolution>(step, step.taut);
}

/// Whether the last impulses hold bodies more than twice as stiffly as what their inertia is raised for,
/// which then is raised.
template <bool of_revolution>
RIGOR_FLOAT_LANES bool find_tauter(const FreeStep& step) {
  TautTrees tauter;
  stiffen_all<of_revolution>(step, tauter);
  step.taut.bodies.resize(step.nodes.size(), TautBody{});
  unsigned lanes = 0;
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FloatLanes* const I = step.tables.bodies[i].moments;
    lanes |= raise(I[0] + I[1] + I[2], tauter.bodies[i], step.taut.bodies[i]);
  }
  return lanes != 0;
}

/// Damps the rotations of what is taut.
RIGOR_FLOAT_LANES void calm_taut(const FreeStep& step) {
  if (step.taut.bodies.empty()) return;
  for (std::size_t s = 0; s < step.nodes.size(); ++s) step.taut.bodies[s].w = step.nodes[s].w;
  calm(step.taut.links, step.taut.bodies);
  for (std::size_t i = 0; i < step.moved(); ++i) step.nodes[i].w = step.taut.bodies[i].w;
}

/// Factors of all articulated inertias, from the leaves to the root.
template <bool of_revolution>
RIGOR_FLOAT_LANES void factor_all(const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeJoint& joint = step.tables.joints[i];
    FreeNode& node = step.nodes[i];
    factor_free<of_revolution>(step.tables.bodies[i], joint, step.stiffening(i), node);
    if (joint.parent_is_free) add_to_parent(joint, node, *step.parent_of(i));
  }
}

/// What the gyroscopic torque changes in a part of a substep at the angular velocity w.
template <bool of_revolution>
RIGOR_FLOAT_LANES FloatVec3 gyroscopic_change(float part, const FloatVec3& w, const FreeStep& step,
                                              std::size_t i) {
  const FreeNode& node = step.nodes[i];
  const ContactFreeChains::Body& body = step.tables.bodies[i];
  return of_revolution ? change_about_axis(node.axes[0], body.spin, w, part * step.h)
                       : change_by_newton(node.axes, body.ratios, w, part * step.h);
}

/// Step 1 of a substep: the changes of the velocities by forces and by the gyroscopic torque.
template <bool of_revolution>
RIGOR_FLOAT_LANES void push_all(const FreeStep& step) {
  const FloatLanes zero = splat(0);
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode& node = step.nodes[i];
    // The torque is that in the middle of the kick: what else changes ω in it is as in the substep before.
    const FloatVec3 middle = fused(splat(0.5F), node.others, node.w);
    node.turned_w = node.w + gyroscopic_change<of_revolution>(1, middle, step, i);
    node.v = node.v + node.dv;
    node.w = node.turned_w + node.dw;
    node.free_v = node.v;
    node.free_w = node.w;
    node.rotation = rotation_over(step.h, node.w);
    node.impulse = {zero, zero, zero};
  }
}

/// Back to before step 2.
RIGOR_FLOAT_LANES void release_all(const FreeStep& step) {
  const FloatLanes zero = splat(0);
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode& node = step.nodes[i];
    node.v = node.free_v;
    node.w = node.free_w;
    node.rotation = rotation_over(step.h, node.w);
    node.impulse = {zero, zero, zero};
  }
}

/// Step 2 of a substep: anchors meet after the time h. One correction in the lanes where `part` is 1; returns
/// 1 in the lanes that need another.
RIGOR_FLOAT_LANES FloatLanes hold_all(const FreeStep& step, const FloatLanes& part) {
  // Leaves first: what is wanted of each joint, and the pushes.
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode* const parent = step.parent_of(i);
    if (parent != nullptr) miss_free(step.h, part, *parent, step.nodes[i]);
    gather_free(step.tables.joints[i], step.nodes[i], parent);
  }

  // Root first: the changes. What is left of the error is of the order of the arms' rotation in the substep
  // times that by the correction: h² |ω| |Δω| |r|.
  FloatLanes left = splat(0);
  for (std::size_t i = step.moved(); i-- > 0;) {
    FreeNode& node = step.nodes[i];
    spread_free(step.tables.joints[i], step.parent_of(i), node);
    node.rotation = rotation_over(step.h, node.w);
    const FloatLanes squared = fused_dot(node.change_w, node.change_w) * fused_dot(node.w, node.w);
    left = larger(left, squared * step.tables.bodies[i].reach);
  }
  const float most = kLeastMiss / (step.h * step.h);
  return left > splat(most * most) ? splat(1) : splat(0);
}

/// Step 2: a second correction where the first one leaves much.
RIGOR_FLOAT_LANES void hold_places(const FreeStep& step) {
  const FloatLanes again = hold_all(step, splat(1));
  if (lane_bits(again > splat(0)) != 0) hold_all(step, again);
}

/// Step 3 for one body: where it is after the time h.
template <bool of_revolution>
RIGOR_FLOAT_LANES void displace(float h, const FreeNode* parent, FreeNode& node) {
  // The anchors and the arms that lead to them.
  const FloatVec3 arm_change_child = displacement_of(node.rotation, node.arm_child);
  if (parent != nullptr) {
    const FloatVec3 arm_change_parent = displacement_of(parent->rotation, node.arm_parent);
    node.apart = fused(splat(h), node.v - parent->v, node.apart + (arm_change_child - arm_change_parent));
    node.arm_child = node.arm_child + arm_change_child;
    node.arm_parent = node.arm_parent + arm_change_parent;
  }

  // Displacements since the beginning of the step, and the principal axes.
  node.dp = fused(splat(h), node.v, node.dp);
  turn_further(h, node.w, node.dr);
  node.axes[0] = node.axes[0] + displacement_of(node.rotation, node.axes[0]);
  if constexpr (!of_revolution) node.axes[1] = node.axes[1] + displacement_of(node.rotation, node.axes[1]);
}

/// Step 3 of a substep: displacements, and the factors where the bodies are then.
template <bool of_revolution>
RIGOR_FLOAT_LANES void displace_all(const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeJoint& joint = step.tables.joints[i];
    FreeNode& node = step.nodes[i];
    FreeNode* const parent = step.parent_of(i);
    displace<of_revolution>(step.h, parent, node);
    factor_free<of_revolution>(step.tables.bodies[i], joint, step.stiffening(i), node);
    if (joint.parent_is_free) add_to_parent(joint, node, *parent);
  }
}

/// Step 4 of a substep: the anchors of each joint get the same velocity.
RIGOR_FLOAT_LANES void slow_all(const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeJoint& joint = step.tables.joints[i];
    FreeNode& node = step.nodes[i];
    FreeNode* const parent = step.parent_of(i);
    if (parent != nullptr) {
      const FloatVec3 on_parent = fused_cross(parent->w, node.arm_parent, parent->v);
      node.wanted = on_parent - fused_cross(node.w, node.arm_child, node.v);
    }
    gather_free(joint, node, parent);
  }
  for (std::size_t i = step.moved(); i-- > 0;) {
    spread_free(step.tables.joints[i], step.parent_of(i), step.nodes[i]);
  }
}

/// Half a substep before the first one (part -1/2) or after the last one (1/2): forces, gyroscopic torques,
/// and the anchors of each joint get the same velocity. The torques are those of the middle, for which all is
/// done twice where there are any.
template <bool of_revolution>
RIGOR_FLOAT_LANES void take_half(float part, bool slows, const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode& node = step.nodes[i];
    node.free_v = node.v;
    node.free_w = node.turned_w = node.w;
    node.first_impulse = node.impulse;
  }
  const FloatLanes half = splat(0.5F), lane_part = splat(part);
  for (int round = step.tables.are_round ? 1 : 0; round < 2; ++round) {
    for (std::size_t i = 0; i < step.moved(); ++i) {
      FreeNode& node = step.nodes[i];
      // In the middle half of what the last round has changed is changed.
      const FloatVec3 middle = fused(half, node.w - node.turned_w, node.free_w);
      node.turned_w = node.free_w + gyroscopic_change<of_revolution>(part, middle, step, i);
      node.v = fused(lane_part, node.dv, node.free_v);
      node.w = fused(lane_part, node.dw, node.turned_w);
      node.impulse = node.first_impulse;
    }
    if (slows) slow_all(step);
  }
}

/// What a substep has changed of ω but for the gyroscopic torque. The first one began with rates that joints
/// allow, so that they gave only half of what turns velocities with the rows: the other half is as large.
RIGOR_FLOAT_LANES void note_others(bool is_first, const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode& node = step.nodes[i];
    const FloatVec3 now = node.w - node.turned_w;
    node.others = is_first ? now + (now - node.others) : now;
  }
}

/// All substeps of a step: sections 1 and 2.
template <bool of_revolution>
RIGOR_FLOAT_LANES void take_substeps(int count, const FreeStep& step) {
  // Factors where the bodies begin; bodies that joints do not move keep their rotation of a substep.
  find_taut<of_revolution>(is_any_taut(step), step);
  factor_all<of_revolution>(step);
  for (std::size_t s = step.moved(); s < step.nodes.size(); ++s) {
    step.nodes[s].rotation = rotation_over(step.h, step.nodes[s].w);
  }
  // Velocities within a step are those of half a substep before; the first impulse of several is one of a
  // whole substep then.
  take_half<of_revolution>(-0.5F, count > 1, step);
  // A whole substep changes twice as much, and forwards.
  for (FreeNode& node : step.nodes) node.others = splat(-2) * (node.w - node.turned_w);
  for (int k = 0; k < count; ++k) {
    push_all<of_revolution>(step);
    hold_places(step);
    // A jerk pulls far more than the substep before did.
    bool may_be_taut = is_any_taut(step);
    if (may_be_taut && find_tauter<of_revolution>(step)) {
      release_all(step);
      factor_all<of_revolution>(step);
      hold_places(step);
      may_be_taut = is_any_taut(step);
    }
    find_taut<of_revolution>(may_be_taut, step);
    displace_all<of_revolution>(step);
    calm_taut(step);
    note_others(k == 0, step);
    if (!step.approaches) continue;
    for (FreeNode& node : step.nodes) see_more(step.h, node);
  }
  // Rates do not change where bodies go, so they wait until here. The impulse of a substep is half of the
  // last one and what half a kick gives; that of a single substep, in which rates are as before, is their
  // sum.
  if (count > 1) {
    for (std::size_t i = 0; i < step.moved(); ++i)
      step.nodes[i].impulse = splat(0.5F) * step.nodes[i].impulse;
  }
  take_half<of_revolution>(0.5F, true, step);
}
