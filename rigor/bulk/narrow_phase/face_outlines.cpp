#include "rigor/bulk/narrow_phase/face_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

using FlatPoint = OutlineMeeting::FlatPoint;
using Border = OutlineMeeting::Border;

/// Coordinates in the plane of the face: unit vectors, and their origin.
struct FaceAxes {
  Vec3f origin, x, y;

  FlatPoint flat(const Vec3f& p) const {
    const Vec3f r = p - origin;
    return {x.dot(r), y.dot(r)};
  }
};

FaceAxes axes_of(const FaceOutline& face, const Vec3f& normal) {
  const Vec3f origin = face.corner(0), side = face.corner(1) - origin;
  const Vec3f x = (1 / side.norm()) * side;
  return {origin, x, normal.cross(x)};
}

void list_borders(const FaceOutline& face, const FaceAxes& axes, std::vector<Border>& borders) {
  const std::size_t count = face.corners.size();
  borders.resize(count);
  // Each corner is flattened once; the last border ends at the first.
  const FlatPoint first = axes.flat(face.corner(0));
  FlatPoint corner = first;
  for (std::size_t k = 0; k < count; ++k) {
    const FlatPoint next = k + 1 == count ? first : axes.flat(face.corner(k + 1));
    const float x = next.x - corner.x, y = next.y - corner.y, length = std::sqrt(x * x + y * y);
    const float inverse = 1 / length;
    borders[k] = {corner.x, corner.y, inverse * x, inverse * y, length};
    corner = next;
  }
}

void list_corners(const FaceOutline& other, const FaceAxes& axes, std::vector<FlatPoint>& corners) {
  const std::size_t count = other.corners.size();
  corners.resize(count + 1);
  for (std::size_t k = 0; k < count; ++k) corners[k] = axes.flat(other.corner(k));
  corners[count] = corners[0];
}

void find_corners_over(float slack, OutlineMeeting& meeting) {
  const std::size_t corner_count = meeting.other.size() - 1, stride = meeting.borders.size();
  meeting.inside.resize(stride * (corner_count + 1));
  meeting.over.clear();
  float* inside = meeting.inside.data();
  // A corner is over the face if it is inside all borders, up to the slack. The distances are kept for the
  // crossings.
  for (std::size_t k = 0; k < corner_count; ++k) {
    const FlatPoint corner = meeting.other[k];
    float least = std::numeric_limits<float>::infinity();
    for (const Border& border : meeting.borders) {
      *inside = border.inside(corner);
      least = std::min(least, *inside++);
    }
    if (least >= -slack) meeting.over.push_back(k);
  }
  std::copy_n(meeting.inside.data(), stride, inside);  // The first corner again: sides are closed.
}

void find_crossings(std::size_t side_count, float slack, OutlineMeeting& meeting) {
  const std::size_t stride = meeting.borders.size();
  const float* inside = meeting.inside.data();
  for (std::size_t side = 0; side < side_count; ++side) {
    const FlatPoint &from = meeting.other[side], &to = meeting.other[side + 1];
    for (std::size_t k = 0; k < stride; ++k, ++inside) {
      const float d0 = inside[0], d1 = inside[stride];
      if (std::min(d0, d1) >= -slack || std::max(d0, d1) <= slack) continue;
      // The side passes from one side of the border's line to the other; it counts if it meets the border
      // between its ends.
      const float part = d0 / (d0 - d1);
      const Border& border = meeting.borders[k];
      const float along = border.along({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
      if (along > slack && along < border.length - slack) meeting.crossings.push_back({k, side});
    }
  }
}

/// Whether a corner of the face is beyond no side of the other polygon by more than the slack.
bool is_under(const Border& corner, float slack, const std::vector<FlatPoint>& other) {
  for (std::size_t k = 0; k + 1 < other.size(); ++k) {
    const FlatPoint &from = other[k], &to = other[k + 1];
    const float x = to.x - from.x, y = to.y - from.y;
    // The other polygon runs clockwise: what is left of a side is outside.
    const float beyond = y * (from.x - corner.x) - x * (from.y - corner.y);
    if (beyond > 0 && beyond * beyond > slack * slack * (x * x + y * y)) return false;
  }
  return true;
}

}  // namespace

void meet_outlines(const FaceOutline& face, const Vec3f& normal, const FaceOutline& other, float slack,
                   OutlineMeeting& meeting) {
  // Both outlines in the plane of the face.
  const FaceAxes axes = axes_of(face, normal);
  list_borders(face, axes, meeting.borders);
  list_corners(other, axes, meeting.other);
  find_corners_over(slack, meeting);
  // Sides can cross only if a corner is not over the face.
  meeting.crossings.clear();
  if (meeting.over.size() < other.corners.size()) find_crossings(other.side_count, slack, meeting);
  // Corners of the face under the other outline, if that is a polygon.
  meeting.under.clear();
  if (other.side_count < 3) return;
  for (std::size_t k = 0; k < meeting.borders.size(); ++k)
    if (is_under(meeting.borders[k], slack, meeting.other)) meeting.under.push_back(k);
}

}  // namespace rigor
