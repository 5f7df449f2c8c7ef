#pragma once

// The separating axis test of eight pairs of boxes, in lanes. All functions are inlined into one for each
// target.

#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/bulk/narrow_phase/box_region_lanes.hpp"
#include "rigor/bulk/narrow_phase/collide_boxes.hpp"

#include <cstddef>
#include <limits>

namespace rigor {

/// Rotated boxes: their axes, along W's, their half extents and their centres.
struct BoxLanes {
  FloatVec3 axis[3];
  FloatLanes half[3];
  FloatVec3 p;
  FloatLanes extent;
};

RIGOR_FLOAT_LANES void load_boxes(const BoxPairs& pairs, const PlacedShape* BoxPairRow::*of,
                                  BoxLanes& boxes) {
  // A placed shape is two rows of eight floats: transposing eight of them makes lanes.
  FloatSquare first, second;
  for (int i = 0; i < kLaneCount; ++i) {
    const PlacedShape& placed = *(pairs.pair[i].*of);
    first.row[i] = load_floats(placed.R);
    second.row[i] = load_floats(placed.R + kLaneCount);
  }
  first = transpose(first);
  second = transpose(second);
  const FloatLanes* r = first.row;
  boxes.axis[0] = {r[0], r[3], r[6]};
  boxes.axis[1] = {r[1], r[4], r[7]};
  boxes.axis[2] = {r[2], r[5], second.row[0]};
  boxes.p = {second.row[1], second.row[2], second.row[3]};
  for (int k = 0; k < 3; ++k) boxes.half[k] = second.row[4 + k];
  boxes.extent = second.row[7];
}

/// The vectors between the bodies' centres, and the margins.
RIGOR_FLOAT_LANES void load_pairs(const BoxPairs& pairs, FloatVec3& bodies, FloatLanes& margin) {
  static_assert(sizeof(BoxPairRow) == sizeof(FloatLanes) && offsetof(BoxPairRow, d) == 4 * sizeof(float));
  FloatSquare square;
  for (int i = 0; i < kLaneCount; ++i) std::memcpy(&square.row[i], &pairs.pair[i], sizeof(FloatLanes));
  square = transpose(square);
  bodies = {square.row[4], square.row[5], square.row[6]};
  margin = square.row[7];
}

/// The best face of one box: t holds the coordinates of the other's centre, C the cosines between the axes.
struct BestFace {
  FloatLanes separation;
  IntLanes axis;
};
RIGOR_FLOAT_LANES void find_best_face(const FloatLanes* t, const FloatLanes (*C)[3], const FloatLanes* own,
                                      const FloatLanes* other, BestFace& best) {
  for (int i = 0; i < 3; ++i) {
    const FloatLanes reach =
        float_abs(C[i][0]) * other[0] + float_abs(C[i][1]) * other[1] + float_abs(C[i][2]) * other[2];
    // Along the axis i: the distance of the centres less how far either box reaches.
    const FloatLanes separation = float_abs(t[i]) - own[i] - reach;
    if (i == 0) {
      best.separation = separation;
      best.axis = int_lanes(0);
    } else {
      const IntLanes is_better = separation > best.separation;
      best.separation = is_better ? separation : best.separation;
      best.axis = is_better ? int_lanes(i) : best.axis;
    }
  }
}

/// The edges that separate the boxes by more than `least`, which becomes the best separation; their code is 3
/// i + j, or -1 if there are none. Separations are those along the rounded axis itself, so that no error of
/// nearly parallel edges makes them too large.
RIGOR_FLOAT_LANES void find_best_edges(const FloatLanes* t, const FloatLanes (*C)[3], const FloatLanes* own,
                                       const FloatLanes* other, FloatLanes& least, IntLanes& code) {
  constexpr float least_square_sine = 1e-8f;
  code = int_lanes(-1);
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      // The axis is e_i × f_j, in the coordinates of the own box: projections of the centre and of both boxes
      // on it.
      const FloatLanes c1 = C[i1][j], c2 = C[i2][j];
      const FloatLanes square = c1 * c1 + c2 * c2;
      const FloatLanes center = float_abs(t[i2] * c1 - t[i1] * c2);
      const FloatLanes reach = own[i1] * float_abs(c2) + own[i2] * float_abs(c1) +
                               other[j1] * float_abs(c1 * C[i2][j1] - c2 * C[i1][j1]) +
                               other[j2] * float_abs(c1 * C[i2][j2] - c2 * C[i1][j2]);
      // Its length is at most 1, so a negative height bounds the separation from above: most pairs of edges
      // need no root.
      const FloatLanes height = center - reach;
      const IntLanes may_be_better =
          (square > float_lanes(least_square_sine)) & ((height > least) | (height > float_lanes(0)));
      if (lane_bits(may_be_better) == 0) continue;
      const FloatLanes separation = height / float_sqrt(square);
      const IntLanes is_better = may_be_better & (separation > least);
      least = is_better ? separation : least;
      code = is_better ? int_lanes(3 * i + j) : code;
    }
  }
}

/// The thinnest half of two boxes [m].
RIGOR_FLOAT_LANES FloatLanes thinnest_half(const BoxLanes& a, const BoxLanes& b) {
  FloatLanes thinnest = float_min(a.half[0], b.half[0]);
  for (int k = 1; k < 3; ++k) thinnest = float_min(thinnest, float_min(a.half[k], b.half[k]));
  return thinnest;
}

