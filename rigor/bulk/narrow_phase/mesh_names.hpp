#pragma once

#include "rigor/bulk/narrow_phase/face_outlines.hpp"
#include "rigor/bulk/state/float_mesh.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace rigor {

// How the contacts of a mesh are named, and its triangles as outlines.

/// A 30-bit name of two features (Knuth's multiplicative hashing); the highest two bits say of which kind.
inline std::uint32_t name_of_two(int first, int second) {
  const std::uint64_t both =
      std::uint64_t{static_cast<std::uint32_t>(first)} << 32 | static_cast<std::uint32_t>(second);
  return static_cast<std::uint32_t>((both * 0x9e3779b97f4a7c15ULL) >> 34);
}

/// The number of an edge: that of its lower half.
inline int edge_number(const FloatMesh& mesh, int triangle, int side) {
  const FloatMesh::Triangle& own = mesh.triangles[at(triangle)];
  const int across = own.neighbour[at(side)];
  if (across < 0 || across > triangle) return 3 * triangle + side;
  const FloatMesh::Triangle& other = mesh.triangles[at(across)];
  int k = 0;
  while (k < 2 && other.neighbour[at(k)] != triangle) ++k;
  return 3 * across + k;
}

/// A triangle as an outline that is counter-clockwise about its normal towards the core.
struct TriangleOutline {
  float x[3], y[3], z[3];
  int corners[3] = {0, 1, 2};
  std::array<std::size_t, 3> order;  ///< Which corner of the triangle is which of the outline.
  std::array<int, 3> sides;          ///< Which side of the triangle is which of the outline.

  TriangleOutline(const Vec3f* p, bool turned)
      : order{0, turned ? std::size_t{2} : std::size_t{1}, turned ? std::size_t{1} : std::size_t{2}},
        sides{turned ? 2 : 0, 1, turned ? 0 : 2} {
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = p[order[k]].x();
      y[k] = p[order[k]].y();
      z[k] = p[order[k]].z();
    }
  }
  Vec3f corner(std::size_t k) const { return Vec3f(x[k], y[k], z[k]); }
  float size() const {
    float most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, corner(k).lpNorm<Eigen::Infinity>());
    return most;
  }
  FaceOutline outline() const { return {LaneColumns{x, y, z, 3}, corners, 3}; }
};

}  // namespace rigor
