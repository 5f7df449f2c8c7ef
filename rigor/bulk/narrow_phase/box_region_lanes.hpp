#pragma once

// The region of one box over a face of another, for eight pairs, in lanes: its corners, and the four of them
// that make the manifold.

#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/bulk/narrow_phase/box_features.hpp"
#include "rigor/bulk/narrow_phase/collide_boxes.hpp"

#include <limits>
#include <span>

namespace rigor {

RIGOR_FLOAT_LANES IntLanes int_lanes(std::int32_t i) {
  return IntLanes{i, i, i, i, i, i, i, i};
}
RIGOR_FLOAT_LANES void store_ints(const IntLanes& x, std::int32_t* p) {
  std::memcpy(p, &x, sizeof x);
}
RIGOR_FLOAT_LANES void store_vector(const FloatVec3& a, float (*p)[kLaneCount]) {
  store_floats(a.x, p[0]);
  store_floats(a.y, p[1]);
  store_floats(a.z, p[2]);
}
RIGOR_FLOAT_LANES FloatLanes float_abs(const FloatLanes& x) {
  return float_max(x, -x);
}
RIGOR_FLOAT_LANES bool all_lanes(const IntLanes& mask) {
  return lane_bits(mask) == (1u << kLaneCount) - 1;
}
/// The k-th of three.
RIGOR_FLOAT_LANES FloatLanes pick(const IntLanes& k, const FloatLanes& x0, const FloatLanes& x1,
                                  const FloatLanes& x2) {
  const FloatLanes x = k == int_lanes(1) ? x1 : x0;
  return k == int_lanes(2) ? x2 : x;
}
RIGOR_FLOAT_LANES FloatVec3 pick(const IntLanes& k, const FloatVec3& a0, const FloatVec3& a1,
                                 const FloatVec3& a2) {
  return {pick(k, a0.x, a1.x, a2.x), pick(k, a0.y, a1.y, a2.y), pick(k, a0.z, a1.z, a2.z)};
}
RIGOR_FLOAT_LANES FloatVec3 pick(const IntLanes& mask, const FloatVec3& if_true, const FloatVec3& if_false) {
  return {mask ? if_true.x : if_false.x, mask ? if_true.y : if_false.y, mask ? if_true.z : if_false.z};
}
/// -1 where negative, else 1.
RIGOR_FLOAT_LANES FloatLanes sign_of(const FloatLanes& x) {
  return x < float_lanes(0) ? float_lanes(-1) : float_lanes(1);
}

/// A face of one box and the face of the other that faces it.
struct BoxFace {
  FloatLanes slack, separation;
  FloatLanes preference;   ///< For a face instead of edges [m].
  FloatLanes equal_depth;  ///< Corners whose gaps differ by less are equally deep [m].
  IntLanes axis, other_axis;
  FloatLanes sign, other_sign;   ///< -1 on the negative side of its box.
  FloatLanes hx, hy, hz;         ///< Half extents of the box of the face.
  FloatLanes hu, hv;             ///< Half extents of the other face.
  FloatVec3 other[3];            ///< Half axes of the other box, in the coordinates of its own box's axes.
  FloatVec3 c, u, v;             ///< The other face: middle and half sides.
  FloatVec3 middle, ex, ey, ez;  ///< The coordinates in O.
  FloatLanes to_B;               ///< 1 if the face is A's, else -1.
  IntLanes is_explained;         ///< The least gap of the region is the separation, but for the preference.
  IntLanes is_near;              ///< The region has a point within the margin.
};

/// Fills in the axes of the face, whose own axis is known, and the half axes of the other box; C holds the
/// cosines between the axes of A and those of B.
RIGOR_FLOAT_LANES void complete_face(const FloatLanes* half_A, const FloatLanes* half_B,
                                     const FloatLanes (*C)[3], const IntLanes& is_B, BoxFace& face) {
  face.to_B = is_B ? float_lanes(-1) : float_lanes(1);
  // Half extents of the owner of the face and of the other box, in either order of the bodies.
  FloatLanes own[3], other[3];
  for (int k = 0; k < 3; ++k) {
    own[k] = is_B ? half_B[k] : half_A[k];
    other[k] = is_B ? half_A[k] : half_B[k];
  }
  // Coordinates of the face are those of its box, rotated cyclically so that z is the normal.
  face.hz = pick(face.axis, own[0], own[1], own[2]);
  face.hx = pick(face.axis, own[1], own[2], own[0]);
  face.hy = pick(face.axis, own[2], own[0], own[1]);
  // Half axes of the other box in these coordinates.
  for (int j = 0; j < 3; ++j) {
    FloatLanes along[3];
    for (int i = 0; i < 3; ++i) along[i] = is_B ? C[j][i] : C[i][j];
    face.other[j].z = other[j] * pick(face.axis, along[0], along[1], along[2]);
    face.other[j].x = other[j] * pick(face.axis, along[1], along[2], along[0]);
    face.other[j].y = other[j] * pick(face.axis, along[2], along[0], along[1]);
  }
  // The axis of the other box's face is the one most along the normal.
  FloatLanes most = float_lanes(-1);
  face.other_axis = int_lanes(0);
  for (int j = 0; j < 3; ++j) {
    const FloatLanes cosine = float_abs(face.other[j].z) / other[j];
    const IntLanes is_more = cosine > most;
    most = is_more ? cosine : most;
    face.other_axis = is_more ? int_lanes(j) : face.other_axis;
  }
  face.hu = pick(face.other_axis, other[1], other[2], other[0]);
  face.hv = pick(face.other_axis, other[2], other[0], other[1]);
}

/// Places the other face in the coordinates of the face; t_A and t_B hold the vector from the centre of A to
/// that of B along the axes of A and of B.
RIGOR_FLOAT_LANES void place_face(const FloatLanes* t_A, const FloatLanes* t_B, const IntLanes& is_B,
                                  BoxFace& face) {
  // The centre of the other box; z is flipped so that the face is on the positive side, and counted from it.
  FloatLanes t[3];
  for (int k = 0; k < 3; ++k) t[k] = is_B ? -t_B[k] : t_A[k];
  face.c.z = pick(face.axis, t[0], t[1], t[2]);
  face.c.x = pick(face.axis, t[1], t[2], t[0]);
  face.c.y = pick(face.axis, t[2], t[0], t[1]);
  face.sign = sign_of(face.c.z);
  face.c.z = face.sign * face.c.z - face.hz;
  for (int j = 0; j < 3; ++j) face.other[j].z = face.sign * face.other[j].z;
  // From that centre to the middle of the other face, which is on the side towards the face.
  const FloatVec3* f = face.other;
  const FloatVec3 w = pick(face.other_axis, f[0], f[1], f[2]);
  face.u = pick(face.other_axis, f[1], f[2], f[0]);
  face.v = pick(face.other_axis, f[2], f[0], f[1]);
  face.other_sign = -sign_of(w.z);
  face.c = face.c + face.other_sign * w;
}

RIGOR_FLOAT_LANES void orient_face(const FloatVec3* axis_A, const FloatVec3* axis_B, const FloatVec3& p_A,
                                   const FloatVec3& p_B, const IntLanes& is_B, BoxFace& face) {
  FloatVec3 axis[3];
  for (int k = 0; k < 3; ++k) axis[k] = pick(is_B, axis_B[k], axis_A[k]);
  face.ez = face.sign * pick(face.axis, axis[0], axis[1], axis[2]);
  face.ex = pick(face.axis, axis[1], axis[2], axis[0]);
  face.ey = pick(face.axis, axis[2], axis[0], axis[1]);
  face.middle = pick(is_B, p_B, p_A) + face.hz * face.ez;
}

/// A corner that the region of at least one lane has; in the lanes that do not have it, x is not a number and
/// z is infinite.
struct RegionCorner {
  FloatLanes x, y, z;
  IntLanes place;
};

/// The corners of the region within the margin, in the order of their places.
struct RegionCorners {
  FloatLanes margin;
  FloatLanes least;  ///< Least height of all corners, within the margin or not; infinite if there are none.
  int count = 0;
  RegionCorner corners[RegionPlace::count];

