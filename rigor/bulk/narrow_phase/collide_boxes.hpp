#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <cstdint>

namespace rigor {

/// A pair of boxes, in the frame of body A's centre with axes of W: a row of lanes.
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

/// Where the eight pairs touch.
struct BoxContacts {
  enum Outcome : std::int32_t {
    apart,             ///< By more than the margin.
    region,            ///< Over a face.
    edges,             ///< An edge pair parts the boxes best.
    edges_and_region,  ///< As edges; but in the step boxes may come to lie on a face.
    near_edge          ///< The boxes are apart and nearest at an edge or corner of both.
  };
  alignas(32) std::int32_t outcome[kLaneCount];
  alignas(32) float separation[kLaneCount];
  alignas(32) float normal[3][kLaneCount];                          ///< From A to B; of the face.
  alignas(32) std::int32_t edge_A[kLaneCount], edge_B[kLaneCount];  ///< Axes of the edges.
  /// Not 0 if an edge pair parts the boxes best, touching or not.
  alignas(32) std::int32_t is_edge[kLaneCount];
  alignas(32) Manifold over_face[kLaneCount];  ///< If some of the pairs are not apart: of regions.
};

/// A face is kept where edges part two cores better by less than this part of their overlap and this part of
/// their thinnest half: it gives up to four points, edges give one.
constexpr float kFacePreferenceOfOverlap = 0.1f, kFacePreferenceOfSize = 0.02f;
/// Points of a region whose gaps differ by less than this part of the thinnest half are equally deep: of
/// eight corners of two squares four are chosen, and if they were others each time that the rest came a
/// little deeper, the boxes would rock for ever.
constexpr float kEqualDepthOfSize = 0.005f;

/// The separating axis test of two boxes (Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996), and where a
/// face parts them best, the region over it, reduced to four points as in make_manifold.
void collide_boxes(const BoxPairs& pairs, LaneTarget target, BoxContacts& contacts);

/// The axis that parts the boxes of pair `lane` best: unit, from A to B.
Vec3f box_axis(const BoxPairs& pairs, const BoxContacts& contacts, int lane);

/// The manifold of pair `lane`, whose outcome is edges; false if these do not cross between their ends.
bool cross_box_edges(const BoxPairs& pairs, const BoxContacts& contacts, int lane, Manifold& manifold);

}  // namespace rigor
