#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <cstdint>

namespace rigor {

/// A pair of boxes in the frame of body A's centre with the axes of W; it fills one row of lanes.
struct alignas(32) BoxPairRow {
  const PlacedShape *a, *b;
  float d[3];  ///< From the centre of body A to that of body B [m].
  float margin;

  Vec3f between() const { return Vec3f(d[0], d[1], d[2]); }
};
/// Eight of them.
struct BoxPairs {
  BoxPairRow pair[kLaneCount];
};

/// Outcomes of the test of eight pairs.
struct BoxContacts {
  enum Outcome : std::int32_t {
    apart,             ///< The boxes are farther apart than the margin.
    region,            ///< The manifold is the region over a face.
    edges,             ///< The manifold is the point where two edges cross.
    edges_and_region,  ///< As edges, but the boxes may rotate onto a face within the step.
    near_edge          ///< The boxes are apart and nearest at an edge or corner of both.
  };
  alignas(32) std::int32_t outcome[kLaneCount];
  alignas(32) float separation[kLaneCount];
  alignas(32) float normal[3][kLaneCount];                          ///< From A to B; of the face.
  alignas(32) std::int32_t edge_A[kLaneCount], edge_B[kLaneCount];  ///< Axes of the edges.
  /// Not 0 if an edge pair separates the boxes best, touching or not.
  alignas(32) std::int32_t is_edge[kLaneCount];
  alignas(32) Manifold over_face[kLaneCount];  ///< Regions; set unless all eight pairs are apart.
};

/// A face is kept where edges separate two cores by little more than it does: less than this part of their
/// overlap and this part of their thinnest half. A face gives up to four points, edges give one.
constexpr float kFacePreferenceOfOverlap = 0.1f, kFacePreferenceOfSize = 0.02f;
/// Points of a region whose gaps differ by less than this part of the thinnest half are equally deep. Of the
/// eight corners of two squares four are chosen; if the choice changed each time that the others came a
/// little deeper, the boxes would rock forever.
constexpr float kEqualDepthOfSize = 0.005f;

/// The separating axis test of eight pairs of boxes (Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996)
/// and, where a face separates them best, the region over it, reduced to four points as in make_manifold.
void collide_boxes(const BoxPairs& pairs, LaneTarget target, BoxContacts& contacts);

/// The axis that separates the boxes of pair `lane` best: unit, from A to B.
Vec3f box_axis(const BoxPairs& pairs, const BoxContacts& contacts, int lane);

/// The manifold of pair `lane`, whose outcome is edges; false if these do not cross between their ends.
bool cross_box_edges(const BoxPairs& pairs, const BoxContacts& contacts, int lane, Manifold& manifold);

}  // namespace rigor
