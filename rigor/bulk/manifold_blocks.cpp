#include "rigor/bulk/manifold_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {

namespace {

void set_lane(const float* p, std::size_t lane_index, LaneArray (&a)[3]) {
  for (std::size_t k = 0; k < 3; ++k) a[k][lane_index] = p[k];
}

/// Columns of the inverse inertia into a lane.
void set_inertia(const InverseInertia& inertia, std::size_t i, LaneArray (&I)[6], LaneArray& m) {
  I[0][i] = inertia.xx;
  I[1][i] = inertia.yy;
  I[2][i] = inertia.zz;
  I[3][i] = inertia.xy;
  I[4][i] = inertia.xz;
  I[5][i] = inertia.yz;
  m[i] = inertia.inv_mass;
}

/// Two unit vectors that make a right-handed frame with the unit vector n.
///
/// Source: Duff et al., Building an Orthonormal Basis, Revisited, J. Computer Graphics Techniques 6(1), 2017,
/// listing 3.
void tangents(const float* n, float* t1, float* t2) {
  const float sign = std::copysign(1.0f, n[2]);
  const float a = -1 / (sign + n[2]);
  const float b = n[0] * n[1] * a;
  t1[0] = 1 + sign * n[0] * n[0] * a;
  t1[1] = sign * b;
  t1[2] = -sign * n[0];
  t2[0] = b;
  t2[1] = sign + n[1] * n[1] * a;
  t2[2] = -n[1];
}

float dot3(const float* a, const float* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

float remembered_impulse(const ManifoldMemory& memory, std::uint32_t feature) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(memory.point_count); ++i) {
    if (memory.feature[i] == feature) return memory.normal_impulse[i];
  }
  return 0;
}

Softness make_softness(double frequency, double damping_ratio, double h) {
  const double omega = 2 * std::numbers::pi * frequency;
  const double a1 = 2 * damping_ratio + h * omega;
  const double a2 = h * omega * a1;
  const double a3 = 1 / (1 + a2);
  return {static_cast<float>(omega / a1), static_cast<float>(a2 * a3), static_cast<float>(a3)};
}

void clear_block(ManifoldBlock& block) {
  block = ManifoldBlock{};
  block.manifold.fill(-1);
  // A frame in empty lanes too, so that nothing there is infinite.
  block.n[2].fill(1);
  block.t1[0].fill(1);
}

void fill_lane(const Manifold& manifold, const ManifoldSurface& surface, const Softness& softness, int body_A,
               int body_B, int number, const ManifoldMemory* memory, const BulkBodies& bodies, int lane_index,
               ManifoldBlock& block) {
  const std::size_t i = static_cast<std::size_t>(lane_index);
  const std::size_t count = static_cast<std::size_t>(manifold.point_count);
  const std::size_t a = static_cast<std::size_t>(body_A), b = static_cast<std::size_t>(body_B);
  if (lane_index == 0) {
    block.body_A.fill(body_A);
    block.body_B.fill(body_B);
  }
  block.body_A[i] = body_A;
  block.body_B[i] = body_B;
  block.manifold[i] = number;
  if (bodies.is_dynamic(body_A)) block.moves_A = static_cast<std::uint8_t>(block.moves_A | 1u << i);
  if (bodies.is_dynamic(body_B)) block.moves_B = static_cast<std::uint8_t>(block.moves_B | 1u << i);
  block.point_count = std::max(block.point_count, manifold.point_count);

  float t1[3], t2[3], center[3] = {0, 0, 0}, rB[3];
  tangents(manifold.normal, t1, t2);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < count; ++j) center[k] += manifold.points[j].p[k];
    center[k] /= static_cast<float>(count);
    rB[k] = center[k] - static_cast<float>(bodies.x[b][static_cast<Eigen::Index>(k)] -
                                           bodies.x[a][static_cast<Eigen::Index>(k)]);
  }
  set_lane(manifold.normal, i, block.n);
  set_lane(t1, i, block.t1);
  set_lane(center, i, block.rA);
  set_lane(rB, i, block.rB);
  set_inertia(bodies.inertia[a], i, block.IA, block.mA);
  set_inertia(bodies.inertia[b], i, block.IB, block.mB);
  for (std::size_t j = 0; j < count; ++j) {
    const ManifoldPoint& found = manifold.points[j];
    const float arm[3] = {found.p[0] - center[0], found.p[1] - center[1], found.p[2] - center[2]};
    BlockPoints& point = block.points[j];
    point.p1[i] = dot3(t1, arm);
    point.p2[i] = dot3(t2, arm);
    point.gap[i] = found.gap;
    point.mass[i] = 1;
    point.impulse[i] = memory == nullptr ? 0 : remembered_impulse(*memory, found.feature);
  }
  if (memory != nullptr) {
    block.tangent_impulse[0][i] = dot3(t1, memory->friction_impulse_W.data());
    block.tangent_impulse[1][i] = dot3(t2, memory->friction_impulse_W.data());
    block.twist_impulse[i] = memory->twist_impulse;
  }
  block.friction[i] = surface.friction;
  block.restitution[i] = surface.restitution;
  block.torsional_friction[i] = surface.torsional_friction;
  block.rolling_friction[i] = surface.rolling_friction;
  block.has_restitution = block.has_restitution || surface.restitution > 0;
  block.has_moments = block.has_moments || surface.rolling_friction > 0;
  block.bias_rate[i] = softness.bias_rate;
  block.mass_scale[i] = softness.mass_scale;
  block.impulse_scale[i] = softness.impulse_scale;
}

void read_lane(const ManifoldBlock& block, int lane_index, ManifoldMemory& memory) {
  const std::size_t i = static_cast<std::size_t>(lane_index);
  for (std::size_t j = 0; j < Manifold::max_points; ++j)
    memory.normal_impulse[j] = block.points[j].impulse[i];
  const float n[3] = {block.n[0][i], block.n[1][i], block.n[2][i]};
  float t1[3], t2[3];
  tangents(n, t1, t2);
  for (std::size_t k = 0; k < 3; ++k) {
    memory.friction_impulse_W[k] = block.tangent_impulse[0][i] * t1[k] + block.tangent_impulse[1][i] * t2[k];
  }
  memory.twist_impulse = block.twist_impulse[i];
}

}  // namespace rigor
