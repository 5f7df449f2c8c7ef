#include "rigor/bulk/broad_phase/pair_lanes.hpp"

#include "rigor/bulk/lanes/lane_bits.hpp"

#include <cstddef>

namespace rigor {

namespace {

/// Eight floats of each of eight places, transposed.
template <class AddressOf>
RIGOR_FLOAT_LANES FloatSquare gather(const AddressOf& address_of) {
  FloatSquare rows;
  for (std::size_t i = 0; i < kLaneCount; ++i) rows.row[i] = load_floats(address_of(i));
  return transpose(rows);
}

RIGOR_FLOAT_LANES unsigned touching_kernel(const std::array<RoundBoxPair, kLaneCount>& pairs) {
  const FloatSquare a = gather([&](std::size_t i) { return pairs[i].a->lower; });
  const FloatSquare b = gather([&](std::size_t i) { return pairs[i].b->lower; });
  // As rounded_boxes_touch(): per axis how far the boxes are apart, and how far the smaller boxes inside are.
  FloatLanes radius;
  for (std::size_t i = 0; i < kLaneCount; ++i) radius[static_cast<int>(i)] = pairs[i].radius;
  const FloatLanes zero = float_lanes(0);
  FloatLanes squared = zero, most = zero;
  for (int k = 0; k < 3; ++k) {
    const FloatLanes apart = float_max(a.row[k] - b.row[3 + k], b.row[k] - a.row[3 + k]);
    const FloatLanes between = float_max(apart + radius, zero);
    squared += between * between;
    most = float_max(most, apart);
  }
  return lane_bits((most <= zero) & (squared <= radius * radius));
}

/// What the kernel needs of eight shapes and their places.
struct LanePlaces {
  FloatVec3 center, u, w;
  FloatLanes slack, reach, radius;
};

RIGOR_FLOAT_LANES LanePlaces load_places(const std::array<const ShapePlace*, kLaneCount>& places) {
  static_assert(offsetof(ShapePlace, slack) == 9 * sizeof(float) && sizeof(ShapePlace) >= 12 * sizeof(float));
  static_assert(offsetof(ShapeBound, reach) == 6 * sizeof(float) &&
                offsetof(ShapeBound, radius) == 7 * sizeof(float));
  // Three rows of eight floats hold all that the kernel needs of a place and its bound.
  const FloatSquare head = gather([&](std::size_t i) { return places[i]->center; });
  const FloatSquare tail = gather([&](std::size_t i) { return places[i]->u + 1; });
  const FloatSquare bound = gather([&](std::size_t i) { return places[i]->bound->center_B; });
  return {{head.row[0], head.row[1], head.row[2]},
          {head.row[3], head.row[4], head.row[5]},
          {head.row[6], head.row[7], tail.row[4]},
          tail.row[5],
          bound.row[6],
          bound.row[7]};
}

/// The margins of eight pairs; operations are in the order of find_pair_margin(), for the same bits.
RIGOR_FLOAT_LANES void margins_kernel(const std::array<ShapePlacePair, kLaneCount>& pairs, float step,
                                      float least, PairMargins& found) {
  std::array<const ShapePlace*, kLaneCount> small_places, large_places;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const bool is_a_large = pairs[i].b->bound->reach <= pairs[i].a->bound->reach;
    small_places[i] = is_a_large ? pairs[i].b : pairs[i].a;
    large_places[i] = is_a_large ? pairs[i].a : pairs[i].b;
  }
  // How far the small shape can come to the large one within the step, in the frame that moves with the large
  // one.
  const LanePlaces small = load_places(small_places), large = load_places(large_places);
  const FloatVec3 d = small.center - large.center;
  const FloatVec3 u = small.u - large.u - cross(large.w, d), w = small.w - large.w;
  const FloatLanes turning = float_sqrt(dot(w, w)) * small.reach;
  const FloatLanes margin = float_lanes(least) + float_lanes(step) * (float_sqrt(dot(u, u)) + turning);
  // Balls that are farther apart than that have no points.
  const FloatLanes near = small.reach + small.radius + large.radius + margin + small.slack + large.slack;
  const FloatLanes far = near + large.reach;
  store_floats(margin, found.margin);
  found.near = lane_bits(dot(d, d) <= far * far);
  found.asks_box = found.near & lane_bits(large.reach >= float_lanes(2) * (small.reach + small.radius));
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] unsigned touching_avx2(const std::array<RoundBoxPair, kLaneCount>& pairs) {
  return touching_kernel(pairs);
}
[[gnu::target("avx2")]] void margins_avx2(const std::array<ShapePlacePair, kLaneCount>& pairs, float step,
                                          float least, PairMargins& found) {
  margins_kernel(pairs, step, least, found);
}
#endif

}  // namespace

unsigned find_touching_boxes(const std::array<RoundBoxPair, kLaneCount>& pairs,
                             [[maybe_unused]] LaneTarget target) {
#if defined(__x86_64__)
  if (target == LaneTarget::avx2) return touching_avx2(pairs);
#endif
  return touching_kernel(pairs);
}

PairMargins find_pair_margins(const std::array<ShapePlacePair, kLaneCount>& pairs, float h, float margin,
                              [[maybe_unused]] LaneTarget target) {
  PairMargins found;
#if defined(__x86_64__)
  if (target == LaneTarget::avx2) {
    margins_avx2(pairs, h, margin, found);
    return found;
  }
#endif
  margins_kernel(pairs, h, margin, found);
  return found;
}

}  // namespace rigor
