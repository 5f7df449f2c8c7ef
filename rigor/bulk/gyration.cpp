#include "rigor/bulk/gyration.hpp"

#include "rigor/bulk/joint_turn.hpp"

namespace rigor {

namespace {

/// Changes below this [rad/s] a substep are not worth finding: bodies at rest.
constexpr float kLeastChange = 1e-7F;

/// See Gyrations.
///
/// Source: Catto, Numerical Methods, Game Developers Conference 2015.
RIGOR_FLOAT_LANES FloatVec3 change_in_lanes(const BodyGyration& bodies, const FloatVec3& w, float h) {
  const FloatVec3 e[3] = {bodies.axis0, bodies.axis1, cross(bodies.axis0, bodies.axis1)};
  const FloatLanes* I = bodies.moments;
  const FloatLanes b[3] = {dot(e[0], w), dot(e[1], w), dot(e[2], w)};

  // J x = h ω × I ω,  J = I + h (ω~ I - (I ω)~): row i has I_i on the diagonal and h (I_k - I_j) of the other
  // components.
  const FloatLanes g0 = h * (I[2] - I[1]), g1 = h * (I[0] - I[2]), g2 = h * (I[1] - I[0]);
  const FloatLanes f[3] = {g0 * b[1] * b[2], g1 * b[2] * b[0], g2 * b[0] * b[1]};
  const FloatLanes m01 = g0 * b[2], m02 = g0 * b[1];
  const FloatLanes m10 = g1 * b[2], m12 = g1 * b[0];
  const FloatLanes m20 = g2 * b[1], m21 = g2 * b[0];
  // Cramer's rule.
  const FloatLanes c00 = I[1] * I[2] - m12 * m21, c01 = m12 * m20 - m10 * I[2], c02 = m10 * m21 - I[1] * m20;
  const FloatLanes inverse = 1.0F / (I[0] * c00 + m01 * c01 + m02 * c02);
  const FloatLanes x[3] = {
      (f[0] * c00 + f[1] * (m02 * m21 - m01 * I[2]) + f[2] * (m01 * m12 - m02 * I[1])) * inverse,
      (f[0] * c01 + f[1] * (I[0] * I[2] - m02 * m20) + f[2] * (m02 * m10 - I[0] * m12)) * inverse,
      (f[0] * c02 + f[1] * (m01 * m20 - I[0] * m21) + f[2] * (I[0] * I[1] - m01 * m10)) * inverse};
  // One Newton step is not the solution: at several radians a step its energy may be more.
  FloatLanes before = float_lanes(0), after = float_lanes(0), y[3];
  for (int j = 0; j < 3; ++j) {
    y[j] = b[j] - x[j];
    before += I[j] * b[j] * b[j];
    after += I[j] * y[j] * y[j];
  }
  const FloatLanes scale = after > before ? float_sqrt(before / after) : float_lanes(1);
  for (int j = 0; j < 3; ++j) y[j] = scale * y[j] - b[j];
  return y[0] * e[0] + (y[1] * e[1] + y[2] * e[2]);
}

/// Lanes whose change is not worth finding.
RIGOR_FLOAT_LANES IntLanes turn_slowly(const FloatVec3& w, float h) {
  return h * dot(w, w) < float_lanes(kLeastChange);
}
RIGOR_FLOAT_LANES bool are_all(const IntLanes& mask) {
  bool all = true;
  for (int i = 0; i < kLaneCount; ++i) all = all && mask[i] != 0;
  return all;
}

/// Records of eight bodies, and where their changes go.
struct GyrationRecords {
  const float* records[kLaneCount];
  float* changes[kLaneCount];
};

RIGOR_FLOAT_LANES void find_group_in_lanes(const BodyGyration& start, float h, const GyrationRecords& at) {
  FloatSquare square;
  for (int i = 0; i < kLaneCount; ++i) square.row[i] = load_floats(at.records[i]);
  square = transpose(square);
  const FloatVec3 w{square.row[4], square.row[5], square.row[6]};
  FloatVec3 change{};
  const IntLanes is_slow = turn_slowly(w, h);
  if (!are_all(is_slow)) {
    for (int i = 0; i < kLaneCount; ++i) square.row[i] = load_floats(at.records[i] + kLaneCount);
    square = transpose(square);
    const FloatQuat turn = lane_turn({square.row[4], square.row[5], square.row[6]});
    BodyGyration now = start;
    now.axis0 = rotate(turn, start.axis0);
    now.axis1 = rotate(turn, start.axis1);
    change = change_in_lanes(now, w, h);
    // What a body gets does not depend on who shares its lanes.
    const FloatLanes zero = float_lanes(0);
    change = {is_slow ? zero : change.x, is_slow ? zero : change.y, is_slow ? zero : change.z};
  }
  for (int i = 0; i < kLaneCount; ++i) {
    at.changes[i][4] = change.x[i];
    at.changes[i][5] = change.y[i];
    at.changes[i][6] = change.z[i];
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void find_group_avx2(const BodyGyration& start, float h, const GyrationRecords& at) {
  find_group_in_lanes(start, h, at);
}
#else
void find_group_avx2(const BodyGyration& start, float h, const GyrationRecords& at) {
  find_group_in_lanes(start, h, at);
}
#endif
void find_group_portable(const BodyGyration& start, float h, const GyrationRecords& at) {
  find_group_in_lanes(start, h, at);
}

/// Whether the angular velocity stays while the body turns.
bool is_round(const Body& body) {
  return body.moments[0] == body.moments[1] && body.moments[1] == body.moments[2];
}

void set_lane(const Vec3& a, int lane, FloatVec3& to) {
  to.x[lane] = static_cast<float>(a.x());
  to.y[lane] = static_cast<float>(a.y());
  to.z[lane] = static_cast<float>(a.z());
}

}  // namespace

Gyrations::Gyrations(const Model& model, LaneTarget target) : target_(target) {
  int lane = kLaneCount;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic || is_round(body)) continue;
    if (lane == kLaneCount) {
      lane = 0;
      Group& group = groups_.emplace_back();
      group.bodies.fill(-1);
      for (FloatLanes& moment : group.start.moments) moment = float_lanes(1);
    }
    Group& group = groups_.back();
    group.bodies[static_cast<std::size_t>(lane)] = i;
    for (int k = 0; k < 3; ++k) group.start.moments[k][lane] = static_cast<float>(body.moments[k]);
    ++lane;
  }
}

void Gyrations::prepare(const BulkBodies& bodies) {
  for (Group& group : groups_) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int body = group.bodies[static_cast<std::size_t>(lane)];
      const Mat3 R_WB =
          body < 0 ? Mat3(Mat3::Identity()) : bodies.q[static_cast<std::size_t>(body)].toRotationMatrix();
      set_lane(R_WB.col(0), lane, group.start.axis0);
      set_lane(R_WB.col(1), lane, group.start.axis1);
    }
  }
}

void Gyrations::find_changes(float h, const BulkBodies& bodies, const Executor& executor,
                             std::vector<std::array<float, kLaneCount>>& turns) const {
  turns.resize(bodies.x.size());
  executor.for_ranges(static_cast<int>(groups_.size()), 64, [&](int begin, int end) {
    const MotionRecord nothing;
    std::array<float, kLaneCount> nowhere{};
    for (int g = begin; g < end; ++g) {
      const Group& group = groups_[static_cast<std::size_t>(g)];
      GyrationRecords at;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
        const std::size_t body = static_cast<std::size_t>(group.bodies[lane]);
        const bool is_used = group.bodies[lane] >= 0;
        at.records[lane] = is_used ? bodies.motion[body].v : nothing.v;
        at.changes[lane] = is_used ? turns[body].data() : nowhere.data();
      }
      target_ == LaneTarget::avx2 ? find_group_avx2(group.start, h, at)
                                  : find_group_portable(group.start, h, at);
    }
  });
}

}  // namespace rigor
