#include "rigor/bulk/joints/joint_block.hpp"

#include "rigor/bulk/joints/joint_ball_trees.hpp"
#include "rigor/bulk/joints/joint_tension.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

using Block = BulkJointBlock;

LaneArray read_lanes(const FloatLanes& lanes) {
  LaneArray values;
  store_floats(lanes, values.data());
  return values;
}

/// Times that a solve is repeated, since arms rotate within the substep.
constexpr int kCorrections = 2;
/// Times that pieces of laws are chosen within a solve.
constexpr int kPieceChanges = 6;

/// Of the beginning of a solve: restore() takes them.
void keep_velocities(Block& block) {
  for (std::size_t i = 0; i < block.before.size(); ++i) {
    block.before[i] = {block.lanes.slots[i].v, block.lanes.slots[i].w};
  }
}

/// Rates from which the laws of a substep begin. The first guess of what acts is what acted at the end of the
/// last solve; where nothing did, what the rates before this one say.
void begin_laws(Block& block) {
  for (Block::Law& law : block.laws) {
    JointLanes& joint = block.lanes.joints[at(law.link)];
    law.rate = read_lanes(joint.rate[law.row]);
    for (int lane = 0; lane < kLaneCount; ++lane) {
      if (law.last_impulse[at(lane)] == 0) continue;
      joint.rate[law.row][lane] = law.last_rate[at(lane)];
      joint.impulse[law.row][lane] = law.last_impulse[at(lane)];
    }
  }
}

/// Notes what has acted.
void end_laws(Block& block) {
  for (Block::Law& law : block.laws) {
    const JointLanes& joint = block.lanes.joints[at(law.link)];
    law.last_rate = read_lanes(joint.rate[law.row]);
    law.last_impulse = read_lanes(joint.impulse[law.row]);
  }
}

/// Whether a limit alone acts on the coordinate, and will not be reached: there is no impulse.
bool is_between(const Block::Law& law, const JointLanes& joint, int lane, double h) {
  // Where the coordinate would be at the end of the substep. (Comparisons with NaN are false.)
  const double rate =
      static_cast<double>(joint.rate[law.row][lane]) -
      static_cast<double>(joint.mobility[law.row][lane]) * static_cast<double>(joint.impulse[law.row][lane]);
  const double next = static_cast<double>(joint.coordinate[law.row][lane]) + h * rate;
  return law.lower[at(lane)] < next && next < law.upper[at(lane)];
}

/// The piece of a law in which the coordinate is, after a solve with pieces no farther than one from those;
/// nothing of empty lanes.
LawPiece find_piece(const Model& model, const Block& block, const Block::Law& law, int lane, bool is_solved,
                    double h) {
  const JointLink& link = block.lanes.systems.links[at(law.link)];
  const JointLanes& lanes = block.lanes.joints[at(law.link)];
  const int index = link.joints[at(lane)];
  // Empty lanes and coordinates without a law.
  if (index < 0 || is_between(law, lanes, lane, h)) return {};
  if (std::max(law.axis, 0) >= static_cast<int>(model.joint(index).axes.size())) return {};

  // The damper of a ball joint across its axis: a soft row.
  const Joint& joint = model.joint(index);
  if (law.axis < 0) {
    const double damping = joint.axes[0].damping;
    return damping > 0 ? LawPiece{true, 0, 1 / (h * damping), 0, 0} : LawPiece{};
  }

  // Where the line of the coordinate's own mobility through the present rate and impulse meets the law. In a
  // tree the coordinate gives way less than its two bodies alone, so that the line leads too far.
  const CoordinateMotion motion{lanes.coordinate[law.row][lane], lanes.rate[law.row][lane],
                                lanes.mobility[law.row][lane], lanes.impulse[law.row][lane]};
  const int from = is_solved ? law.pieces[at(lane)].place : -1;
  return CoordinateLaw(joint, law.axis, motion, h).piece_towards(motion.rate, motion.impulse, from);
}

