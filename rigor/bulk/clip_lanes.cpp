#include "rigor/bulk/clip_lanes.hpp"

#include "rigor/bulk/lane_bits.hpp"

#include <algorithm>
#include <bit>

namespace rigor {

namespace {

RIGOR_FLOAT_LANES FloatVec3 spread(const Vec3f& n) {
  return {float_lanes(n.x()), float_lanes(n.y()), float_lanes(n.z())};
}

/// Eight borders of the face, of which `lanes` has a bit for each that is there; the others repeat the last.
struct BorderLanes {
  FloatVec3 corner, along, inward;  ///< Unit vectors.
  FloatLanes length;
  unsigned lanes;
};

RIGOR_FLOAT_LANES BorderLanes load_borders(std::span<const Vec3f> face, std::size_t first,
                                           const FloatVec3& normal) {
  float from[3][kLaneCount], to[3][kLaneCount];
  const std::size_t last = face.size() - 1;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const std::size_t k = std::min(first + i, last);
    const Vec3f &corner = face[k], &next = face[k == last ? 0 : k + 1];
    for (int c = 0; c < 3; ++c) {
      from[c][i] = corner[c];
      to[c][i] = next[c];
    }
  }
  BorderLanes borders;
  borders.corner = {load_floats(from[0]), load_floats(from[1]), load_floats(from[2])};
  const FloatVec3 side =
      FloatVec3{load_floats(to[0]), load_floats(to[1]), load_floats(to[2])} - borders.corner;
  borders.length = float_sqrt(dot(side, side));
  borders.along = {side.x / borders.length, side.y / borders.length, side.z / borders.length};
  borders.inward = cross(normal, borders.along);
  const std::size_t count = std::min<std::size_t>(kLaneCount, face.size() - first);
  borders.lanes = (1u << count) - 1;
  return borders;
}

/// A side of the other outline against the borders: from a corner at `way` from theirs, `along` to the next.
struct SideLanes {
  FloatVec3 way, along;
  FloatLanes from, to;  ///< How far the ends are inside.
};

/// Which borders it crosses between their ends, and where along itself.
RIGOR_FLOAT_LANES unsigned cross_borders(const BorderLanes& borders, const SideLanes& side, float slack,
                                         float* parts) {
  const FloatLanes inside = float_lanes(slack), outside = float_lanes(-slack);
  const IntLanes passes =
      (float_min(side.from, side.to) < outside) & (float_max(side.from, side.to) > inside);
  if (lane_bits(passes) == 0) return 0;
  const FloatLanes part = side.from / (side.from - side.to);
  const FloatLanes along = dot(borders.along, side.way + part * side.along);
  store_floats(part, parts);
  return lane_bits(passes & (along > inside) & (along < borders.length - inside)) & borders.lanes;
}

/// Corners of the face that are outside of a side by more than the slack.
RIGOR_FLOAT_LANES unsigned beyond_side(const SideLanes& side, const FloatVec3& normal, float slack) {
  const FloatVec3 inward = cross(side.along, normal);
  const FloatLanes beyond = dot(inward, side.way);
  return lane_bits((beyond > float_lanes(0)) &
                   (beyond * beyond > float_lanes(slack * slack) * dot(inward, inward)));
}

RIGOR_FLOAT_LANES void meeting_kernel(std::span<const Vec3f> face, const Vec3f& normal, const Outline& other,
                                      float slack, OutlineMeeting& meeting) {
  constexpr unsigned all = (1u << kLaneCount) - 1;
  const FloatVec3 n = spread(normal);
  const std::size_t corner_count = other.corners.size();
  float parts[kLaneCount];
  for (std::size_t first = 0; first < face.size(); first += kLaneCount) {
    const BorderLanes borders = load_borders(face, first, n);
    const FloatVec3 begin = spread(other.corners[0]) - borders.corner;
    const FloatLanes begin_inside = dot(borders.inward, begin);
    SideLanes side{begin, begin, begin_inside, begin_inside};
    unsigned beyond = 0;
    for (std::size_t j = 0; j < corner_count; ++j) {
      if (lane_bits(side.from >= float_lanes(-slack)) != all) meeting.is_over[j] = 0;
      if (j >= other.side_count) break;
      const bool is_last = j + 1 == corner_count;
      const FloatVec3 next = is_last ? begin : spread(other.corners[j + 1]) - borders.corner;
      side.along = next - side.way;
      side.to = is_last ? begin_inside : dot(borders.inward, next);
      beyond |= beyond_side(side, n, slack);
      unsigned bits = cross_borders(borders, side, slack, parts);
      for (; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        meeting.crossings.push_back({static_cast<int>(first) + lane, static_cast<int>(j), parts[lane]});
      }
      side.way = next;
      side.from = side.to;
    }
    for (unsigned bits = beyond & borders.lanes; bits != 0; bits &= bits - 1)
      meeting.is_covered[first + static_cast<std::size_t>(std::countr_zero(bits))] = 0;
  }
}

#if defined(__x86_64__)
#define RIGOR_AVX2 [[gnu::target("avx2")]]
#else
#define RIGOR_AVX2
#endif

RIGOR_AVX2 void meeting_avx2(std::span<const Vec3f> face, const Vec3f& normal, const Outline& other,
                             float slack, OutlineMeeting& meeting) {
  meeting_kernel(face, normal, other, slack, meeting);
}

}  // namespace

void meet_outlines(std::span<const Vec3f> face, const Vec3f& normal, const Outline& other, float slack,
                   LaneTarget target, OutlineMeeting& meeting) {
  meeting.is_over.assign(other.corners.size(), 1);
  meeting.is_covered.assign(face.size(), 1);
  meeting.crossings.clear();
  target == LaneTarget::avx2 ? meeting_avx2(face, normal, other, slack, meeting)
                             : meeting_kernel(face, normal, other, slack, meeting);
}

}  // namespace rigor
