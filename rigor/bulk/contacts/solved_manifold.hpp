#pragma once

#include "rigor/bulk/matching/manifold_blocks.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/types.hpp"

#include <array>
#include <cstddef>

namespace rigor {

/// The frame of a manifold at its centre, in W.
struct ManifoldFrame {
  Vec3 n, t1, t2;
  Vec3 rA, rB;  ///< The centre from those of the bodies [m].
};

/// Impulses of one manifold of a block (BlockImpulses); 0 what its kind does not have.
struct ManifoldImpulses {
  std::array<float, Manifold::max_points> normal{};
  std::array<float, 2> tangent{};
  float twist = 0;
  std::array<float, 2> roll{};

  ManifoldImpulses& operator+=(const ManifoldImpulses& other) {
    for (std::size_t k = 0; k < normal.size(); ++k) normal[k] += other.normal[k];
    for (std::size_t k = 0; k < 2; ++k) {
      tangent[k] += other.tangent[k];
      roll[k] += other.roll[k];
    }
    twist += other.twist;
    return *this;
  }
};

/// One manifold of a block, as measures and bounces read it.
struct SolvedManifold {
  struct Point {
    double p1 = 0, p2 = 0, gap = 0, mass = 0, first_speed = 0;  ///< BlockPoint, BlockArm.
    bool was_pressed = false;                                   ///< In any substep.
  };
  int body_A = -1, body_B = -1;
  ManifoldFrame frame;
  int point_count = 0;  ///< Of its kind of block: the last ones may have no mass.
  std::array<Point, Manifold::max_points> points;
  ManifoldImpulses impulses;             ///< Of the step.
  double bias_rate = 0, mass_scale = 1;  ///< Softness.
  double restitution = 0, friction = 0;
  double torsional_friction = 0, rolling_friction = 0;  ///< [m].
};

template <BlockKind kind>
ManifoldImpulses read_impulses(const BlockImpulses<kind>& impulses, int lane) {
  const std::size_t i = at(lane);
  ManifoldImpulses own;
  for (std::size_t k = 0; k < impulses.points; ++k) own.normal[k] = impulses.normal(k)[i];
  for (std::size_t k = 0; k < 2; ++k) own.tangent[k] = impulses.tangent(k)[i];
  if constexpr (kind.turns()) own.twist = impulses.twist()[i];
  if constexpr (kind.has_moments) own.roll = {impulses.roll(0)[i], impulses.roll(1)[i]};
  return own;
}

/// total: of the step. Without what only bounces need of the surface: set_surface().
template <BlockKind kind>
SolvedManifold read_manifold(const ManifoldBlock<kind>& block, const BlockImpulses<kind>& total, int lane) {
  const std::size_t i = at(lane);
  const auto vector = [&](const LaneArray(&rows)[3]) { return Vec3(rows[0][i], rows[1][i], rows[2][i]); };
  SolvedManifold own;
  own.body_A = block.body_A[i];
  own.body_B = block.body_B[i];
  own.frame.n = vector(block.n);
  own.frame.t1 = vector(block.t1);
  own.frame.t2 = own.frame.n.cross(own.frame.t1);
  own.frame.rA = vector(block.rA);
  own.frame.rB = vector(block.rB);
  own.point_count = kind.points;
  for (std::size_t k = 0; k < block.point_count; ++k) {
    const BlockPoint& point = block.points[k];
    own.points[k] = {
        0, 0, point.gap[i], point.mass[i], point.first_speed[i], (block.pressed[k] >> i & 1) != 0};
    if constexpr (kind.turns()) own.points[k].p1 = block.arms[k].p1[i];
    if constexpr (kind.turns()) own.points[k].p2 = block.arms[k].p2[i];
  }
  own.impulses = read_impulses(total, lane);
  own.bias_rate = block.bias_rate[i];
  own.mass_scale = block.mass_scale[i];
  return own;
}

/// The laws of the surface.
inline void set_surface(const ManifoldSurface& surface, SolvedManifold& manifold) {
  manifold.restitution = surface.restitution;
  manifold.friction = surface.friction;
  manifold.torsional_friction = surface.torsional_friction;
  manifold.rolling_friction = surface.rolling_friction;
}

/// Adds impulses to those of a lane, as far as its kind has them.
template <BlockKind kind>
void add_impulses(const ManifoldImpulses& added, int lane, BlockImpulses<kind>& impulses) {
  const std::size_t i = at(lane);
  for (std::size_t k = 0; k < impulses.points; ++k) impulses.normal(k)[i] += added.normal[k];
  for (std::size_t k = 0; k < 2; ++k) impulses.tangent(k)[i] += added.tangent[k];
  if constexpr (kind.turns()) impulses.twist()[i] += added.twist;
  if constexpr (kind.has_moments) {
    for (std::size_t k = 0; k < 2; ++k) impulses.roll(k)[i] += added.roll[k];
  }
}

/// Impulses with which the next step begins, features aside: those of the last substep. Friction of patches
/// is the mean of what this step began and ended with, which damps what it would excite (docs/theory/bulk.md,
/// section 4).
template <BlockKind kind>
void read_lane(const ManifoldBlock<kind>& block, int lane, const ManifoldMemories::Slot& to) {
  const std::size_t i = at(lane);
  const auto& impulses = block.impulses;
  for (std::size_t k = 0; k < at(to.point_count); ++k) to.normal_impulse[k] = impulses.normal(k)[i];
  float friction[2] = {impulses.tangent(0)[i], impulses.tangent(1)[i]};
  if constexpr (kind.turns()) {
    for (std::size_t k = 0; k < 2; ++k) friction[k] = 0.5F * (block.first_friction[k][i] + friction[k]);
    *to.twist_impulse = 0.5F * (block.first_friction[2][i] + impulses.twist()[i]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    const float t1 = block.t1[k][i], t2 = block.n[l][i] * block.t1[m][i] - block.n[m][i] * block.t1[l][i];
    to.friction_impulse_W[k] = friction[0] * t1 + friction[1] * t2;
    if constexpr (kind.has_moments)
      to.rolling_impulse_W[k] = impulses.roll(0)[i] * t1 + impulses.roll(1)[i] * t2;
  }
}

}  // namespace rigor