bool is_same(const LawPiece& a, const LawPiece& b) {
  return a.is_held == b.is_held && a.target == b.target && a.softness == b.softness && a.impulse == b.impulse;
}

/// Whether no lane has an impulse: between two limits there is none, and most coordinates are there.
bool is_free(const Block& block, const Block::Law& law, double h) {
  const JointLanes& lanes = block.lanes.joints[at(law.link)];
  bool is_free = true;
  for (int lane = 0; lane < kLaneCount; ++lane) is_free = is_free && is_between(law, lanes, lane, h);
  return is_free;
}

/// Writes the pieces of a law into its row: held on jumps, soft on rising pieces, a given impulse on level
/// ones.
void write_pieces(const Block::Law& law, JointLanes& joint) {
  for (int lane = 0; lane < kLaneCount; ++lane) {
    const LawPiece& piece = law.pieces[at(lane)];
    joint.on[law.row][lane] = piece.is_held ? 1 : 0;
    joint.softness[law.row][lane] = piece.is_held ? static_cast<float>(piece.softness) : 1;
    joint.target[law.row][lane] = static_cast<float>(piece.target);
    joint.given[law.row][lane] = piece.is_held ? 0 : static_cast<float>(piece.impulse);
  }
}

/// Which joints have a row of a law that is on.
void find_laws_on(Block& block) {
  for (const Block::Law& law : block.laws) block.lanes.joints[at(law.link)].has_law_on = false;
  for (const Block::Law& law : block.laws) {
    if (law.is_off) continue;
    JointLanes& joint = block.lanes.joints[at(law.link)];
    for (int lane = 0; lane < kLaneCount; ++lane) joint.has_law_on |= joint.on[law.row][lane] != 0;
  }
}

/// Makes the factors, unless they are those of the same rows and laws.
void factor(bool are_rows_new, const JointEffort& effort, Block& block) {
  bool is_same = !are_rows_new;
  for (Block::Law& law : block.laws) {
    const JointLanes& joint = block.lanes.joints[at(law.link)];
    const LaneArray on = read_lanes(joint.on[law.row]), softness = read_lanes(joint.softness[law.row]);
    is_same = is_same && on == law.factored_on && softness == law.factored_softness;
    law.factored_on = on;
    law.factored_softness = softness;
  }
  if (!is_same) run_stage(JointStage::factor, effort.h, effort.target, block.lanes);
}

/// Writes the pieces of all laws into the rows; whether one has changed. `is_solved`: since the last choice.
bool choose_pieces(const Model& model, double h, bool is_solved, Block& block) {
  bool has_changed = false;
  for (Block::Law& law : block.laws) {
    const bool is_off = is_free(block, law, h);
    if (is_off && law.is_off) continue;
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const LawPiece piece = is_off ? LawPiece{} : find_piece(model, block, law, lane, is_solved, h);
      LawPiece& old = law.pieces[at(lane)];
      has_changed = has_changed || !is_same(piece, old);
      old = piece;
    }
    law.is_off = is_off;
    write_pieces(law, block.lanes.joints[at(law.link)]);
  }
  find_laws_on(block);
  return has_changed;
}

/// After the displacements only limits act at which a coordinate has been stopped: it leaves as the impact
/// lets it.
void choose_rebounds(const Model& model, Block& block) {
  for (Block::Law& law : block.laws) {
    if (law.is_off) continue;
    JointLanes& joint = block.lanes.joints[at(law.link)];
    const JointLink& link = block.lanes.systems.links[at(law.link)];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const std::size_t k = at(lane);
      const LawPiece& piece = law.pieces[k];
      const bool stands = piece.is_held && piece.limit != 0;
      joint.on[law.row][lane] = stands ? 1 : 0;
      joint.softness[law.row][lane] = stands ? 0 : 1;
      joint.given[law.row][lane] = 0;
      joint.target[law.row][lane] = 0;
      if (!stands) continue;

      // -e times the rate with which the coordinate has come to the limit.
      const double e = model.joint(link.joints[k]).axes[at(law.axis)].restitution;
      const double approach = std::max(0.0, piece.limit * static_cast<double>(law.rate[k]));
      joint.target[law.row][lane] = static_cast<float>(-piece.limit * e * approach);
    }
  }
  find_laws_on(block);
}

