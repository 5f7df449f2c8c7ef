#include "rigor/bulk/manifold_blocks.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {

float remembered_impulse(const ManifoldMemory& memory, std::uint32_t feature) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(memory.point_count); ++i) {
    if (memory.feature[i] == feature) return memory.normal_impulse[i];
  }
  return 0;
}

std::array<float, Manifold::max_points> remembered_impulses(const ManifoldMemory& memory,
                                                            const Manifold& manifold) {
  const std::size_t count = static_cast<std::size_t>(manifold.point_count);
  std::array<float, Manifold::max_points> impulses{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t feature = manifold.points[i].feature;
    const bool is_same = i < static_cast<std::size_t>(memory.point_count) && memory.feature[i] == feature;
    impulses[i] = is_same ? memory.normal_impulse[i] : remembered_impulse(memory, feature);
  }
  return impulses;
}

Softness make_softness(double frequency, double damping_ratio, double h) {
  const double omega = 2 * std::numbers::pi * frequency;
  const double a1 = 2 * damping_ratio + h * omega;
  const double a2 = h * omega * a1;
  const double a3 = 1 / (1 + a2);
  return {static_cast<float>(omega / a1), static_cast<float>(a2 * a3), static_cast<float>(a3)};
}

void read_lane(const ManifoldBlock& block, int lane_index, ManifoldMemory& memory) {
  const std::size_t i = static_cast<std::size_t>(lane_index);
  for (std::size_t j = 0; j < Manifold::max_points; ++j)
    memory.normal_impulse[j] = block.points[j].impulse[i];
  const float n[3] = {block.n[0][i], block.n[1][i], block.n[2][i]};
  const float t1[3] = {block.t1[0][i], block.t1[1][i], block.t1[2][i]};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    const float t2 = n[l] * t1[m] - n[m] * t1[l];
    memory.friction_impulse_W[k] = block.tangent_impulse[0][i] * t1[k] + block.tangent_impulse[1][i] * t2;
  }
  memory.twist_impulse = block.twist_impulse[i];
}

}  // namespace rigor
