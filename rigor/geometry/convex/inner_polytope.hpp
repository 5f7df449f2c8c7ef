#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/polytope.hpp"

#include <array>
#include <cstdint>

namespace rigor {

/// Vertices of the difference B - A, named by the vertices of A and B, and triangles over them that enclosed
/// the origin: an earlier proof, with which the next one nearby can begin.
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
/// lies inside the difference: all triangles have the same orientation as seen from the origin, so that the
/// surface winds around every point of the ball, and points of a convex set cannot wind around a point
/// outside it. So no direction separates the bodies by a translation shorter than h. The surface need not be
/// convex.
class InnerPolytope {
 public:
  InnerPolytope(const PolytopePair& pair, double rounding) : pair_(pair), rounding_(rounding) {}

  /// A point of the difference, by its vertex of A and its vertex of B.
  using Name = std::array<int, 2>;

  /// Begins with a tetrahedron: a triangle, which should hold the foot of the origin, and the point farthest
  /// from it, along n. False if the tetrahedron is flat.
  bool begin(const std::array<Name, 3>& triangle, const Vec3& n);
  /// Begins with an earlier proof at the present poses; false if it is no longer one.
  bool begin(const CachedProof& proof);

  /// The facet with the smallest height.
  int lowest() const;
  double height(int facet) const { return heights_[at(facet)]; }
  /// Outward unit normal.
  const Vec3& normal(int facet) const { return normals_[at(facet)]; }
  /// Vertices of A and B whose difference is the facet's first corner.
  const Name& corner(int facet) const { return names_[at(facets_[at(facet)].corners[0])]; }

  /// Grows to hold the difference `b` - `a` of two vertices, which is above the facet. False if there is no
  /// room or rounding permits no closed surface; the polytope must not be used after that.
  bool expand(int facet, int a, int b);

  /// Stores the proof for the next query; stores none if it is too large.
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
