#pragma once

#include "rigor/bulk/bulk_shape.hpp"
#include "rigor/bulk/float_lanes.hpp"
#include "rigor/bulk/manifold.hpp"
#include "rigor/geometry/lane_target.hpp"

#include <cstdint>

namespace rigor {

/// Eight pairs of boxes, in the frame of body A's centre with axes of W.
struct BoxPairs {
  const PlacedShape* a[kLaneCount];
  const PlacedShape* b[kLaneCount];
  alignas(32) float d[3][kLaneCount];  ///< From the centre of body A to that of body B [m].
  alignas(32) float margin[kLaneCount];
};

/// Where the eight pairs touch.
struct BoxContacts {
  enum Outcome : std::int32_t {
    apart,             ///< By more than the margin.
    region,            ///< Over a face: the points are here.
    edges,             ///< An edge pair parts the boxes best.
    edges_and_region,  ///< As edges; but in the step boxes may come to lie on a face: the points are here
                       ///< too.
    near_edge          ///< The boxes are apart and nearest at an edge or corner of both.
  };
  /// Corners of the region, by the classes in which they were found.
  enum Class : std::int32_t { corner_of_other = 0, corner_of_face = 4, crossing = 8, class_count = 24 };

  alignas(32) std::int32_t outcome[kLaneCount];
  alignas(32) float separation[kLaneCount];
  alignas(32) float normal[3][kLaneCount];                          ///< From A to B; of the face.
  alignas(32) std::int32_t face[kLaneCount];                        ///< Axis of the face; + 3 if it is B's.
  alignas(32) std::int32_t other[kLaneCount];                       ///< Axis of the other box's face.
  alignas(32) std::int32_t edge_A[kLaneCount], edge_B[kLaneCount];  ///< Axes of the edges.
  alignas(
      32) std::int32_t is_edge[kLaneCount];  ///< Not 0 if an edge pair parts the boxes best, touching or not.
  alignas(32) std::int32_t signs[kLaneCount];  ///< Bit 0: the face is on the negative side; 1: the other.
  alignas(32) float p[4][3][kLaneCount];       ///< As in a Manifold.
  alignas(32) float gap[4][kLaneCount];
  alignas(32) std::int32_t place[4][kLaneCount];  ///< Which corner of the region, or -1 for none.
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

/// The manifold of pair `lane`, whose outcome is a region; false if no point is within the margin.
bool read_box_region(const BoxContacts& contacts, int lane, float margin, Manifold& manifold);

/// The axis that parts the boxes of pair `lane` best: unit, from A to B.
Vec3f box_axis(const BoxPairs& pairs, const BoxContacts& contacts, int lane);

/// The manifold of pair `lane`, whose outcome is edges; false if these do not cross between their ends.
bool cross_box_edges(const BoxPairs& pairs, const BoxContacts& contacts, int lane, Manifold& manifold);

}  // namespace rigor
