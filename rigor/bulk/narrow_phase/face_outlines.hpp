#pragma once

#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/core/index.hpp"

#include <span>
#include <vector>

namespace rigor {

/// A polygon of placed points, or a segment or a point; side k runs from corner k to the next one, the last
/// back to the first.
struct FaceOutline {
  LaneColumns points;
  std::span<const int> corners;  ///< Indices of its points.
  std::size_t side_count;        ///< 1 for a segment, 0 for a point.

  Vec3f corner(std::size_t k) const {
    const std::size_t i = at(corners[k]);
    return Vec3f(points.x[i], points.y[i], points.z[i]);
  }
  std::size_t next(std::size_t k) const { return k + 1 == corners.size() ? 0 : k + 1; }
};

/// The features of two outlines that meet, seen along the normal of the first, a face.
struct OutlineMeeting {
  /// A corner in coordinates of the face, from its first corner: x along its first side, y to the left.
  struct FlatPoint {
    float x, y;
  };
  /// A side of the face, from a corner along a unit vector.
  struct Border {
    float x, y, along_x, along_y, length;

    float inside(const FlatPoint& p) const { return along_x * (p.y - y) - along_y * (p.x - x); }
    float along(const FlatPoint& p) const { return along_x * (p.x - x) + along_y * (p.y - y); }
  };
  struct Crossing {
    std::size_t border, side;  ///< Of the face and of the other outline.
  };
  std::vector<Border> borders;
  std::vector<FlatPoint> other;    ///< Corners of the other outline; the first is repeated at the end.
  std::vector<float> inside;       ///< Distances of these corners inwards from each border [m].
  std::vector<std::size_t> over;   ///< Corners of the other outline that are over the face.
  std::vector<std::size_t> under;  ///< Corners of the face that are under the other polygon.
  std::vector<Crossing> crossings;
};

/// Finds where the outline of a face and another one meet. Corners count if they are outside by no more than
/// `slack`; crossings count only where the sides pass each other by more than that, so that no corner is lost
/// where sides coincide. The corners of the face run counter-clockwise about its normal; those of another
/// polygon run clockwise, as those of a face that faces it do.
void meet_outlines(const FaceOutline& face, const Vec3f& normal, const FaceOutline& other, float slack,
                   OutlineMeeting& meeting);

}  // namespace rigor
