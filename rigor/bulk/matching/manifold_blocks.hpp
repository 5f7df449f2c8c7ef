#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace rigor {

/// Eight floats, one per lane.
using LaneArray = std::array<float, kLaneCount>;

/// Frequencies of the springs of contacts of two dynamic bodies, and with bodies that stand still, in cycles
/// per substep [1]. Sweeps lag behind what many bodies do together: where 2 π times this is more than √2,
/// such motions are excited (docs/theory/bulk.md, section 3).
inline constexpr double contact_frequency_a_substep = 1.0 / 6;
inline constexpr double ground_frequency_a_substep = 2.0 / 9;

/// Contact as a stiff, strongly damped spring of the overlap (docs/theory/bulk.md, section 3).
struct Softness {
  float bias_rate = 0;      ///< Speed at which an overlap is put back, per metre of overlap [1/s].
  float mass_scale = 1;     ///< Factor of the impulse that stops the approach.
  float impulse_scale = 0;  ///< Fraction of the accumulated impulse by which the spring yields.
  float pad = 0;            ///< Fills up four floats, which are loaded at once.
};
/// The softness of a spring of a frequency [Hz] and damping ratio (1: critical), in substeps of h [s].
Softness make_softness(double frequency, double damping_ratio, double h);

/// What the manifolds of a block have in common, so that it holds and computes no more than they need.
struct BlockKind {
  int points;        ///< 1, 2 or 4; a manifold of three points has a fourth without mass.
  bool has_moments;  ///< Whether there is torsional or rolling friction.
  bool is_round;  ///< The inertia of all bodies is the same about all axes; distinguished for one point only.

  /// Whether moments act: with one point and neither torsional nor rolling friction only forces do.
  constexpr bool turns() const { return points > 1 || has_moments; }
  constexpr bool operator==(const BlockKind& other) const = default;
};
/// All kinds of blocks.
constexpr std::array<BlockKind, 7> block_kinds{{{1, false, true},
                                                {1, false, false},
                                                {2, false, false},
                                                {4, false, false},
                                                {1, true, false},
                                                {2, true, false},
                                                {4, true, false}}};
constexpr int block_kind_count = static_cast<int>(block_kinds.size());

/// Impulses of eight manifolds, of one substep or added up over those of a step, since each substep ends with
/// all that its contacts have done in it.
template <BlockKind kind>
struct BlockImpulses {
  static constexpr std::size_t points = kind.points;
  static constexpr std::size_t rows = points + 2 + (kind.turns() ? 1 : 0) + (kind.has_moments ? 2 : 0);

  std::array<LaneArray, rows> row{};

  LaneArray& normal(std::size_t point) { return row[point]; }  ///< [N s].
  const LaneArray& normal(std::size_t point) const { return row[point]; }
  LaneArray& tangent(std::size_t k) { return row[points + k]; }  ///< Along t1, t2, on B [N s].
  const LaneArray& tangent(std::size_t k) const { return row[points + k]; }
  LaneArray& twist() { return row[points + 2]; }  ///< About n, on B [N m s].
  const LaneArray& twist() const { return row[points + 2]; }
  LaneArray& roll(std::size_t k) { return row[points + 3 + k]; }  ///< About t1, t2, on B [N m s].
  const LaneArray& roll(std::size_t k) const { return row[points + 3 + k]; }
};

/// One point of each of eight manifolds.
struct BlockPoint {
  LaneArray gap;   ///< Gap at the beginning of the step [m].
  LaneArray mass;  ///< Inverse of the response of u_n to its own impulse [kg]; 0: there is no such point.
  LaneArray first_speed;  ///< Normal velocity at the beginning of the step [m/s].
};
/// Where a point is.
struct BlockArm {
  LaneArray p1, p2;  ///< From the centre of the manifold, along t1 and t2 [m].
  LaneArray length;  ///< [m].
};

/// What a block has besides where moments act.
template <int points>
struct PatchRows {
  std::array<BlockArm, points> arms;
  LaneArray Kvn;                ///< Of K: V_n by its impulse [1/kg].
  LaneArray Kww[6];             ///< Of K, along n, t1, t2: xx yy zz xy xz yz of W by moments [1/(kg m^2)].
  LaneArray Kvw[3][3];          ///< Of K: V (first) by moments, W (second) by impulses [1/(kg m)].
  LaneArray twist_mass;         ///< Inverse of the response to a moment about n [kg m^2].
  LaneArray first_friction[3];  ///< Impulses along t1, t2 and about n with which the step began.
};
/// What a block has besides where there is torsional or rolling friction.
struct RollingRows {
  LaneArray torsional_friction, rolling_friction;  ///< [m].
  LaneArray roll_mass[3];  ///< Inverse of the response to moments along t1, t2: 11 22 12 [kg m^2].
};
template <int number>
struct NoRows {};

