// Eight bodies of GyroscopicTerms. Included once for each target, after rotation_lanes.inl and
// gyroscopic_kernels.inl.

/// Changes below this [rad/s] a substep are not worth finding: bodies at rest.
constexpr float kLeastChange = 1e-7F;

void find_group(const GyroscopicState& start, bool is_of_revolution, float h,
                const GyroscopicRecords& records) {
  // Angular velocities: the first eight floats of a record are (v, 1/m, w, 0).
  const FloatLanes zero = splat(0);
  FloatSquare square;
  for (int i = 0; i < kLaneCount; ++i) square.row[i] = load(records.of_bodies[i]);
  square = transpose(square);
  const FloatVec3 w{square.row[4], square.row[5], square.row[6]};

  // Nothing to do if all bodies turn so slowly that the change is not worth finding.
  FloatVec3 change{zero, zero, zero};
  const IntLanes is_slow = splat(h < 0 ? -h : h) * fused_dot(w, w) < splat(kLeastChange);
  if (lane_bits(is_slow) != 0xff) {
    for (int i = 0; i < kLaneCount; ++i) square.row[i] = load(records.of_bodies[i] + kLaneCount);
    square = transpose(square);
    // The principal axes, rotated by dr since the beginning of the step.
    const LaneRotation rotation = rotation_over(1, {square.row[4], square.row[5], square.row[6]});
    const FloatVec3 axis = start.axes[0] + displacement_of(rotation, start.axes[0]);
    if (is_of_revolution) {
      change = change_about_axis(axis, start.spin, w, h);
    } else {
      change = change_by_newton({axis, start.axes[1] + displacement_of(rotation, start.axes[1])},
                                start.moments, w, h);
    }
    // The change of a body must not depend on the bodies beside it.
    change = {is_slow ? zero : change.x, is_slow ? zero : change.y, is_slow ? zero : change.z};
  }

  for (int i = 0; i < kLaneCount; ++i) {
    records.changes[i][4] = change.x[i];
    records.changes[i][5] = change.y[i];
    records.changes[i][6] = change.z[i];
  }
}
