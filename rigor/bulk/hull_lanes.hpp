#pragma once

#include "rigor/bulk/bulk_shape.hpp"
#include "rigor/bulk/float_lanes.hpp"
#include "rigor/geometry/lane_target.hpp"

#include <vector>

namespace rigor {

// The loops over vertices, faces and edges of hulls, eight at a time, for either target.

/// The point that is farthest along a direction (of equal ones the first), and how far that is.
struct Support {
  int index;
  float height;
};
Support find_support(const LaneColumns& points, const Vec3f& n, LaneTarget target);

/// How far the farthest of `count` points is along a direction, and how many are lower by no more than
/// `drop`.
struct Summit {
  float height;
  int count;
};
Summit find_summit(const LaneColumns& points, int count, const Vec3f& n, float drop, LaneTarget target);

/// n · p of all of them.
void find_heights(const LaneColumns& points, const Vec3f& n, LaneTarget target, float* heights);

/// A core as the search for parting directions sees it.
struct SupportCore {
  LaneColumns vertices;
  const PlacedShape* placed;
  Vec3f scale;
};
/// min n · b - max n · a of two cores; d: from the origin of a's frame to that of b's.
float find_separation(const SupportCore& a, const SupportCore& b, const Vec3f& d, const Vec3f& n,
                      LaneTarget target);

/// Edges with the normals of their faces, in columns of whole lanes, for the test of their arcs on the Gauss
/// map. What pads them crosses nothing. A segment, whose arc is a circle, has no place here.
class ArcColumns {
 public:
  /// Edge vector, first and second normal, a point of the edge: three columns each.
  enum Part { along = 0, normal_0 = 3, normal_1 = 6, point = 9, column_count = 12 };

  void resize(std::size_t count);
  std::size_t count() const { return edges_.size(); }
  int edge(std::size_t k) const { return edges_[k]; }
  const float* column(int c) const { return values_.data() + static_cast<std::size_t>(c) * stride_; }
  void set_edge(std::size_t k, int e) { edges_[k] = e; }
  void set(std::size_t k, Part part, const Vec3f& a) {
    for (int c = 0; c < 3; ++c) values_[static_cast<std::size_t>(part + c) * stride_ + k] = a[c];
  }

 private:
  std::size_t stride_ = 0;
  std::vector<float> values_;
  std::vector<int> edges_;
};

/// Which of the arcs of B, of eight from number `first` on, cross arc i of A and belong to edges that part
/// the cores by more than `least`: a mask of bits, and these separations. B's normals are those of its faces,
/// its arcs on the Gauss map the opposite.
unsigned find_parting_edges(const ArcColumns& a, std::size_t i, const ArcColumns& b, std::size_t first,
                            float least, LaneTarget target, float* separations);

/// Eight segments from q along v, in lanes.
struct SegmentLanes {
  alignas(32) float q[3][kLaneCount];
  alignas(32) float v[3][kLaneCount];
};
/// The squared distances of these from the segment from p along u.
void find_square_distances(const Vec3f& p, const Vec3f& u, const SegmentLanes& segments, LaneTarget target,
                           float* squares);

}  // namespace rigor
