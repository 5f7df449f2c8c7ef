#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/minkowski.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// Polytope of triangles inside the difference B - A that grows point by point towards the boundary of the
/// difference. The heights of its facets over the origin are signed, so that the origin may be outside.
class ExpandingPolytope {
 public:
  struct Facet {
    std::array<int, 3> v;       ///< Points, counter-clockwise seen from outside.
    std::array<int, 3> across;  ///< Facet across the side v[k] v[k+1].
    Vec3 m;                     ///< Outward unit normal.
    double height;              ///< m · w of its plane [m].
    bool is_removed = false;
  };

  /// Begins with the simplex that a search has found, if it has four points and enough volume; otherwise with
  /// a tetrahedron of points far from each other, the first one lowest along n. A flat difference has no such
  /// tetrahedron; flat_normal() is then the direction in which it has no thickness.
  ExpandingPolytope(const CorePair& pair, const Vec3& n, std::span<const DifferencePoint> simplex = {});
  ExpandingPolytope(const ExpandingPolytope&) = delete;
  ExpandingPolytope& operator=(const ExpandingPolytope&) = delete;

  bool is_flat() const { return facets_.empty(); }
  const Vec3& flat_normal() const { return flat_normal_; }

  /// Index of the facet with the smallest height among those below the limit [m] that are not set aside;
  /// nothing if there is none.
  std::optional<int> lowest_facet(double limit = std::numeric_limits<double>::infinity()) const;
  void set_aside(int facet) { open_heights_[at(facet)] = kClosed; }
  const Facet& facet(int i) const { return facets_[at(i)]; }
  const DifferencePoint& point(int i) const { return points_[at(i)]; }
  std::array<DifferencePoint, 3> corners(int facet) const;

  /// Grows to hold p, which is above the facet. False if rounding permits no closed surface any more; the
  /// polytope must not be used after that.
  bool expand(int facet, const DifferencePoint& p);

 private:
  static constexpr double kClosed = std::numeric_limits<double>::infinity();
  struct Side {
    int from, to;  ///< Points.
    int facet;     ///< The facet that stays, on the other side.
  };
  int find_tetrahedron(const Vec3& n, std::array<DifferencePoint, 4>& corners);
  template <class Directions, class Distance>
  bool find_corner(const Directions& directions, const Distance& distance, const DifferencePoint& first,
                   DifferencePoint& corner) const;
  int add_facet(int i, int j, int k);
  void remove(int facet);
  void remove_seen_facets(int facet, const Vec3& w);
  bool close(int apex);

  const CorePair& pair_;
  alignas(std::max_align_t) std::array<std::byte, 24576> buffer_;  ///< Room for all but the hardest pairs.
  std::pmr::monotonic_buffer_resource memory_{buffer_.data(), buffer_.size()};
  Vec3 flat_normal_ = Vec3::UnitX();
  std::pmr::vector<DifferencePoint> points_{&memory_};
  std::pmr::vector<Facet> facets_{&memory_};
  std::pmr::vector<double> open_heights_{
      &memory_};                          ///< By facet; kClosed for one that is removed or set aside.
  std::pmr::vector<int> free_{&memory_};  ///< Removed facets, whose places are taken again.
  std::pmr::vector<Side> horizon_{&memory_};
  std::pmr::vector<int> stack_{&memory_};
  std::pmr::vector<int> facet_from_{
      &memory_};  ///< By point: the new facet whose side on the horizon begins there, or -1.
};

}  // namespace rigor