  std::span<const RegionCorner> listed() const { return {corners, static_cast<std::size_t>(count)}; }
};

/// Adds a corner. There is no branch, since which lane has which corner follows no pattern.
RIGOR_FLOAT_LANES void add_corner(const FloatVec3& p, const IntLanes& is_there, int place,
                                  RegionCorners& region) {
  const FloatLanes none = float_lanes(std::numeric_limits<float>::infinity());
  const FloatLanes z = is_there ? p.z : none;
  region.least = float_min(region.least, z);
  // Corners beyond the margin tell the least height and nothing else. A corner that no lane has is
  // overwritten by the next one.
  const IntLanes counts = z <= region.margin;
  RegionCorner& corner = region.corners[region.count];
  corner.x = counts ? p.x : float_lanes(std::numeric_limits<float>::quiet_NaN());
  corner.y = p.y;
  corner.z = counts ? p.z : none;
  corner.place = int_lanes(place);
  region.count += lane_bits(counts) == 0 ? 0 : 1;
}

/// Adds the corners of either face that lie over the other one, up to the slack.
RIGOR_FLOAT_LANES void find_region_corners(const BoxFace& face, RegionCorners& region) {
  // Corners of the other face over this one.
  const FloatLanes one = float_lanes(1), reach_x = face.hx + face.slack, reach_y = face.hy + face.slack;
  for (int k = 0; k < 4; ++k) {
    const FloatLanes su = float_lanes(k & 1 ? 1.0f : -1.0f), sv = float_lanes(k & 2 ? 1.0f : -1.0f);
    const FloatVec3 p = face.c + su * face.u + sv * face.v;
    add_corner(p, (float_abs(p.x) <= reach_x) & (float_abs(p.y) <= reach_y),
               RegionPlace::corners_of_other + k, region);
  }
  // Corners of this face over the other one, a parallelogram c + s u + t v with |s|, |t| <= 1.
  const FloatLanes reach_u = one + float_lanes(2) * face.slack / face.hu;
  const FloatLanes reach_v = one + float_lanes(2) * face.slack / face.hv;
  const FloatLanes scale = one / (face.u.x * face.v.y - face.u.y * face.v.x);
  for (int k = 0; k < 4; ++k) {
    // Seen along z, the corner of the face is c + s u + t v: solve for s and t by Cramer's rule.
    const FloatLanes x = float_lanes(k & 1 ? 1.0f : -1.0f) * face.hx,
                     y = float_lanes(k & 2 ? 1.0f : -1.0f) * face.hy;
    const FloatLanes dx = x - face.c.x, dy = y - face.c.y;
    const FloatLanes s = (dx * face.v.y - dy * face.v.x) * scale, t = (face.u.x * dy - face.u.y * dx) * scale;
    add_corner({x, y, face.c.z + s * face.u.z + t * face.v.z},
               (float_abs(s) <= reach_u) & (float_abs(t) <= reach_v), RegionPlace::corners_of_face + k,
               region);
  }
}

/// A side of the other face: from p - u to p + u.
struct RegionSide {
  FloatVec3 p, u;
  FloatLanes half_length;
};
/// Adds the points where a side crosses the lines x = ±hx (or, if not is_along_x, y = ±hy).
RIGOR_FLOAT_LANES void cross_side(const BoxFace& face, const RegionSide& side, bool is_along_x, int place,
                                  RegionCorners& region) {
  const FloatVec3 &p = side.p, &u = side.u;
  const FloatLanes one = float_lanes(1);
  // A side that is nearly parallel to the lines crosses neither of them: no corner would be lost.
  const FloatLanes start = is_along_x ? p.x : p.y, step = is_along_x ? u.x : u.y;
  const IntLanes is_steep = float_abs(step) > face.slack;
  if (lane_bits(is_steep) == 0) return;
  // A crossing counts if it is inside both the border and the side by more than the slack; on their ends it
  // is a corner already.
  const FloatLanes across = is_along_x ? p.y : p.x, slope = is_along_x ? u.y : u.x;
  const FloatLanes line = is_along_x ? face.hx : face.hy;
  const FloatLanes reach = (is_along_x ? face.hy : face.hx) - face.slack;
  const FloatLanes inverse = one / step, reach_t = one - face.slack / side.half_length;
  for (int k = 0; k < 2; ++k) {
    const FloatLanes at_line = k == 0 ? -line : line;
    const FloatLanes t = (at_line - start) * inverse, at = across + t * slope;
    add_corner({is_along_x ? at_line : at, is_along_x ? at : at_line, p.z + t * u.z},
               is_steep & (float_abs(t) < reach_t) & (float_abs(at) < reach), place + k, region);
  }
}

RIGOR_FLOAT_LANES void find_region_crossings(const BoxFace& face, RegionCorners& region) {
  for (int k = 0; k < 2; ++k) {
    const FloatLanes s = float_lanes(k == 0 ? -1.0f : 1.0f);
    const int place = RegionPlace::crossings + 8 * k;
    // The sides of the other face at -v, +v and at -u, +u.
    const RegionSide along_u{face.c + s * face.v, face.u, face.hu};
    const RegionSide along_v{face.c + s * face.u, face.v, face.hv};
    cross_side(face, along_u, true, place, region);
    cross_side(face, along_u, false, place + 2, region);
    cross_side(face, along_v, true, place + 4, region);
    cross_side(face, along_v, false, place + 6, region);
  }
}

/// One of the corners in each lane; place -1: none.
struct ChosenCorner {
  FloatLanes x, y, z;
  IntLanes place;
  FloatLanes needed;  ///< The measure that a better one must exceed.
};
/// A later corner must be better by this factor.
constexpr float kClearlyBetter = 1.0001f;
/// Takes the corner in the lanes where its measure exceeds what a better one needs. The measure of a corner
/// that does not count is not a number, and so never does.
RIGOR_FLOAT_LANES void choose_clearly(const FloatLanes& measure, const RegionCorner& corner,
                                      ChosenCorner& best) {
  const IntLanes is_better = measure > best.needed;
  best.x = is_better ? corner.x : best.x;
  best.y = is_better ? corner.y : best.y;
  best.z = is_better ? corner.z : best.z;
  best.place = is_better ? corner.place : best.place;
  best.needed = is_better ? float_lanes(kClearlyBetter) * measure : best.needed;
}

/// Twice the area of the triangle of a, b and a corner, positive to the left of a -> b.
RIGOR_FLOAT_LANES FloatLanes area_with(const ChosenCorner& a, const ChosenCorner& b,
                                       const RegionCorner& corner) {
  return (b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x);
}

/// Chooses a deepest corner, the farthest from it, and two that span the largest area with them. A corner
/// that is closer than the slack to those chosen does not count as one of its own.
RIGOR_FLOAT_LANES void choose_corners(const BoxFace& face, const RegionCorners& region,
                                      ChosenCorner* chosen) {
  const FloatLanes zero = float_lanes(0), equal = region.least + face.equal_depth;
  // The first of the deepest: going backwards, the last one taken is the first in order.
  ChosenCorner a{zero, zero, zero, int_lanes(-1), zero};
  for (int k = region.count - 1; k >= 0; --k) {
    const RegionCorner& corner = region.corners[k];
    const IntLanes is_deepest = corner.z <= equal;
    a.x = is_deepest ? corner.x : a.x;
    a.y = is_deepest ? corner.y : a.y;
    a.z = is_deepest ? corner.z : a.z;
    a.place = is_deepest ? corner.place : a.place;
  }
  // The farthest from it.
  ChosenCorner b{a.x, a.y, a.z, int_lanes(-1), float_lanes(kClearlyBetter) * (face.slack * face.slack)};
  for (const RegionCorner& corner : region.listed()) {
    const FloatLanes dx = corner.x - a.x, dy = corner.y - a.y;
    choose_clearly(dx * dx + dy * dy, corner, b);
  }
  // The one that makes the largest triangle with them, on either side.
  const FloatLanes dx = b.x - a.x, dy = b.y - a.y;
  const FloatLanes least_area = float_lanes(kClearlyBetter) * (face.slack * (float_abs(dx) + float_abs(dy)));
  ChosenCorner c{a.x, a.y, a.z, int_lanes(-1), least_area};
  for (const RegionCorner& corner : region.listed())
    choose_clearly(float_abs(area_with(a, b, corner)), corner, c);
  // The one that adds most to the triangle: the farthest beyond one of its sides.
  const FloatLanes turn = sign_of((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  ChosenCorner d{a.x, a.y, a.z, int_lanes(-1), least_area};
  for (const RegionCorner& corner : region.listed()) {
    const FloatLanes beyond =
        float_max(float_max(-turn * area_with(a, b, corner), -turn * area_with(b, c, corner)),
                  -turn * area_with(c, a, corner));
    choose_clearly(beyond, corner, d);
  }
  chosen[0] = a;
  chosen[1] = b;
  chosen[2] = c;
  chosen[3] = d;
}

/// A point of eight manifolds. Features are shifted so that they have the order of signed numbers; "no point"
/// comes last.
struct RegionPoint {
  FloatVec3 p;
  FloatLanes gap;
  IntLanes feature;
};
constexpr std::int32_t kNoFeature = std::numeric_limits<std::int32_t>::max(),
                       kFeatureShift = std::numeric_limits<std::int32_t>::min();

RIGOR_FLOAT_LANES void set_in_order(RegionPoint& first, RegionPoint& second) {
  // Exchanges the two points in the lanes where they are out of order.
  const IntLanes is_later = first.feature > second.feature;
  const auto exchange = [&](auto& a, auto& b) __attribute__((always_inline)) {
    const auto lower = is_later ? b : a;
    b = is_later ? a : b;
    a = lower;
  };
  exchange(first.p.x, second.p.x);
  exchange(first.p.y, second.p.y);
  exchange(first.p.z, second.p.z);
  exchange(first.gap, second.gap);
  exchange(first.feature, second.feature);
}

/// The features of corners, by their places; `rows` are the rows of their faces in kFeatureRows.
RIGOR_FLOAT_LANES IntLanes features_of(const IntLanes& rows, const IntLanes& places) {
  // Table look-ups, lane by lane.
  std::int32_t row[kLaneCount], place[kLaneCount], feature[kLaneCount];
  std::memcpy(row, &rows, sizeof row);
  std::memcpy(place, &places, sizeof place);
  for (int i = 0; i < kLaneCount; ++i)
    feature[i] =
        place[i] < 0
            ? kNoFeature
            : static_cast<std::int32_t>(
                  kFeatureRows[static_cast<std::size_t>(row[i])][static_cast<std::size_t>(place[i])]) ^
                  kFeatureShift;
  IntLanes features;
  std::memcpy(&features, feature, sizeof features);
  return features;
}

RIGOR_FLOAT_LANES FloatLanes bits_as_floats(const IntLanes& x) {
  FloatLanes y;
  std::memcpy(&y, &x, sizeof y);
  return y;
}

/// Stores the manifolds of the chosen corners, their points in the order of their features.
RIGOR_FLOAT_LANES void store_manifolds(const BoxFace& face, const IntLanes& is_B, const FloatVec3& normal,
                                       const ChosenCorner* chosen, Manifold* manifolds) {
  constexpr int rows = 3, words = rows * kLaneCount;
  static_assert(sizeof(Manifold) == words * sizeof(float));
  // The row of the pair of faces in the table of features.
  const IntLanes zero = int_lanes(0), one = int_lanes(1);
  const IntLanes signs =
      (face.sign < float_lanes(0) ? one : zero) | (face.other_sign < float_lanes(0) ? int_lanes(2) : zero);
  const IntLanes of_B = is_B ? int_lanes(3) : zero;
  const IntLanes feature_rows = int_lanes(4) * (int_lanes(3) * (face.axis + of_B) + face.other_axis) + signs;
  // The points, from the coordinates of the face back into O, midway between the boxes.
  RegionPoint points[Manifold::max_points];
  IntLanes count = zero;
  for (int k = 0; k < Manifold::max_points; ++k) {
    const ChosenCorner& c = chosen[k];
    points[k].p = face.middle + c.x * face.ex + c.y * face.ey + (float_lanes(0.5f) * c.z) * face.ez;
    points[k].gap = c.z;
    points[k].feature = features_of(feature_rows, c.place);
    count += c.place < zero ? zero : one;
  }
  // A sorting network of four brings them into the order of their features.
  set_in_order(points[0], points[1]);
  set_in_order(points[2], points[3]);
  set_in_order(points[0], points[2]);
  set_in_order(points[1], points[3]);
  set_in_order(points[1], points[2]);
  // A manifold is 24 words: three squares of lanes.
  FloatLanes word[words] = {normal.x, normal.y, normal.z, bits_as_floats(count)};
  for (int k = 0; k < Manifold::max_points; ++k) {
    FloatLanes* const point = word + 4 + 5 * k;
    point[0] = points[k].p.x;
    point[1] = points[k].p.y;
    point[2] = points[k].p.z;
    point[3] = points[k].gap;
    point[4] = bits_as_floats(points[k].feature ^ int_lanes(kFeatureShift));
  }
  for (int r = 0; r < rows; ++r) {
    FloatSquare square;
    for (int i = 0; i < kLaneCount; ++i) square.row[i] = word[r * kLaneCount + i];
    square = transpose(square);
    for (int i = 0; i < kLaneCount; ++i)
      std::memcpy(reinterpret_cast<char*>(manifolds + i) + static_cast<std::size_t>(r) * sizeof(FloatLanes),
                  &square.row[i], sizeof(FloatLanes));
  }
}

RIGOR_FLOAT_LANES void clip_boxes(BoxFace& face, const IntLanes& is_B, const FloatLanes& margin,
                                  BoxContacts& contacts) {
  RegionCorners region;
  region.margin = margin;
  region.least = float_lanes(std::numeric_limits<float>::infinity());
  find_region_corners(face, region);
  find_region_crossings(face, region);
  // The separation along the normal is explained if the region has a point about as deep; else an edge or a
  // corner beside the face is nearest.
  face.is_near = region.least <= margin;
  face.is_explained = region.least <= face.separation + face.preference + face.slack;
  ChosenCorner chosen[Manifold::max_points];
  choose_corners(face, region, chosen);
  const FloatVec3 normal = face.to_B * face.ez;
  store_vector(normal, contacts.normal);
  store_manifolds(face, is_B, normal, chosen, contacts.over_face);
}

}  // namespace rigor
