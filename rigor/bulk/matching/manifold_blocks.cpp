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

namespace {

/// Whether a feature is a crossing of edges, a vertex of A, of B, or of both: where two edges lie on each
/// other, rounding decides which of them a corner is called after. Crossings that come and go are corners
/// elsewhere.
std::uint32_t feature_kind(std::uint32_t feature) {
  return feature >> 30;
}

}  // namespace

std::array<float, Manifold::max_points> remembered_impulses(const ManifoldMemories::View& memory,
                                                            const ManifoldView& manifold) {
  const std::size_t count = at(manifold.point_count), remembered = at(memory.point_count);
  std::array<float, Manifold::max_points> impulses{};
  const auto is_feature_of = [&](std::size_t k, std::size_t i) {
    return std::bit_cast<std::uint32_t>(memory.feature[k]) == manifold.points[i].feature;
  };
  // While bodies rest, points are the same and in the same order.
  std::size_t same = 0;
  for (; same < std::min(count, remembered) && is_feature_of(same, same); ++same)
    impulses[same] = memory.normal_impulse[same];
  if (same == count || same == remembered) return impulses;

  // Else the features are searched for.
  std::array<bool, Manifold::max_points> is_new{};
  for (std::size_t i = same; i < count; ++i) {
    std::size_t k = 0;
    while (k < remembered && !is_feature_of(k, i)) ++k;
    is_new[i] = k == remembered;
    if (!is_new[i]) impulses[i] = memory.normal_impulse[k];
  }
  // Those that are gone leave their impulse to new ones of another kind.
  for (std::size_t k = same; k < remembered; ++k) {
    const auto takes_over = [&](std::size_t i) {
      return is_new[i] && feature_kind(std::bit_cast<std::uint32_t>(memory.feature[k])) !=
                              feature_kind(manifold.points[i].feature);
    };
    int heirs = 0;
    bool is_there = false;
    for (std::size_t i = 0; i < count; ++i) {
      is_there = is_there || is_feature_of(k, i);
      heirs += takes_over(i) ? 1 : 0;
    }
    for (std::size_t i = 0; i < count && !is_there; ++i) {
      if (takes_over(i)) impulses[i] += memory.normal_impulse[k] / static_cast<float>(heirs);
    }
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
