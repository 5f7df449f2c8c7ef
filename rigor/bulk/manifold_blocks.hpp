#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/float_lanes.hpp"
#include "rigor/bulk/manifold.hpp"
#include "rigor/geometry/lane_target.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace rigor {

/// Eight floats, one a lane.
using LaneArray = std::array<float, kLaneCount>;

/// Frequency of the spring of a contact of two dynamic bodies, a substep [1]: what one sweep a substep holds
/// quietly. Twice that against what stands still.
inline constexpr double contact_frequency_a_substep = 1.0 / 6;

/// Contact as a stiff, strongly damped spring of the overlap (docs/theory/bulk.md, section 3).
struct Softness {
  float bias_rate = 0;      ///< Speed by which an overlap is put back, a metre [1/s].
  float mass_scale = 1;     ///< Of the impulse that meets the speed.
  float impulse_scale = 0;  ///< Part of the impulse that the spring gives way.
  float pad = 0;            ///< To four floats, which are loaded at once.
};
/// frequency [Hz], damping_ratio (1: critical), h [s] of a substep.
Softness make_softness(double frequency, double damping_ratio, double h);

/// The point of one corner of eight manifolds.
struct alignas(32) BlockPoints {
  LaneArray p1, p2;   ///< From the centre of the manifold, along t1 and t2 [m].
  LaneArray gap;      ///< At the begin of the step [m].
  LaneArray mass;     ///< Inverse of the response of u_n to its own impulse [kg]; 0: there is no such point.
  LaneArray impulse;  ///< Of the normal, of the last substep [N s].
  LaneArray arm;      ///< Distance from the centre of the manifold [m].
  LaneArray first_speed;  ///< Normal velocity at the begin of the step [m/s].
};

/// Eight manifolds of which no two share a dynamic body: solved together, one a lane. Each has a frame (t1,
/// t2, n) at its centre c. V and W being the velocity of B against A at c and their relative angular velocity
/// along n, t1, t2, the normal velocity at the point (p1, p2) is V_n + p2 W_t1 - p1 W_t2. An impulse at c and
/// a moment change (V, W) by the symmetric 6 x 6 matrix K, so that a whole sweep needs the bodies at its
/// begin and at its end only.
struct alignas(64) ManifoldBlock {
  std::array<std::int32_t, kLaneCount> body_A, body_B;  ///< Empty lanes: those of the first.
  std::array<std::int32_t, kLaneCount> manifold;        ///< Whose it is; -1: empty lane.
  std::array<std::int32_t, kLaneCount> pressed;  ///< Bits of the points that had an impulse in this step.
  std::uint8_t moves_A = 0, moves_B = 0;         ///< Bits of lanes whose body is dynamic.
  bool has_restitution = false, has_moments = false;
  int point_count = 0;  ///< The most of any lane.

  LaneArray n[3], t1[3];
  LaneArray rA[3], rB[3];  ///< Centre of the manifold from the centres of the bodies [m].
  LaneArray mA, mB;        ///< Inverse masses [1/kg].
  LaneArray IA[6], IB[6];  ///< Inverse inertias xx yy zz xy xz yz [1/(kg m^2)].
  LaneArray Kvv[6],
      Kww[6];           ///< K, along n, t1, t2: xx yy zz xy xz yz of V by impulses [1/kg], of W by moments.
  LaneArray Kvw[3][3];  ///< V (first) by moments, W (second) by impulses [1/(kg m)].
  LaneArray moved[3];   ///< Displacements that change the gaps: along n [m], about t1, t2 [rad].
  std::array<BlockPoints, Manifold::max_points> points;

  LaneArray friction;                   ///< Coulomb's coefficient.
  LaneArray tangent_mass[3];            ///< Inverse of the response at c along t1, t2: 11 22 12 [kg].
  LaneArray tangent_impulse[2];         ///< Along t1, t2, on B [N s].
  LaneArray twist_mass, twist_impulse;  ///< About n [kg m^2], [N m s].
  LaneArray torsional_friction, rolling_friction;  ///< [m].
  LaneArray roll_mass[3];                          ///< Inverse of the response to moments along t1, t2.
  LaneArray roll_impulse[2];                       ///< [N m s].
  LaneArray restitution;
  LaneArray bias_rate, mass_scale, impulse_scale;  ///< Softness.
};

/// What a manifold needs besides its points.
struct ManifoldSurface {
  float friction = 0, restitution = 0;
  float torsional_friction = 0, rolling_friction = 0;  ///< [m].
};

/// One manifold of a block.
struct BlockLane {
  const Manifold* manifold = nullptr;
  const ManifoldSurface* surface = nullptr;
  const Softness* softness = nullptr;
  const ManifoldMemory* memory = nullptr;  ///< Where its impulses begin; nullptr: from zero.
  int body_A = -1, body_B = -1;
  int number = -1;
};

/// The normal impulse that the memory has of a feature [N s]; 0 if it has none.
float remembered_impulse(const ManifoldMemory& memory, std::uint32_t feature);
/// Of each point of a manifold.
std::array<float, Manifold::max_points> remembered_impulses(const ManifoldMemory& memory,
                                                            const Manifold& manifold);

/// Makes a block of one to eight manifolds: frames, points and responses, and the velocities at the begin of
/// the step.
void fill_block(LaneTarget target, std::span<const BlockLane> lanes, const BulkBodies& bodies,
                ManifoldBlock& block);
/// Impulses of a lane, features aside.
void read_lane(const ManifoldBlock& block, int lane, ManifoldMemory& memory);

/// Applies the impulses that the block begins with.
void warm_start_block(LaneTarget target, ManifoldBlock& block, BulkBodies& bodies);

enum class BlockPass {
  push,  ///< Overlaps are put back, as fast as the spring does.
  relax  ///< Velocities alone, without the spring.
};
/// One sweep over a block. h [s]: of the substep.
void solve_block(LaneTarget target, BlockPass pass, float h, ManifoldBlock& block, BulkBodies& bodies);

}  // namespace rigor
