#include "rigor/bulk/matching/manifold_blocks.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {

float remembered_impulse(const ManifoldMemories::View& memory, std::uint32_t feature) {
  for (std::size_t i = 0; i < at(memory.point_count); ++i) {
    if (std::bit_cast<std::uint32_t>(memory.feature[i]) == feature) return memory.normal_impulse[i];
  }
  return 0;
}

std::array<float, Manifold::max_points> remembered_impulses(const ManifoldMemories::View& memory,
                                                            const ManifoldView& manifold) {
  const std::size_t count = at(manifold.point_count);
  std::array<float, Manifold::max_points> impulses{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t feature = manifold.points[i].feature;
    // While bodies rest, points are the same and in the same order; else the feature is searched for.
    const bool is_same =
        i < at(memory.point_count) && std::bit_cast<std::uint32_t>(memory.feature[i]) == feature;
    impulses[i] = is_same ? memory.normal_impulse[i] : remembered_impulse(memory, feature);
  }
  return impulses;
}

Softness make_softness(double frequency, double damping_ratio, double h) {
  // The implicit step of the spring: a1 = 2 ζ + h ω, a2 = h ω a1 (docs/theory/bulk.md, section 3).
  const double omega = 2 * std::numbers::pi * frequency;
  const double a1 = 2 * damping_ratio + h * omega;
  const double a2 = h * omega * a1;
  const double a3 = 1 / (1 + a2);
  return {static_cast<float>(omega / a1), static_cast<float>(a2 * a3), static_cast<float>(a3)};
}

int find_block_kind(int point_count, const ManifoldSurface& surface, bool is_round) {
  // The index follows the order of block_kinds.
  const bool has_moments = surface.torsional_friction > 0 || surface.rolling_friction > 0;
  if (point_count == 1 && is_round && !has_moments) return 0;
  return (has_moments ? 4 : 1) + std::min(point_count - 1, 2);
}

}  // namespace rigor