/// Back to the beginning of a solve, where the laws' given impulses are all there is.
void restore(Block& block) {
  for (std::size_t i = 0; i < block.before.size(); ++i) {
    JointSlot& slot = block.lanes.slots[i];
    slot.v = block.before[i].v;
    slot.w = block.before[i].w;
    slot.made_v = slot.made_w = FloatVec3{};
  }
  for (JointLanes& joint : block.lanes.joints) {
    for (int r = 0; r < kMostJointRows; ++r) joint.impulse[r] = joint.given[r];
  }
}

/// Takes back what joints have changed; nothing is changed yet.
void begin_substep(bool anew, Block& block) {
  for (std::size_t i = 0; i < block.lanes.systems.moved; ++i) {
    JointSlot& slot = block.lanes.slots[i];
    if (anew) {
      slot.v = slot.v - slot.made_v;
      slot.w = slot.w - slot.made_w;
    }
    slot.made_v = slot.made_w = FloatVec3{};
  }
  for (JointLanes& joint : block.lanes.joints) {
    for (FloatLanes& impulse : joint.impulse) impulse = float_lanes(0);
  }
}

/// Lanes in which `part` is 0 stay as they are.
void leave_out(const FloatLanes& part, JointBlock& block) {
  for (JointLanes& joint : block.joints) {
    for (FloatLanes& residual : joint.residual) residual *= part;
  }
  for (BallLanes& ball : block.balls) ball.wanted = part * ball.wanted;
}

/// Corrections of the places; of loops after a solve of the rates, of trees no more than their rotation needs
/// (docs/theory/bulk_joints.md, sections 1 and 3).
void correct(float h, LaneTarget target, Block& block) {
  if (block.lanes.loops) {
    run_stage(JointStage::drift, h, target, block.lanes);
    run_stage(JointStage::solve, h, target, block.lanes);
  }
  for (int k = 0; k < kCorrections; ++k) {
    const bool is_short = k > 0 && !block.lanes.loops;
    const FloatLanes part = is_short ? lanes_off(h, block.lanes) : float_lanes(1);
    if (is_zero(part)) break;
    run_stage(JointStage::position_error, h, target, block.lanes);
    if (is_short) leave_out(part, block.lanes);
    run_stage(JointStage::solve, h, target, block.lanes);
  }
}

/// Solves with the pieces of the laws until none of them changes (section 4).
void solve_laws(const JointEffort& effort, Block& block) {
  const auto& [model, h, target] = effort;
  // The first pieces follow from the rates before the solve.
  run_stage(JointStage::rates, h, target, block.lanes);
  begin_laws(block);
  choose_pieces(model, h, false, block);

  for (int k = 0; k < kPieceChanges; ++k) {
    // Each solve begins where the first one did. Where limits act as after the last displacements, the
    // factors are still the same.
    restore(block);
    factor(false, effort, block);
    block.lanes.gives = true;
    correct(h, target, block);

    // The pieces at the rates that it has found.
    run_stage(JointStage::rates, h, target, block.lanes);
    if (k + 1 < kPieceChanges && !choose_pieces(model, h, true, block)) break;
  }
  end_laws(block);
}

void solve_places(const JointEffort& effort, Block& block) {
  if (block.lanes.has_laws) {
    solve_laws(effort, block);
  } else if (block.lanes.is_of_balls) {
    hold_balls(effort.h, effort.target, block.lanes);
  } else {
    correct(effort.h, effort.target, block);
  }
}

