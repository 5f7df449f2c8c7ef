#pragma once

// The names of the features that meet where two boxes touch.

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rigor {

constexpr std::size_t kBoxEdgeCount = 12;

/// Corners of the region of one face over another, in the order in which they are found.
struct RegionPlace {
  enum : int { corners_of_other = 0, corners_of_face = 4, crossings = 8, count = 24 };
};

/// Number of the edge along an axis through a vertex (sign bits, x lowest): as in FloatHulls::box.
constexpr int box_edge(int axis, int vertex) {
  const int low = vertex & ((1 << axis) - 1), high = vertex >> (axis + 1);
  return 4 * axis + (high << axis | low);
}

constexpr int bit_if(bool is_set, int axis) {
  return is_set ? 1 << axis : 0;
}

/// Which faces a region is of.
struct RegionFaces {
  int face;   ///< Axis of the face; + 3 if it is B's.
  int other;  ///< Axis of the other box's face.
  int signs;  ///< Bit 0: the face is on the negative side; 1: the other.
};

/// Feature of a corner of the region, by the order in which clip_boxes finds them.
constexpr std::uint32_t region_feature(const RegionFaces& faces, int place) {
  // Axes of the two boxes, each from the normal of its face on: z, x, y and w, u, v. The sign bits of the
  // faces are set in all vertices on them.
  const bool is_B = faces.face >= 3;
  const int z = is_B ? faces.face - 3 : faces.face, x = (z + 1) % 3, y = (z + 2) % 3;
  const int w = faces.other, u = (w + 1) % 3, v = (w + 2) % 3;
  const int own_face = bit_if((faces.signs & 1) == 0, z);
  const int other_face = bit_if((faces.signs & 2) == 0, w);
  const bool first = (place & 1) != 0, second = (place & 2) != 0;
  // A corner of the other face over the face.
  if (place < RegionPlace::corners_of_face) {
    const int vertex = other_face | bit_if(first, u) | bit_if(second, v);
    return is_B ? vertex_A_feature(vertex) : vertex_B_feature(vertex);
  }
  // A corner of the face under the other face.
  if (place < RegionPlace::crossings) {
    const int vertex = own_face | bit_if(first, x) | bit_if(second, y);
    return is_B ? vertex_B_feature(vertex) : vertex_A_feature(vertex);
  }
  // The bits of a crossing's place: which of the other face's sides (8), whether these run along v (4),
  // whether the line of the face is along x (2), and which of its two lines it is (1).
  const int code = place - RegionPlace::crossings;
  const bool is_along_v = (code & 4) != 0, is_far = (code & 8) != 0;
  const int other_edge = box_edge(is_along_v ? v : u, other_face | bit_if(is_far, is_along_v ? u : v));
  const int own_edge = box_edge(second ? x : y, own_face | bit_if(first, second ? y : x));
  return is_B ? crossing_feature(other_edge, own_edge, kBoxEdgeCount)
              : crossing_feature(own_edge, other_edge, kBoxEdgeCount);
}

/// The features of all places of all faces.
using FeatureRow = std::array<std::uint32_t, RegionPlace::count>;
constexpr std::size_t feature_row(const RegionFaces& faces) {
  return at((faces.face * 3 + faces.other) * 4 + faces.signs);
}
constexpr std::array<FeatureRow, 6 * 3 * 4> make_feature_rows() {
  std::array<FeatureRow, 6 * 3 * 4> rows{};
  for (int face = 0; face < 6; ++face)
    for (int other = 0; other < 3; ++other)
      for (int signs = 0; signs < 4; ++signs)
        for (int place = 0; place < RegionPlace::count; ++place)
          rows[feature_row({face, other, signs})][at(place)] = region_feature({face, other, signs}, place);
  return rows;
}
inline constexpr std::array<FeatureRow, 6 * 3 * 4> kFeatureRows = make_feature_rows();

}  // namespace rigor
