// A step of contact-free chains of ball joints: bodies are read, take all substeps and are written
// (docs/theory/bulk_joints.md, section 2). Included once for each target, after contact_free_substeps.inl.

/// a, rotated by the unit quaternion (w, v): a + w c + v × c with c = 2 v × a.
RIGOR_FLOAT_LANES DoubleVec3 rotated(const DoubleVec3& v, const DoubleLanes& w, const DoubleVec3& a) {
  const DoubleVec3 b = {v.y * a.z - v.z * a.y, v.z * a.x - v.x * a.z, v.x * a.y - v.y * a.x};
  const DoubleVec3 c = {b.x + b.x, b.y + b.y, b.z + b.z};
  return {a.x + (w * c.x + (v.y * c.z - v.z * c.y)), a.y + (w * c.y + (v.z * c.x - v.x * c.z)),
          a.z + (w * c.z + (v.x * c.y - v.y * c.x))};
}
RIGOR_FLOAT_LANES FloatVec3 rounded(const DoubleVec3& a) {
  return {__builtin_convertvector(a.x, FloatLanes), __builtin_convertvector(a.y, FloatLanes),
          __builtin_convertvector(a.z, FloatLanes)};
}

/// Where eight bodies are, in 64 bits.
struct alignas(64) FreePlace {
  DoubleVec3 x, q;  ///< q: its vector.
  DoubleLanes w;
};
RIGOR_FLOAT_LANES FreePlace place_of_slot(const std::array<std::int32_t, kLaneCount>& indices,
                                          const BulkBodies& bodies) {
  // Lanes without a body have the origin.
  const double *x[kLaneCount], *q[kLaneCount];
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    static constexpr double origin[4] = {0, 0, 0, 1};
    x[i] = indices[i] < 0 ? origin : bodies.x[at(indices[i])].data();
    q[i] = indices[i] < 0 ? origin : bodies.q[at(indices[i])].coeffs().data();
  }

  // Seven columns: position and quaternion.
  DoubleLanes lanes[7];
  for (int k = 0; k < 7; ++k) {
    const double** from = k < 3 ? x : q;
    const int j = k < 3 ? k : k - 3;
    lanes[k] = DoubleLanes{from[0][j], from[1][j], from[2][j], from[3][j],
                           from[4][j], from[5][j], from[6][j], from[7][j]};
  }
  return {{lanes[0], lanes[1], lanes[2]}, {lanes[3], lanes[4], lanes[5]}, lanes[6]};
}

/// Axes, arms and gaps of the anchors at the beginning of a step. Whether one is more than substeps of h put
/// back, so that a part is left out.
RIGOR_FLOAT_LANES bool place_nodes(const FreeTables& tables, const BulkBodies& bodies, float h,
                                   std::vector<FreeNode>& nodes) {
  bool approaches = false;
  const float most = static_cast<float>(kApproachSpeed) * h;
  std::vector<FreePlace> places(tables.slots.size());
  for (std::size_t s = 0; s < places.size(); ++s) places[s] = place_of_slot(tables.slots[s], bodies);
  for (std::size_t i = 0; i < tables.joints.size(); ++i) {
    const FreeJoint& joint = tables.joints[i];
    const FreePlace& child = places[i];
    FreeNode& node = nodes[i];
    // The principal axes: of bodies of revolution the first is enough.
    for (int k = 0; k < (tables.are_of_revolution ? 1 : 2); ++k) {
      node.axes[k] = rounded(rotated(child.q, child.w, tables.bodies[i].axes_B[k]));
    }

    // Arms and gaps, as differences in 64 bits that are rounded then.
    const DoubleVec3 arm_child = rotated(child.q, child.w, joint.arm_child_B);
    node.arm_child = rounded(arm_child);
    if (joint.parent < 0) continue;
    const FreePlace& parent = places[at(joint.parent)];
    const DoubleVec3 arm_parent = rotated(parent.q, parent.w, joint.arm_parent_B);
    node.arm_parent = rounded(arm_parent);
    node.apart = rounded({(child.x.x - parent.x.x) + (arm_child.x - arm_parent.x),
                          (child.x.y - parent.x.y) + (arm_child.y - arm_parent.y),
                          (child.x.z - parent.x.z) + (arm_child.z - arm_parent.z)});
    approaches = approaches || lane_bits(fused_dot(node.apart, node.apart) > splat(most * most)) != 0;
  }
  if (!approaches) return false;

  // What is not much is seen as it is.
  const FloatLanes zero = splat(0);
  for (FreeNode& node : nodes) {
    node.left_out = std::exchange(node.apart, {zero, zero, zero});
    see_more(h, node);
  }
  return true;
}