/// By how much more than the best face a pair of edges has to separate the boxes [m]. A face gives up to four
/// points at once, edges give one, and boxes that lie flat on each other would rotate about it from step to
/// step.
RIGOR_FLOAT_LANES FloatLanes face_preference(const FloatLanes& thinnest, const FloatLanes& face_separation) {
  const FloatLanes overlap = float_max(-face_separation, float_lanes(0));
  return float_lanes(kFacePreferenceOfOverlap) * overlap + float_lanes(kFacePreferenceOfSize) * thinnest;
}

/// Normal from A to B of the k-th faces; t are the coordinates of B's centre from A's.
RIGOR_FLOAT_LANES FloatVec3 face_normal(const FloatLanes* t, const FloatVec3* axis, const IntLanes& k) {
  return sign_of(pick(k, t[0], t[1], t[2])) * pick(k, axis[0], axis[1], axis[2]);
}

RIGOR_FLOAT_LANES void collide_box_lanes(const BoxPairs& pairs, BoxContacts& contacts) {
  // Eight pairs into lanes; from here on everything is relative to the centre of body A.
  BoxLanes a, b;
  load_boxes(pairs, &BoxPairRow::a, a);
  load_boxes(pairs, &BoxPairRow::b, b);
  FloatVec3 bodies;
  FloatLanes margin;
  load_pairs(pairs, bodies, margin);
  const FloatVec3 p_B = bodies + b.p;
  const FloatVec3 d = p_B - a.p;
  const FloatLanes rounding =
      float_lanes(kCollisionRounding) * (a.extent + b.extent + float_sqrt(dot(bodies, bodies)));

  // Cosines between the axes, and the vector between the centres along the axes of either box.
  FloatLanes C[3][3], C_back[3][3], t_A[3], t_B[3];
  for (int i = 0; i < 3; ++i) {
    t_A[i] = dot(d, a.axis[i]);
    t_B[i] = dot(d, b.axis[i]);
    for (int j = 0; j < 3; ++j) C[i][j] = C_back[j][i] = dot(a.axis[i], b.axis[j]);
  }
  // The six face normals. The face of A is kept unless that of B is better by more than the rounding.
  BestFace face_A, face_B;
  find_best_face(t_A, C, a.half, b.half, face_A);
  find_best_face(t_B, C_back, b.half, a.half, face_B);
  const IntLanes is_B = face_B.separation > face_A.separation + rounding;
  const FloatLanes face_separation = is_B ? face_B.separation : face_A.separation;
  if (all_lanes(face_separation > margin)) {
    const FloatVec3 normal =
        pick(is_B, face_normal(t_B, b.axis, face_B.axis), face_normal(t_A, a.axis, face_A.axis));
    store_vector(normal, contacts.normal);
    store_ints(int_lanes(BoxContacts::apart), contacts.outcome);
    store_ints(int_lanes(0), contacts.is_edge);
    return;
  }
  // The nine edge pairs, which have to beat the best face by the rounding.
  FloatLanes separation = face_separation + rounding;
  IntLanes edge_code;
  find_best_edges(t_A, C, a.half, b.half, separation, edge_code);
  const IntLanes is_edge = edge_code >= int_lanes(0);
  separation = is_edge ? separation : face_separation;
  store_floats(separation, contacts.separation);
  store_ints(is_edge, contacts.is_edge);

  // The region over the best face, reduced to four points.
  BoxFace face;
  face.slack = float_lanes(4) * rounding;
  const FloatLanes thinnest = thinnest_half(a, b);
  face.preference = rounding + face_preference(thinnest, face_separation);
  face.equal_depth = rounding + float_lanes(kEqualDepthOfSize) * thinnest;
  face.separation = face_separation;
  face.axis = is_B ? face_B.axis : face_A.axis;
  complete_face(a.half, b.half, C, is_B, face);
  place_face(t_A, t_B, is_B, face);
  orient_face(a.axis, b.axis, a.p, p_B, is_B, face);
  clip_boxes(face, is_B, margin, contacts);

  // Edges are the manifold where they beat the face by the preference, or where no point of the region
  // explains the separation along the face's normal.
  const IntLanes is_crossing =
      is_edge & (~face.is_explained | (separation > face_separation + face.preference));
  // Bodies that come together fast may rotate about the one point of their edges onto a face within the step:
  // then the region is a second manifold.
  const IntLanes is_soon_flat = face.is_near & (separation < face_separation + margin);
  IntLanes outcome = face.is_explained ? int_lanes(BoxContacts::region) : int_lanes(BoxContacts::near_edge);
  outcome = is_crossing ? int_lanes(BoxContacts::edges) : outcome;
  outcome = is_crossing & is_soon_flat ? int_lanes(BoxContacts::edges_and_region) : outcome;
  outcome = separation > margin ? int_lanes(BoxContacts::apart) : outcome;
  store_ints(outcome, contacts.outcome);
  // The axes of the edges, from their code 3 i + j.
  const IntLanes edge_A = (edge_code >= int_lanes(6))   ? int_lanes(2)
                          : (edge_code >= int_lanes(3)) ? int_lanes(1)
                                                        : int_lanes(0);
  store_ints(edge_A, contacts.edge_A);
  store_ints(edge_code - int_lanes(3) * edge_A, contacts.edge_B);
}

}  // namespace rigor