/// With the inertia that the bodies have now, in the lanes of `lanes`; the others keep what they have.
void solve_places_again(const JointEffort& effort, unsigned lanes, Block& block) {
  const std::vector<JointSlot> slots = block.lanes.slots;
  const std::vector<JointLanes> joints = block.lanes.joints;
  begin_substep(true, block);
  run_stage(JointStage::aim, effort.h, effort.target, block.lanes);
  factor(true, effort, block);
  solve_places(effort, block);
  block.lanes.may_be_taut = may_be_taut(effort.h, block.lanes);
  for (int lane = 0; lane < kLaneCount; ++lane) {
    if ((lanes >> lane & 1) != 0) continue;
    const auto keep = [lane](const FloatVec3& from, FloatVec3& to) {
      to.x[lane] = from.x[lane], to.y[lane] = from.y[lane], to.z[lane] = from.z[lane];
    };
    for (std::size_t s = 0; s < slots.size(); ++s) {
      keep(slots[s].v, block.lanes.slots[s].v), keep(slots[s].w, block.lanes.slots[s].w);
      keep(slots[s].made_v, block.lanes.slots[s].made_v), keep(slots[s].made_w, block.lanes.slots[s].made_w);
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      for (int r = 0; r < kMostJointRows; ++r)
        block.lanes.joints[i].impulse[r][lane] = joints[i].impulse[r][lane];
    }
  }
}

}  // namespace

// Step 2 of a substep.
void solve_before_displacements(const JointEffort& effort, bool anew, BulkJointBlock& block) {
  const auto& [model, h, target] = effort;
  load_slots(block.records, target, block.lanes);
  begin_substep(anew, block);
  if (block.lanes.has_laws) keep_velocities(block);
  solve_places(effort, block);
  // Where a jerk pulls far more than the substep before did, inertia is raised for that, and all is solved
  // again.
  if (const unsigned tauter = find_tauter(h, block.lanes); tauter != 0)
    solve_places_again(effort, tauter, block);
  store_slots(block.records, target, block.lanes);
}

// Step 4 of a substep, with the rows where the bodies are now; its factors serve step 2 of the next.
void solve_after_displacements(const JointEffort& effort, bool ends_substep, BulkJointBlock& block) {
  const auto& [model, h, target] = effort;
  load_slots(block.records, target, block.lanes);
  // What step 2 has held tells what is taut.
  if (ends_substep) {
    find_taut(h, block.lanes);
    calm_taut(block.lanes);
  }
  if (block.lanes.is_of_balls) {
    slow_balls(target, block.lanes);
  } else {
    run_stage(JointStage::aim, h, target, block.lanes);
    choose_rebounds(model, block);
    factor(true, effort, block);
    run_stage(JointStage::drift, h, target, block.lanes);
    run_stage(JointStage::solve, h, target, block.lanes);
  }
  store_slots(block.records, target, block.lanes);
  approach(static_cast<double>(h), block.approaches, block.lanes);
}

void keep_impulses(BulkJointBlock& block) {
  block.kept.clear();
  for (const JointLanes& joint : block.lanes.joints)
    std::copy_n(joint.impulse, kMostJointRows, block.kept.emplace_back().begin());
}

void solve_flying_rates(const JointEffort& effort, bool are_displaced, BulkJointBlock& block) {
  keep_impulses(block);
  std::swap(block.records, block.flying_records);
  if (are_displaced) {
    solve_after_displacements(effort, false, block);
  } else {
    // Rows and factors are those of where the bodies are, and no law is on.
    load_slots(block.records, effort.target, block.lanes);
    if (block.lanes.is_of_balls) {
      slow_balls(effort.target, block.lanes);
    } else {
      run_stage(JointStage::drift, effort.h, effort.target, block.lanes);
      run_stage(JointStage::solve, effort.h, effort.target, block.lanes);
    }
    store_slots(block.records, effort.target, block.lanes);
    // The first substep takes nothing of it back.
    for (JointSlot& slot : block.lanes.slots) slot.made_v = slot.made_w = FloatVec3{};
  }
  std::swap(block.records, block.flying_records);
  for (std::size_t i = 0; i < block.kept.size(); ++i)
    std::copy(block.kept[i].begin(), block.kept[i].end(), block.lanes.joints[i].impulse);
}

}  // namespace rigor
