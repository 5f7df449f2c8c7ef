#pragma once

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"

#include <span>
#include <vector>

namespace rigor {

/// What a convex shape shows along a direction: a point, a segment (the straight line on the side of a
/// cylinder), a disc or a polygon, which may be a little tilted. Positions are in the frame O of a pair.
struct ShownSide {
  enum class Kind : std::int8_t { point, segment, disc, polygon };
  Kind kind = Kind::point;
  Vec3f lowest = Vec3f::Zero();  ///< The point that reaches farthest along the direction [m].
  int lowest_name = 0;
  Vec3f m = Vec3f::UnitZ();  ///< Outward unit normal of a disc or a polygon; the axis of a segment's solid.
  Vec3f ends[2];             ///< Of a segment [m].
  int end_names[2] = {0, 0};
  bool is_straight = false;  ///< Whether all of the segment reaches equally far along the direction.
  Vec3f center;              ///< Of a disc, or of the circle on which a segment begins [m].
  Vec3f radii[2];            ///< Two radii of a disc, square to each other [m].
  float r = 0;               ///< [m].
  int first_name = 0;        ///< Of the points at these radii and opposite to them.
  LaneColumns points{};      ///< Of a polygon; its corners run counter-clockwise about m.
  std::span<const int> corners{}, edges{};

  Vec3f corner(std::size_t k) const;
  std::size_t corner_count() const;
  int corner_name(std::size_t k) const;
};

/// How far points of a region may be beyond a border, up to which gap they count, by how much both shapes are
/// grown, and where the points go.
struct RegionScale {
  float slack, margin;
  float radius_A, radius_B;
};

/// What was found: the least gap (infinite if there is no point), and how far the two points of it are beside
/// each other [m].
struct RegionResult {
  float least, beside;
};
/// Finds the points of two sides that lie over each other along n, from A to B: corners of either over the
/// other, and crossings of their borders; where neither is flat, the nearest points and, of two segments, the
/// ends over the round side of the other.
RegionResult find_region(const ShownSide& a, const ShownSide& b, const Vec3f& n, const RegionScale& scale,
                         std::vector<ManifoldCandidate>& candidates);

/// Adds the point midway between the points p_A and p_B of two cores that n parts.
void add_between(const Vec3f& p_A, const Vec3f& p_B, const Vec3f& n, std::uint32_t feature,
                 const RegionScale& scale, std::vector<ManifoldCandidate>& candidates);

}  // namespace rigor