/// Eight manifolds of one kind of which no two share a dynamic body, solved together, one per lane. Each has
/// a frame (t1, t2, n) at its centre c. V and W being the velocity of B against A at c and their relative
/// angular velocity along n, t1, t2, the normal velocity at the point (p1, p2) is V_n + p2 W_t1 - p1 W_t2. An
/// impulse at c and a moment change (V, W) by the symmetric 6 x 6 matrix K, so that a whole sweep needs the
/// bodies at its beginning and at its end only. Where no moments act, only V matters.
template <BlockKind block_kind>
struct alignas(32) ManifoldBlock
    : std::conditional_t<block_kind.turns(), PatchRows<block_kind.points>, NoRows<1>>,
      std::conditional_t<block_kind.has_moments, RollingRows, NoRows<2>> {
  static constexpr BlockKind kind = block_kind;
  static constexpr std::size_t point_count = kind.points;

  std::array<std::int32_t, kLaneCount> body_A, body_B;  ///< Empty lanes have those of the first.
  std::uint8_t moves_A = 0, moves_B = 0;                ///< Bits of lanes whose body is dynamic.
  std::uint8_t pressed[point_count] = {};  ///< Bits of lanes whose point had an impulse in this step.

  LaneArray n[3], t1[3];
  LaneArray rA[3], rB[3];  ///< Centre of the manifold from the centres of the bodies [m].
  /// Inverse inertias xx yy zz xy xz yz; of round bodies one number [1/(kg m^2)].
  LaneArray IA[kind.is_round ? 1 : 6], IB[kind.is_round ? 1 : 6];
  LaneArray Kvt[2];           ///< Of K: V_n by impulses along t1, t2 [1/kg].
  LaneArray tangent_mass[3];  ///< Inverse of the response at c along t1, t2: 11 22 12 [kg].
  /// Displacements that change the gaps: along n [m], about t1, t2 [rad].
  LaneArray moved[kind.turns() ? 3 : 1];
  std::array<BlockPoint, point_count> points;
  BlockImpulses<kind> impulses;     ///< Impulses of the last substep.
  LaneArray friction;               ///< Coulomb's coefficient.
  LaneArray bias_rate, mass_scale;  ///< The softness of its springs.
};

/// What a manifold needs besides its points.
struct ManifoldSurface {
  float friction = 0, restitution = 0;
  float torsional_friction = 0, rolling_friction = 0;  ///< [m].
};

/// One manifold of a block.
struct BlockLane {
  ManifoldView manifold;
  const ManifoldSurface* surface = nullptr;
  const Softness* softness = nullptr;
  ManifoldMemories::View memory;  ///< Where its impulses begin; without one, at zero.
  int body_A = -1, body_B = -1;
};

/// The normal impulse that the memory holds for a feature [N s]; 0 if it has none.
float remembered_impulse(const ManifoldMemories::View& memory, std::uint32_t feature);
/// The normal impulse with which each point of a manifold begins [N s]: what is remembered of its feature.
/// New features share the impulses of those of another kind that are gone: a corner of aligned boxes is now a
/// vertex, now a crossing of edges.
std::array<float, Manifold::max_points> remembered_impulses(const ManifoldMemories::View& memory,
                                                            const ManifoldView& manifold);

/// The kind of block for a manifold, as an index into block_kinds. is_round is that of BlockKind.
int find_block_kind(int point_count, const ManifoldSurface& surface, bool is_round);

// These are templates, since blocks differ in what they hold; they exist for all block_kinds.

/// Makes a block of one to eight manifolds: frames, points and responses, and the velocities at the beginning
/// of the step.
template <BlockKind kind>
void fill_block(LaneTarget target, std::span<const BlockLane> lanes, const BulkBodies& bodies,
                ManifoldBlock<kind>& block);
/// Applies the impulses that the block begins with.
template <BlockKind kind>
void warm_start_block(LaneTarget target, ManifoldBlock<kind>& block, BulkBodies& bodies);

enum class BlockPass {
  push,  ///< Overlaps are put back, at the rate of the spring.
  relax  ///< Velocities alone, without the spring.
};
/// One sweep over a block; h [s] is the length of the substep.
template <BlockKind kind>
void solve_block(LaneTarget target, BlockPass pass, float h, ManifoldBlock<kind>& block, BulkBodies& bodies);

/// A step of some substeps of h [s].
struct SpringStep {
  double h;
  int substeps;
};
/// Energies that the springs of the manifolds of a block hold at the end of a step [J]: Σ ½ k s² over points
/// that overlap by s, but not more than they held before, which `energies` has, and the work that has pressed
/// them in the step: overlaps that an impact makes are not paid for by it. What the soft constraint of
/// section 3 of docs/theory/bulk.md does at rest is the force of a spring of stiffness k = m ω². total: the
/// impulses of the step. Empty lanes get numbers of no meaning.
template <BlockKind kind>
void find_spring_energies(LaneTarget target, const ManifoldBlock<kind>& block,
                          const BlockImpulses<kind>& total, const BulkBodies& bodies, const SpringStep& step,
                          LaneArray& energies);

}  // namespace rigor
