#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <span>
#include <vector>

namespace rigor {

// The loops over vertices, faces and edges of hulls, eight at a time, for either target.

/// The point that is farthest along a direction (the first of equal ones), and how far that is.
struct Support {
  int index;
  float height;
};
Support find_support(const LaneColumns& points, const Vec3f& n, LaneTarget target);

/// How far the farthest of `count` points is along a direction, and how many are lower by no more than
/// `drop`.
struct SupportSet {
  float height;
  int count;
};
SupportSet find_support_set(const LaneColumns& points, int count, const Vec3f& n, float drop,
                            LaneTarget target);

/// Writes n · p for all points, less their offsets, if there are any.
void find_heights(const LaneColumns& points, const Vec3f& n, const float* offsets, LaneTarget target,
                  float* heights);
/// Numbers in whole lanes, and the level above which they count.
struct LevelColumn {
  const std::vector<float>& numbers;
  float level;
};
/// Lists the places among the first `count` at which both are above their levels.
void list_above(const LevelColumn& x, const LevelColumn& y, int count, LaneTarget target,
                std::vector<int>& places);

/// A core as the search for parting directions sees it.
struct SupportCore {
  LaneColumns vertices;
  const PlacedShape* placed;
  Vec3f scale;
};
/// The separation min n · b - max n · a of two cores along n; d is from
float find_separation(const SupportCore& a, const SupportCore& b, const Vec3f& d, const Vec3f& n,
                      LaneTarget target);

/// The placement of a core: vertices by p -> M p + t, normals by R.
struct CorePlace {
  Mat3f M, R;
  Vec3f t;
};
/// Columns of points or directions after placing.
class PlacedColumns {
 public:
  /// Places all points by p -> M p + t.
  void place(const LaneColumns& points, const Mat3f& M, const Vec3f& t, LaneTarget target);
  LaneColumns columns() const { return {place_of(0), place_of(1), place_of(2), count_}; }
  Vec3f operator[](int i) const {
    const float* const first = numbers_.data() + at(i);
    return Vec3f(first[0], first[count_], first[2 * count_]);
  }

 private:
  const float* place_of(std::size_t column) const { return numbers_.data() + column * count_; }

  std::size_t count_ = 0;
  std::vector<float> numbers_;  ///< The columns, one after the other.
};

/// Edges of a core with the normals of their faces, placed, in blocks of eight, for the test of their arcs on
/// the Gauss map. The padding of the last block crosses nothing.
class ArcBlocks {
 public:
  /// Edge vector, first and second normal, a point of the edge: three coordinates each.
  enum Part { along = 0, normal_0 = 3, normal_1 = 6, point = 9, part_count = 12 };
  struct Block {
    alignas(32) float part[part_count][kLaneCount];
  };

  void place(const FloatHull& hull, std::span<const int> edges, const CorePlace& place, LaneTarget target);
  std::size_t count() const { return edges_.size(); }
  int edge(std::size_t k) const { return edges_[k]; }
  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  std::vector<int> edges_;
  std::vector<Block> blocks_;
};

/// The pair of edges of A and B whose arcs cross and that separates the cores best, if it does so by more
/// than `least`: indices among the arcs, -1 if there is none. The normals of B are those of its faces; on the
/// Gauss map its arcs are negated. The first of equally good pairs is taken.
struct EdgeChoice {
  int a = -1, b = -1;
  float separation;
};
EdgeChoice find_best_edges(const ArcBlocks& a, const ArcBlocks& b, float least, LaneTarget target);

/// Eight segments from q along v, in lanes.
struct SegmentLanes {
  alignas(32) float q[3][kLaneCount];
  alignas(32) float v[3][kLaneCount];
};
/// Writes the squared distances of all of these from the segment from p along u, in whole lanes.
void find_square_distances(const Vec3f& p, const Vec3f& u, const std::vector<SegmentLanes>& segments,
                           LaneTarget target, float* squares);
/// The least number of whole lanes, and the places of all numbers that are at most `most`.
float least_of(const std::vector<float>& x, LaneTarget target);
void list_up_to(const std::vector<float>& x, float most, LaneTarget target, std::vector<int>& places);

}  // namespace rigor
