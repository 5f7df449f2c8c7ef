// The stages of the work on a block of joints (docs/theory/bulk_joints.md, sections 1, 2 and 4). Included
// once for each target, inside its namespace.

void load_all(const std::vector<JointRecords>& records, JointBlock& block) {
  load_lanes(records, block);
}
void store_all(const std::vector<JointRecords>& records, const JointBlock& block) {
  store_lanes(records, block);
}

/// (Not inlined: of one function with the rows of all types the compiler takes several times as long.)
template <JointType type, bool has_laws>
[[gnu::noinline]] void run_kind(JointStage stage, float h, const JointSides& sides, JointLanes& joint) {
  if (stage == JointStage::aim) {
    aim_joint<type, has_laws>(sides, joint);
  } else if constexpr (held_row_count(type, has_laws) > 0) {
    miss_joint<type, has_laws>(sides, h, joint);
  }
}

template <JointType type>
RIGOR_FLOAT_LANES void run_type(JointStage stage, float h, bool has_laws, const JointSides& sides,
                                JointLanes& joint) {
  if constexpr (law_row_count(type, true) > 0) {
    if (has_laws) return run_kind<type, true>(stage, h, sides, joint);
  }
  run_kind<type, false>(stage, h, sides, joint);
}

/// One row of joint_table: whether the joint is of its type. Gears have no rows of their own here: their
/// effect is added to the rates (joint_gears.hpp).
template <std::size_t row>
RIGOR_FLOAT_LANES bool run_if_of(JointStage stage, float h, const JointLink& link, const JointSides& sides,
                                 JointLanes& joint) {
  if (at(link.type) != row) return false;
  if constexpr (joint_table[row].relation != JointRelation::gear) {
    run_type<joint_table[row].type>(stage, h, link.has_laws, sides, joint);
  }
  return true;
}

template <std::size_t... rows>
RIGOR_FLOAT_LANES void run_first_of(JointStage stage, float h, const JointLink& link, const JointSides& sides,
                                    JointLanes& joint, std::index_sequence<rows...>) {
  (void)(run_if_of<rows>(stage, h, link, sides, joint) || ...);
}

/// The stages that depend on the type of the joint.
RIGOR_FLOAT_LANES void run_by_type(JointStage stage, float h, const JointLink& link, const JointSides& sides,
                                   JointLanes& joint) {
  run_first_of(stage, h, link, sides, joint, std::make_index_sequence<joint_table.size()>());
}

/// The other stages, for a joint with so many rows.
inline void run_rows(JointStage stage, JointSize count, std::size_t i, JointBlock& block) {
  const JointLink& link = block.systems.links[i];
  JointLanes& joint = block.joints[i];
  JointSlot& child = block.slots[i];
  JointSlot& parent = block.slots[at(link.parent)];
  if (link.is_hinge()) {
    if (stage == JointStage::factor) factor_hinge(link, child, parent, joint, block.hinges[i]);
    if (stage == JointStage::solve) gather_hinge(link, child, parent, joint, block.hinges[i]);
    return;
  }
  if (stage == JointStage::factor) factor_joint(link, count, child, parent, joint);
  if (stage == JointStage::solve) gather_push(link, count.rows, child, parent, joint);
}

/// A ball joint without laws in a tree.
inline void run_ball(JointStage stage, float h, std::size_t i, JointBlock& block) {
  const JointLink& link = block.systems.links[i];
  JointLanes& joint = block.joints[i];
  BallLanes& ball = block.balls[i];
  const JointSlot& child = block.slots[i];
  JointSlot& parent = block.slots[at(link.parent)];
  switch (stage) {
    case JointStage::aim:
      return aim_ball(link, child, parent, joint, ball);
    case JointStage::factor:
      return factor_ball(link, child, parent, ball);
    case JointStage::position_error:
      return miss_ball(link, h, child, parent, joint, ball);
    case JointStage::drift:
      return drift_ball(child, parent, ball);
    case JointStage::solve:
      return gather_ball(link, child, parent, ball);
    case JointStage::rates:
      return;
  }
}

/// Any other joint.
inline void run_joint(JointStage stage, float h, std::size_t i, JointBlock& block) {
  const JointLink& link = block.systems.links[i];
  JointLanes& joint = block.joints[i];
  const JointSlot& child = block.slots[at(link.child)];
  const JointSlot& parent = block.slots[at(link.parent)];
  const JointSides sides = link.child_is_B ? JointSides{parent, child} : JointSides{child, parent};
  const JointSize count{row_count(link), held_row_count(link.type, link.has_laws)};

  // Rows, and residuals of what the joint holds.
  if (stage == JointStage::aim || stage == JointStage::position_error)
    run_by_type(stage, h, link, sides, joint);
  if (stage == JointStage::rates) measure_rates(sides, count, joint);
  if (stage == JointStage::drift) set_held_rates(sides, count, joint);

  // The rows of laws: residuals, and the impulses that are given.
  if (stage == JointStage::position_error || stage == JointStage::drift)
    set_law_residuals(sides, count, joint);
  for (int r = count.held; stage == JointStage::position_error && block.gives && r < count.rows; ++r)
    give(link, i, r, block);

  // Trees are solved joint by joint; systems with loops as a whole, by LoopSolver.
  if (!block.loops && (stage == JointStage::factor || stage == JointStage::solve)) {
    run_rows(stage, {acting_rows(link, joint), count.held}, i, block);
  }
}

/// The root of a tree that floats.
inline void run_root(JointStage stage, std::size_t i, JointBlock& block) {
  if (stage == JointStage::factor) factor_root(block.slots[i], block.joints[i]);
  if (stage == JointStage::solve) gather_root(block.slots[i], block.joints[i]);
}

/// On the way back, from the root to the leaves.
inline void spread(std::size_t i, JointBlock& block) {
  const JointLink& link = block.systems.links[i];
  JointLanes& joint = block.joints[i];
  JointSlot& child = block.slots[i];
  const JointSlot& parent = block.slots[at(link.parent)];
  if (!link.has_joint) {
    spread_root(joint, child);
  } else if (link.is_plain_ball()) {
    spread_ball(link, parent, child, joint, block.balls[i]);
  } else if (link.is_hinge()) {
    spread_hinge(link, parent, child, joint, block.hinges[i]);
  } else {
    spread_change(link, acting_rows(link, joint), parent, child, joint);
  }
}

/// One stage: of all bodies, then of all joints from the leaves to the roots; solving goes back to the
/// leaves.
void run_stage_in_lanes(JointStage stage, float h, JointBlock& block) {
  begin_stage(stage, h, block);
  const std::size_t count = block.systems.links.size();
  for (std::size_t i = 0; i < count; ++i) {
    const JointLink& link = block.systems.links[i];
    if (!link.has_joint) {
      run_root(stage, i, block);
    } else if (link.is_plain_ball() && !block.loops) {
      run_ball(stage, h, i, block);
    } else if (stage != JointStage::rates || link.has_laws) {
      run_joint(stage, h, i, block);
    }
  }
  if (stage == JointStage::position_error) block.gives = false;
  if (stage == JointStage::solve && !block.loops) {
    for (std::size_t i = count; i-- > 0;) {
      spread(i, block);
      add_change(block.slots[i]);
    }
  }
}
