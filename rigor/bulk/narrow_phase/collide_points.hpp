#pragma once

#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"

#include <cstdint>
#include <vector>

namespace rigor {

/// A point that a manifold may have.
struct ManifoldCandidate {
  Vec3f p;    ///< Midway between the witness points, as in the Manifold [m].
  float gap;  ///< [m].
  std::uint32_t feature;
};

// Names of the features of the cores of A and B that meet. They do not say whose face the normal belongs to,
// so that they stay the same while two parallel faces take turns.

/// An edge of A crosses one of B, which has edge_count_B of them.
constexpr std::uint32_t crossing_feature(int edge_A, int edge_B, std::size_t edge_count_B) {
  return static_cast<std::uint32_t>(edge_A) * static_cast<std::uint32_t>(edge_count_B) +
         static_cast<std::uint32_t>(edge_B);
}
/// A vertex of A lies over a face or an edge of B.
constexpr std::uint32_t vertex_A_feature(int vertex) {
  return 1u << 30 | static_cast<std::uint32_t>(vertex);
}
/// A vertex of B lies over a face or an edge of A.
constexpr std::uint32_t vertex_B_feature(int vertex) {
  return 2u << 30 | static_cast<std::uint32_t>(vertex);
}
/// Two vertices meet.
constexpr std::uint32_t vertices_feature(int vertex_A, int vertex_B, int vertex_count_B) {
  return 3u << 30 | (static_cast<std::uint32_t>(vertex_A) * static_cast<std::uint32_t>(vertex_count_B) +
                     static_cast<std::uint32_t>(vertex_B));
}

/// The manifold of at most four of the candidates, all of them if there are no more: a deepest one, the one
/// farthest from it, the one that spans the largest triangle with them, and the one that adds most to that.
/// Candidates whose gaps differ by less than `equal_depth` are equally deep; of those that are equal the
/// lowest feature is chosen, so that the choice stays while bodies rest. Candidates are left sorted by
/// feature, each feature once.
Manifold make_manifold(const Vec3f& normal, float equal_depth, std::vector<ManifoldCandidate>& candidates);

}  // namespace rigor
