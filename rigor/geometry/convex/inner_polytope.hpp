#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/polytope.hpp"

#include <array>
#include <cstdint>

namespace rigor {

/// Vertices of the difference B - A, by the vertices of A and B, and triangles over them that closed around
/// the origin: what is left of a proof, to begin the next one nearby with.
struct CachedProof {
  static constexpr int kMaxPoints = 40;
  static constexpr int kMaxFacets = 2 * kMaxPoints - 4;
  using Triple = std::array<std::uint8_t, 3>;

  int point_count = 0;  ///< 0: nothing is known.
  int facet_count = 0;
  std::array<std::array<int, 2>, kMaxPoints> points;  ///< Vertex of A, vertex of B.
  std::array<Triple, kMaxFacets> corners;             ///< Points of a facet.
  std::array<Triple, kMaxFacets> across;              ///< Facets across its sides.
};

/// Closed surface of triangles whose corners are points of the difference B - A of two overlapping polytopes,
/// in the frame of A. If the heights of all facets over the origin are at least h > 0, the ball of radius h
/// lies inside the difference: its triangles all turn the same way as seen from the origin, so that they wind
/// around all of the ball, and nothing outside a convex set can be wound around by its points. So no
/// direction parts the bodies by less than h. Convexity of the surface is not needed.
class InnerPolytope {
 public:
  InnerPolytope(const PolytopePair& pair, double rounding) : pair_(pair), rounding_(rounding) {}

  /// Vertices of A and of B.
  using Name = std::array<int, 2>;

  /// Begins with a tetrahedron: a triangle, in which the origin's foot should lie, and the point farthest
  /// from it, along n. False if that is flat.
  bool begin(const std::array<Name, 3>& triangle, const Vec3& n);
  /// Begins with a former proof at the present poses; false if it is none any more.
  bool begin(const CachedProof& proof);

  /// The facet with the smallest height.
  int lowest() const;
  double height(int facet) const { return heights_[at(facet)]; }
  /// Outward unit normal.
  const Vec3& normal(int facet) const { return normals_[at(facet)]; }
  /// Vertices of A and B that make the facet's first corner.
  const Name& corner(int facet) const { return names_[at(facets_[at(facet)].corners[0])]; }

  /// Grows to hold the difference of vertices `b` - `a`, which is above the facet. False if there is no room
  /// or rounding allows no closed surface; then the polytope is of no further use.
  bool expand(int facet, int a, int b);

  /// Leaves the proof for later; nothing if it is too large.
  void store(CachedProof& proof) const;

 private:
  static constexpr int kMaxPoints = 100;
  static constexpr int kMaxFacets = 2 * kMaxPoints;
  struct Facet {
    std::array<int, 3> corners;
    std::array<int, 3> across;  ///< Facet across the side from corner k to corner k + 1.
  };
  struct Side {
    int from, to, facet;
  };

  int add_point(int a, int b);
  bool measure(int facet);
  bool find_visible(int facet, const Vec3& w);
  bool close(int apex);

  const PolytopePair& pair_;
  double rounding_;
  int point_count_ = 0;
  int facet_count_ = 0;
  int removed_count_ = 0;
  int horizon_count_ = 0;
  std::array<Name, kMaxPoints> names_;
  std::array<Vec3, kMaxPoints> points_;
  std::array<int, kMaxPoints> side_from_;
  std::array<Facet, kMaxFacets> facets_;
  std::array<Vec3, kMaxFacets> normals_;
  std::array<double, kMaxFacets> heights_;
  std::array<int, kMaxFacets> removed_;
  std::array<bool, kMaxFacets> is_removed_;
  std::array<Side, kMaxFacets> horizon_;
};

}  // namespace rigor