std::pair<double, int> worst_gap(const FreeTables& tables, const BulkBodies& bodies) {
  std::vector<FreePlace> places(tables.slots.size());
  for (std::size_t s = 0; s < places.size(); ++s) places[s] = place_of_slot(tables.slots[s], bodies);

  // In each lane the joint whose anchors are farthest apart.
  DoubleLanes worst = {};
  NumberLanes which = {};
  for (std::size_t i = 0; i < tables.joints.size(); ++i) {
    const FreeJoint& joint = tables.joints[i];
    if (joint.parent < 0) continue;
    const FreePlace &child = places[i], &parent = places[at(joint.parent)];
    const DoubleVec3 arm_child = rotated(child.q, child.w, joint.arm_child_B);
    const DoubleVec3 arm_parent = rotated(parent.q, parent.w, joint.arm_parent_B);
    const DoubleLanes x = (child.x.x - parent.x.x) + (arm_child.x - arm_parent.x);
    const DoubleLanes y = (child.x.y - parent.x.y) + (arm_child.y - arm_parent.y);
    const DoubleLanes z = (child.x.z - parent.x.z) + (arm_child.z - arm_parent.z);
    const DoubleLanes squared = x * x + y * y + z * z;
    const NumberLanes number = NumberLanes{} + static_cast<std::int64_t>(i);
    which = squared > worst ? number : which;
    worst = squared > worst ? squared : worst;
  }

  // The worst of the lanes.
  std::pair<double, int> found{0, -1};
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    const int k = static_cast<int>(lane);
    const int number = tables.joints[at(which[k])].numbers[lane];
    const double squared = worst[k];
    if (number >= 0 && squared > found.first) found = {squared, number};
  }
  return {std::sqrt(found.first), found.second};
}

/// Eight floats of each of eight rows, transposed.
RIGOR_FLOAT_LANES FloatSquare load_rows(const std::array<const float*, kLaneCount>& from) {
  FloatSquare square;
  for (int i = 0; i < kLaneCount; ++i) square.row[i] = load(from[at(i)]);
  return transpose(square);
}

/// Velocities and their changes by forces, of the lanes that count; other lanes have none.
RIGOR_FLOAT_LANES void load_nodes(const FreeTables& tables, const ContactFreeChains::Step& step,
                                  unsigned lanes, const BulkBodies& bodies, std::vector<FreeNode>& nodes) {
  static constexpr MotionRecord nothing{};
  static constexpr MotionRow no_row{};
  const FloatLanes zero = splat(0);
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    std::array<const float*, kLaneCount> records, rows;
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      const int body = tables.slots[s][i];
      const bool counts = body >= 0 && (lanes >> i & 1) != 0;
      records[i] = counts ? bodies.motion[at(body)].v : nothing.v;
      rows[i] = counts ? step.accelerations[at(body)].data() : no_row.data();
    }

    // Records begin with (v, 1/m, w, 0).
    FreeNode& node = nodes[s];
    FloatSquare square = load_rows(records);
    node.v = {square.row[0], square.row[1], square.row[2]};
    node.w = {square.row[4], square.row[5], square.row[6]};
    node.dp = node.dr = {zero, zero, zero};

    // Accelerations over the substep, of the bodies that joints move.
    if (s >= tables.joints.size()) continue;
    square = load_rows(rows);
    const FloatLanes h = splat(step.h);
    node.dv = h * FloatVec3{square.row[0], square.row[1], square.row[2]};
    node.dw = h * FloatVec3{square.row[4], square.row[5], square.row[6]};
  }
}

/// Writes the records of the bodies that joints move: (v, 1/m, w, 0, dp, 0, dr, 0).
RIGOR_FLOAT_LANES void store_nodes(const FreeTables& tables, unsigned lanes,
                                   const std::vector<FreeNode>& nodes, BulkBodies& bodies) {
  const FloatLanes zero = splat(0);
  for (std::size_t s = 0; s < tables.joints.size(); ++s) {
    const FreeNode& node = nodes[s];
    const FloatLanes& inverse_mass = tables.bodies[s].inverse_mass;
    const FloatSquare moving = transpose(
        FloatSquare{{node.v.x, node.v.y, node.v.z, inverse_mass, node.w.x, node.w.y, node.w.z, zero}});
    const FloatSquare moved = transpose(
        FloatSquare{{node.dp.x, node.dp.y, node.dp.z, zero, node.dr.x, node.dr.y, node.dr.z, zero}});
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      if ((lanes >> i & 1) == 0) continue;
      float* record = bodies.motion[at(tables.slots[s][i])].v;
      store_floats(moving.row[i], record);
      store_floats(moved.row[i], record + kLaneCount);
    }
  }
}

/// The impulses of the substep before, on the children.
void place_impulses(const FreeTables& tables, const std::vector<float>& impulses,
                    std::vector<FreeNode>& nodes) {
  for (std::size_t i = 0; i < tables.joints.size(); ++i) {
    FloatVec3 on_B = {splat(0), splat(0), splat(0)};
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int joint = tables.joints[i].numbers[at(lane)];
      if (joint < 0 || impulses.empty()) continue;
      const float* const own = &impulses[6 * at(joint)];
      on_B.x[lane] = own[0];
      on_B.y[lane] = own[1];
      on_B.z[lane] = own[2];
    }
    nodes[i].impulse = tables.joints[i].sign * on_B;
  }
}

void advance(const FreeTables& tables, const ContactFreeChains::Step& step, unsigned lanes,
             BulkBodies& bodies, std::vector<ContactFreeChains::Impulse>& impulses) {
  // The bodies are read once, ...
  std::vector<FreeNode> nodes(tables.slots.size());
  load_nodes(tables, step, lanes, bodies, nodes);
  const bool approaches = place_nodes(tables, bodies, step.h, nodes);

  // ... take all substeps, ...
  place_impulses(tables, step.impulses, nodes);
  TautTrees taut;
  const FreeStep work{tables, nodes, taut, step.h, approaches};
  tables.are_of_revolution ? take_substeps<true>(step.substeps, work)
                           : take_substeps<false>(step.substeps, work);

  // ... and are written once.
  store_nodes(tables, lanes, nodes, bodies);
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    impulses[i].on_B = tables.joints[i].sign * nodes[i].impulse;
  }
}
