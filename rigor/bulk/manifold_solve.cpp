#include "rigor/bulk/manifold_blocks.hpp"

#include <cstddef>

namespace rigor {

namespace {

/// Fastest at which overlaps are put back [m/s]: a deep one is not an explosion.
constexpr float max_push_speed = 3;
/// The points of a manifold are solved this often one after the other: near enough to a block.
constexpr int block_sweeps = 3;
/// A contact that meets more slowly does not bounce [m/s].
constexpr float bounce_speed = 1e-2f;

/// Velocities (or displacements) of eight bodies.
struct LaneTwists {
  FloatVec3 v, w;
};

RIGOR_FLOAT_LANES FloatLanes lane(const LaneArray& a) {
  return load_floats(a.data());
}
RIGOR_FLOAT_LANES FloatVec3 lane(const LaneArray (&a)[3]) {
  return {lane(a[0]), lane(a[1]), lane(a[2])};
}
RIGOR_FLOAT_LANES FloatSym3 lane(const LaneArray (&a)[6]) {
  return {lane(a[0]), lane(a[1]), lane(a[2]), lane(a[3]), lane(a[4]), lane(a[5])};
}
RIGOR_FLOAT_LANES void put(const FloatLanes& x, LaneArray& a) {
  store_floats(x, a.data());
}

alignas(64) constexpr MotionRecord no_motion{};

RIGOR_FLOAT_LANES const MotionRecord& motion_of(const BulkBodies& bodies, std::int32_t body) {
  return body < 0 ? no_motion : bodies.motion[static_cast<std::size_t>(body)];
}

RIGOR_FLOAT_LANES void gather_velocities(const std::array<std::int32_t, kLaneCount>& who,
                                         const BulkBodies& bodies, LaneTwists& twists) {
  FloatSquare rows;
  for (std::size_t i = 0; i < kLaneCount; ++i) rows.row[i] = load_floats(motion_of(bodies, who[i]).v);
  const FloatSquare columns = transpose(rows);
  twists = {{columns.row[0], columns.row[1], columns.row[2]},
            {columns.row[4], columns.row[5], columns.row[6]}};
}

RIGOR_FLOAT_LANES void gather_displacements(const std::array<std::int32_t, kLaneCount>& who,
                                            const BulkBodies& bodies, LaneTwists& twists) {
  FloatSquare rows;
  for (std::size_t i = 0; i < kLaneCount; ++i) rows.row[i] = load_floats(motion_of(bodies, who[i]).dp);
  const FloatSquare columns = transpose(rows);
  twists = {{columns.row[0], columns.row[1], columns.row[2]},
            {columns.row[4], columns.row[5], columns.row[6]}};
}

/// Velocities of the lanes whose body is dynamic; the inverse mass stands between them and stays.
RIGOR_FLOAT_LANES void scatter_velocities(const std::array<std::int32_t, kLaneCount>& who, std::uint8_t moves,
                                          const LaneArray& inv_mass, const LaneTwists& twists,
                                          BulkBodies& bodies) {
  const FloatLanes zero = float_lanes(0);
  const FloatSquare columns{
      {twists.v.x, twists.v.y, twists.v.z, lane(inv_mass), twists.w.x, twists.w.y, twists.w.z, zero}};
  const FloatSquare rows = transpose(columns);
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if (moves >> i & 1) store_floats(rows.row[i], bodies.motion[static_cast<std::size_t>(who[i])].v);
  }
}

/// Frame, arms and responses of a block, in registers.
struct BlockFrame {
  FloatVec3 n, t1, t2, rA, rB;
};
RIGOR_FLOAT_LANES BlockFrame frame_of(const ManifoldBlock& block) {
  BlockFrame frame;
  frame.n = lane(block.n);
  frame.t1 = lane(block.t1);
  frame.t2 = cross(frame.n, frame.t1);
  frame.rA = lane(block.rA);
  frame.rB = lane(block.rB);
  return frame;
}

/// Velocity (or displacement) of B against A at the centre of the manifold.
RIGOR_FLOAT_LANES FloatVec3 relative_motion(const BlockFrame& f, const LaneTwists& A, const LaneTwists& B) {
  return (B.v + cross(B.w, f.rB)) - (A.v + cross(A.w, f.rA));
}

/// An impulse at the centre and a moment, on B.
RIGOR_FLOAT_LANES void apply_wrench(const ManifoldBlock& block, const BlockFrame& f, const FloatVec3& impulse,
                                    const FloatVec3& moment, LaneTwists& A, LaneTwists& B) {
  A.v = A.v - lane(block.mA) * impulse;
  A.w = A.w - lane(block.IA) * (cross(f.rA, impulse) + moment);
  B.v = B.v + lane(block.mB) * impulse;
  B.w = B.w + lane(block.IB) * (cross(f.rB, impulse) + moment);
}

/// u = (n.V, t1.W, t2.W): what the normal velocities of the points are made of.
struct NormalMotion {
  FloatLanes u0, u1, u2;
};
RIGOR_FLOAT_LANES NormalMotion normal_motion(const BlockFrame& f, const LaneTwists& A, const LaneTwists& B) {
  const FloatVec3 turn = B.w - A.w;
  return {dot(f.n, relative_motion(f, A, B)), dot(f.t1, turn), dot(f.t2, turn)};
}
RIGOR_FLOAT_LANES FloatLanes at_point(const NormalMotion& u, const FloatLanes& p1, const FloatLanes& p2) {
  return u.u0 + p2 * u.u1 - p1 * u.u2;
}

/// Impulses of points together: (sum of F, sum of p2 F, -sum of p1 F), the wrench that u is the velocity of.
RIGOR_FLOAT_LANES void add_point_impulse(const ManifoldBlock& block, const FloatLanes& p1,
                                         const FloatLanes& p2, const FloatLanes& impulse,
                                         NormalMotion& wrench, NormalMotion& u) {
  const FloatLanes f1 = p2 * impulse;
  const FloatLanes f2 = -(p1 * impulse);
  wrench.u0 = wrench.u0 + impulse;
  wrench.u1 = wrench.u1 + f1;
  wrench.u2 = wrench.u2 + f2;
  u.u0 = u.u0 + (lane(block.K[0]) * impulse + lane(block.K[3]) * f1 + lane(block.K[4]) * f2);
  u.u1 = u.u1 + (lane(block.K[3]) * impulse + lane(block.K[1]) * f1 + lane(block.K[5]) * f2);
  u.u2 = u.u2 + (lane(block.K[4]) * impulse + lane(block.K[5]) * f1 + lane(block.K[2]) * f2);
}

/// Normal impulses of all points, one after the other. Displacements count while overlaps are put back and
/// for points that are still apart.
template <BlockPass pass>
RIGOR_FLOAT_LANES NormalMotion solve_normals(float h, const NormalMotion& moved, NormalMotion u,
                                             ManifoldBlock& block) {
  const FloatLanes zero = float_lanes(0);
  const FloatLanes one = float_lanes(1);
  const FloatLanes per_h = float_lanes(1 / h);
  NormalMotion wrench{zero, zero, zero};
  for (int k = 0; k < block_sweeps * block.point_count; ++k) {
    BlockPoints& point = block.points[static_cast<std::size_t>(k % block.point_count)];
    const FloatLanes p1 = lane(point.p1), p2 = lane(point.p2);
    const FloatLanes old = lane(point.impulse);
    const FloatLanes speed = at_point(u, p1, p2);
    FloatLanes next;
    if constexpr (pass == BlockPass::restitution) {
      const FloatLanes first = lane(point.first_speed);
      const FloatLanes wanted = -(lane(block.restitution) * first);
      const FloatLanes push = float_max(old - lane(point.mass) * (speed - wanted), zero);
      const IntLanes bounces = (first < float_lanes(-bounce_speed)) & (lane(point.max_impulse) > zero);
      next = bounces ? push : old;
    } else {
      const FloatLanes gap = lane(point.gap) + at_point(moved, p1, p2);
      const IntLanes is_apart = gap > zero;
      FloatLanes bias = is_apart ? gap * per_h : zero;
      FloatLanes mass_scale = one, give = zero;
      if constexpr (pass == BlockPass::push) {
        const FloatLanes back = float_max(lane(block.bias_rate) * gap, float_lanes(-max_push_speed));
        bias = is_apart ? bias : back;
        mass_scale = is_apart ? one : lane(block.mass_scale);
        give = is_apart ? zero : lane(block.impulse_scale);
      }
      next = float_max(old - lane(point.mass) * mass_scale * (speed + bias) - give * old, zero);
    }
    put(next, point.impulse);
    put(float_max(lane(point.max_impulse), next), point.max_impulse);
    add_point_impulse(block, p1, p2, next - old, wrench, u);
  }
  return wrench;
}

/// Keeps (x, y) within a disc.
RIGOR_FLOAT_LANES void clamp_to_disc(const FloatLanes& radius, FloatLanes& x, FloatLanes& y) {
  const FloatLanes one = float_lanes(1);
  const FloatLanes length = float_sqrt(x * x + y * y);
  const FloatLanes scale = length > radius ? radius / length : one;
  x = x * scale;
  y = y * scale;
}

/// Coulomb friction of the manifold at its centre, on the disc of all its normal impulses, and of its patch
/// against turning about n. Returns the impulse; the moment is the twist's.
RIGOR_FLOAT_LANES void solve_friction(const BlockFrame& f, ManifoldBlock& block, LaneTwists& A,
                                      LaneTwists& B) {
  FloatLanes pressed = float_lanes(0), spread = float_lanes(0);
  for (int i = 0; i < block.point_count; ++i) {
    const BlockPoints& point = block.points[static_cast<std::size_t>(i)];
    const FloatLanes p1 = lane(point.p1), p2 = lane(point.p2);
    pressed = pressed + lane(point.impulse);
    spread = spread + lane(point.impulse) * float_sqrt(p1 * p1 + p2 * p2);
  }
  const FloatLanes friction = lane(block.friction);
  const FloatLanes old_twist = lane(block.twist_impulse);
  const FloatLanes twist_limit = friction * spread + lane(block.torsional_friction) * pressed;
  const FloatLanes free_twist = old_twist - lane(block.twist_mass) * dot(f.n, B.w - A.w);
  const FloatLanes twist = float_min(float_max(free_twist, -twist_limit), twist_limit);
  put(twist, block.twist_impulse);
  apply_wrench(block, f, float_lanes(0) * f.n, (twist - old_twist) * f.n, A, B);

  const FloatVec3 slip = relative_motion(f, A, B);
  const FloatLanes s1 = dot(f.t1, slip), s2 = dot(f.t2, slip);
  const FloatLanes old1 = lane(block.tangent_impulse[0]), old2 = lane(block.tangent_impulse[1]);
  FloatLanes f1 = old1 - (lane(block.tangent_mass[0]) * s1 + lane(block.tangent_mass[2]) * s2);
  FloatLanes f2 = old2 - (lane(block.tangent_mass[2]) * s1 + lane(block.tangent_mass[1]) * s2);
  clamp_to_disc(friction * pressed, f1, f2);
  put(f1, block.tangent_impulse[0]);
  put(f2, block.tangent_impulse[1]);
  apply_wrench(block, f, (f1 - old1) * f.t1 + (f2 - old2) * f.t2, float_lanes(0) * f.n, A, B);

  if (!block.has_moments) return;
  const FloatVec3 turn = B.w - A.w;
  const FloatLanes r1 = dot(f.t1, turn), r2 = dot(f.t2, turn);
  const FloatLanes was1 = lane(block.roll_impulse[0]), was2 = lane(block.roll_impulse[1]);
  FloatLanes m1 = was1 - (lane(block.roll_mass[0]) * r1 + lane(block.roll_mass[2]) * r2);
  FloatLanes m2 = was2 - (lane(block.roll_mass[2]) * r1 + lane(block.roll_mass[1]) * r2);
  clamp_to_disc(lane(block.rolling_friction) * pressed, m1, m2);
  put(m1, block.roll_impulse[0]);
  put(m2, block.roll_impulse[1]);
  apply_wrench(block, f, float_lanes(0) * f.n, (m1 - was1) * f.t1 + (m2 - was2) * f.t2, A, B);
}

template <BlockPass pass>
RIGOR_FLOAT_LANES void solve_pass(float h, ManifoldBlock& block, BulkBodies& bodies) {
  const BlockFrame f = frame_of(block);
  LaneTwists A, B;
  gather_velocities(block.body_A, bodies, A);
  gather_velocities(block.body_B, bodies, B);
  const FloatLanes zero = float_lanes(0);
  NormalMotion moved{zero, zero, zero};
  if constexpr (pass != BlockPass::restitution) {
    LaneTwists dA, dB;
    gather_displacements(block.body_A, bodies, dA);
    gather_displacements(block.body_B, bodies, dB);
    moved = normal_motion(f, dA, dB);
  }
  // Friction first: that bodies do not enter each other matters more. Last where its bound is that of the
  // impulse that remains: the spring gives way before, and takes a part of the pressure with it.
  if constexpr (pass == BlockPass::push) solve_friction(f, block, A, B);
  const NormalMotion wrench = solve_normals<pass>(h, moved, normal_motion(f, A, B), block);
  apply_wrench(block, f, wrench.u0 * f.n, wrench.u1 * f.t1 + wrench.u2 * f.t2, A, B);
  if constexpr (pass == BlockPass::relax) solve_friction(f, block, A, B);
  scatter_velocities(block.body_A, block.moves_A, block.mA, A, bodies);
  scatter_velocities(block.body_B, block.moves_B, block.mB, B, bodies);
}

RIGOR_FLOAT_LANES void solve_any(BlockPass pass, float h, ManifoldBlock& block, BulkBodies& bodies) {
  switch (pass) {
    case BlockPass::push:
      solve_pass<BlockPass::push>(h, block, bodies);
      break;
    case BlockPass::relax:
      solve_pass<BlockPass::relax>(h, block, bodies);
      break;
    case BlockPass::restitution:
      solve_pass<BlockPass::restitution>(h, block, bodies);
      break;
  }
}

RIGOR_FLOAT_LANES void warm_start_lanes(ManifoldBlock& block, BulkBodies& bodies) {
  const BlockFrame f = frame_of(block);
  LaneTwists A, B;
  gather_velocities(block.body_A, bodies, A);
  gather_velocities(block.body_B, bodies, B);
  const FloatLanes zero = float_lanes(0);
  NormalMotion wrench{zero, zero, zero};
  for (int i = 0; i < block.point_count; ++i) {
    const BlockPoints& point = block.points[static_cast<std::size_t>(i)];
    const FloatLanes impulse = lane(point.impulse);
    wrench.u0 = wrench.u0 + impulse;
    wrench.u1 = wrench.u1 + lane(point.p2) * impulse;
    wrench.u2 = wrench.u2 - lane(point.p1) * impulse;
  }
  const FloatVec3 impulse =
      wrench.u0 * f.n + lane(block.tangent_impulse[0]) * f.t1 + lane(block.tangent_impulse[1]) * f.t2;
  const FloatVec3 moment = (wrench.u1 + lane(block.roll_impulse[0])) * f.t1 +
                           (wrench.u2 + lane(block.roll_impulse[1])) * f.t2 + lane(block.twist_impulse) * f.n;
  apply_wrench(block, f, impulse, moment, A, B);
  scatter_velocities(block.body_A, block.moves_A, block.mA, A, bodies);
  scatter_velocities(block.body_B, block.moves_B, block.mB, B, bodies);
}

/// a.(I b) for one body.
RIGOR_FLOAT_LANES FloatLanes form(const FloatVec3& a, const FloatSym3& I, const FloatVec3& b) {
  return dot(a, I * b);
}

/// Inverse of the matrix ((a, c), (c, b)); zero where it is singular (nothing moves).
RIGOR_FLOAT_LANES void invert(const FloatLanes& a, const FloatLanes& b, const FloatLanes& c,
                              LaneArray (&inverse)[3]) {
  const FloatLanes zero = float_lanes(0);
  const FloatLanes determinant = a * b - c * c;
  const FloatLanes per = determinant > zero ? float_lanes(1) / determinant : zero;
  put(b * per, inverse[0]);
  put(a * per, inverse[1]);
  put(-(c * per), inverse[2]);
}

RIGOR_FLOAT_LANES FloatLanes inverse_or_zero(const FloatLanes& x) {
  const FloatLanes zero = float_lanes(0);
  return x > zero ? float_lanes(1) / x : zero;
}

RIGOR_FLOAT_LANES void complete_lanes(const BulkBodies& bodies, ManifoldBlock& block) {
  const BlockFrame f = frame_of(block);
  const FloatSym3 IA = lane(block.IA), IB = lane(block.IB);
  const FloatLanes m = lane(block.mA) + lane(block.mB);
  const FloatVec3 aA = cross(f.rA, f.n), aB = cross(f.rB, f.n);
  const FloatLanes k00 = m + form(aA, IA, aA) + form(aB, IB, aB);
  const FloatLanes k11 = form(f.t1, IA, f.t1) + form(f.t1, IB, f.t1);
  const FloatLanes k22 = form(f.t2, IA, f.t2) + form(f.t2, IB, f.t2);
  const FloatLanes k01 = form(aA, IA, f.t1) + form(aB, IB, f.t1);
  const FloatLanes k02 = form(aA, IA, f.t2) + form(aB, IB, f.t2);
  const FloatLanes k12 = form(f.t1, IA, f.t2) + form(f.t1, IB, f.t2);
  put(k00, block.K[0]);
  put(k11, block.K[1]);
  put(k22, block.K[2]);
  put(k01, block.K[3]);
  put(k02, block.K[4]);
  put(k12, block.K[5]);
  invert(k11, k22, k12, block.roll_mass);
  put(inverse_or_zero(form(f.n, IA, f.n) + form(f.n, IB, f.n)), block.twist_mass);

  const FloatVec3 bA = cross(f.rA, f.t1), bB = cross(f.rB, f.t1);
  const FloatVec3 cA = cross(f.rA, f.t2), cB = cross(f.rB, f.t2);
  invert(m + form(bA, IA, bA) + form(bB, IB, bB), m + form(cA, IA, cA) + form(cB, IB, cB),
         form(bA, IA, cA) + form(bB, IB, cB), block.tangent_mass);

  LaneTwists A, B;
  gather_velocities(block.body_A, bodies, A);
  gather_velocities(block.body_B, bodies, B);
  const NormalMotion u = normal_motion(f, A, B);
  const FloatLanes zero = float_lanes(0);
  const FloatLanes two = float_lanes(2);
  for (int i = 0; i < block.point_count; ++i) {
    BlockPoints& point = block.points[static_cast<std::size_t>(i)];
    const FloatLanes p1 = lane(point.p1), p2 = lane(point.p2);
    const FloatLanes response =
        k00 + p2 * p2 * k11 + p1 * p1 * k22 + two * (p2 * k01 - p1 * k02 - p1 * p2 * k12);
    // The mask of the points that there are stands in `mass` until now.
    put(lane(point.mass) > zero ? inverse_or_zero(response) : zero, point.mass);
    put(at_point(u, p1, p2), point.first_speed);
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void solve_avx2(BlockPass pass, float h, ManifoldBlock& block, BulkBodies& bodies) {
  solve_any(pass, h, block, bodies);
}
[[gnu::target("avx2")]] void warm_start_avx2(ManifoldBlock& block, BulkBodies& bodies) {
  warm_start_lanes(block, bodies);
}
[[gnu::target("avx2")]] void complete_avx2(const BulkBodies& bodies, ManifoldBlock& block) {
  complete_lanes(bodies, block);
}
#endif

}  // namespace

#if defined(__x86_64__)
void complete_block(LaneTarget target, const BulkBodies& bodies, ManifoldBlock& block) {
  target == LaneTarget::avx2 ? complete_avx2(bodies, block) : complete_lanes(bodies, block);
}
void warm_start_block(LaneTarget target, ManifoldBlock& block, BulkBodies& bodies) {
  target == LaneTarget::avx2 ? warm_start_avx2(block, bodies) : warm_start_lanes(block, bodies);
}
void solve_block(LaneTarget target, BlockPass pass, float h, ManifoldBlock& block, BulkBodies& bodies) {
  target == LaneTarget::avx2 ? solve_avx2(pass, h, block, bodies) : solve_any(pass, h, block, bodies);
}
#else
void complete_block(LaneTarget /*target*/, const BulkBodies& bodies, ManifoldBlock& block) {
  complete_lanes(bodies, block);
}
void warm_start_block(LaneTarget /*target*/, ManifoldBlock& block, BulkBodies& bodies) {
  warm_start_lanes(block, bodies);
}
void solve_block(LaneTarget /*target*/, BlockPass pass, float h, ManifoldBlock& block, BulkBodies& bodies) {
  solve_any(pass, h, block, bodies);
}
#endif

}  // namespace rigor
