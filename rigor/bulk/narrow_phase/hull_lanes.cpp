#include "rigor/bulk/narrow_phase/hull_lanes.hpp"

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace rigor {

namespace {

/// The same vector in all lanes.
RIGOR_FLOAT_LANES FloatVec3 spread(const Vec3f& n) {
  return {float_lanes(n.x()), float_lanes(n.y()), float_lanes(n.z())};
}
RIGOR_FLOAT_LANES FloatLanes heights_at(const LaneColumns& points, const FloatVec3& n, std::size_t k) {
  return n.x * load_floats(points.x + k) + n.y * load_floats(points.y + k) + n.z * load_floats(points.z + k);
}

/// First how high the highest point is, then which one it is: two short chains of dependent operations
/// instead of a long one.
RIGOR_FLOAT_LANES Support support_kernel(const LaneColumns& points, const Vec3f& n) {
  constexpr std::size_t block_count = 8, mask_size = block_count * kLaneCount;
  const FloatVec3 direction = spread(n);
  Support best{0, -std::numeric_limits<float>::infinity()};
  for (std::size_t first = 0; first < points.count; first += mask_size) {
    const std::size_t blocks = std::min(block_count, (points.count - first) / kLaneCount);
    // The largest height of up to 64 points.
    FloatLanes heights[block_count], highest = heights_at(points, direction, first);
    heights[0] = highest;
    for (std::size_t k = 1; k < blocks; ++k) {
      heights[k] = heights_at(points, direction, first + k * kLaneCount);
      highest = float_max(highest, heights[k]);
    }
    const FloatLanes top = spread_max(highest);
    if (!(top[0] > best.height)) continue;
    // The first point of that height; later points of the same height do not replace it.
    std::uint64_t is_top = 0;
    for (std::size_t k = 0; k < blocks; ++k)
      is_top |= std::uint64_t{lane_bits(heights[k] == top)} << (k * kLaneCount);
    best = {static_cast<int>(first) + std::countr_zero(is_top), top[0]};
  }
  return best;
}

RIGOR_FLOAT_LANES SupportSet support_set_kernel(const LaneColumns& points, int count, const Vec3f& n,
                                                float drop) {
  // The largest height of all points.
  const FloatVec3 direction = spread(n);
  FloatLanes highest = heights_at(points, direction, 0);
  for (std::size_t k = kLaneCount; k < points.count; k += kLaneCount)
    highest = float_max(highest, heights_at(points, direction, k));
  const FloatLanes top = spread_max(highest), least = top - float_lanes(drop);
  // How many points are lower by no more than the drop.
  SupportSet set{top[0], 0};
  for (std::size_t k = 0; k < points.count; k += kLaneCount) {
    unsigned bits = lane_bits(heights_at(points, direction, k) >= least);
    // The padding of the columns does not count.
    const int left = count - static_cast<int>(k);
    if (left < kLaneCount) bits &= (1u << left) - 1;
    set.count += std::popcount(bits);
  }
  return set;
}

RIGOR_FLOAT_LANES void heights_kernel(const LaneColumns& points, const Vec3f& n, const float* offsets,
                                      float* heights) {
  const FloatVec3 direction = spread(n);
  for (std::size_t k = 0; k < points.count; k += kLaneCount) {
    const FloatLanes height = heights_at(points, direction, k);
    store_floats(offsets != nullptr ? height - load_floats(offsets + k) : height, heights + k);
  }
}

RIGOR_FLOAT_LANES void above_kernel(const float* x, float least_x, const float* y, float least_y, int count,
                                    std::vector<int>& places) {
  for (int k = 0; k < count; k += kLaneCount) {
    unsigned bits =
        lane_bits((load_floats(x + k) > float_lanes(least_x)) & (load_floats(y + k) > float_lanes(least_y)));
    if (count - k < kLaneCount) bits &= (1u << (count - k)) - 1;
    for (; bits != 0; bits &= bits - 1) places.push_back(k + std::countr_zero(bits));
  }
}

/// How far a core reaches along n = (x, y, z) from the origin of its frame.
RIGOR_FLOAT_LANES float reach_of(const SupportCore& core, float x, float y, float z) {
  const float* R = core.placed->R;
  // The direction goes into the frame of the core, where the vertices are: one rotation instead of one per
  // vertex.
  const FloatVec3 direction{float_lanes((R[0] * x + R[3] * y + R[6] * z) * core.scale.x()),
                            float_lanes((R[1] * x + R[4] * y + R[7] * z) * core.scale.y()),
                            float_lanes((R[2] * x + R[5] * y + R[8] * z) * core.scale.z())};
  FloatLanes highest = heights_at(core.vertices, direction, 0);
  for (std::size_t k = kLaneCount; k < core.vertices.count; k += kLaneCount)
    highest = float_max(highest, heights_at(core.vertices, direction, k));
  return spread_max(highest)[0];
}

RIGOR_FLOAT_LANES float separation_kernel(const SupportCore& a, const SupportCore& b, const Vec3f& d,
                                          const Vec3f& n) {
  const float x = n.x(), y = n.y(), z = n.z();
  return d.x() * x + d.y() * y + d.z() * z - reach_of(a, x, y, z) - reach_of(b, -x, -y, -z);
}

RIGOR_FLOAT_LANES void place_part(const FloatLanes* from, const Mat3f& M, const Vec3f& t,
                                  float (*to)[kLaneCount]) {
  for (int row = 0; row < 3; ++row)
    store_floats(float_lanes(M(row, 0)) * from[0] + float_lanes(M(row, 1)) * from[1] +
                     float_lanes(M(row, 2)) * from[2] + float_lanes(t[row]),
                 to[row]);
}

/// One row of a rotation times a vector, added up as the product of a matrix and a vector is, so that it has
/// the same bits.
RIGOR_FLOAT_LANES FloatLanes turned(const FloatVec3& row, const FloatVec3& p) {
  return row.x * p.x + (row.y * p.y + row.z * p.z);
}

RIGOR_FLOAT_LANES void columns_kernel(const LaneColumns& points, const Mat3f& M, const Vec3f& t, float* to) {
  // The matrix in all lanes, then eight points at a time.
  FloatVec3 row[3];
  for (int i = 0; i < 3; ++i) row[i] = {float_lanes(M(i, 0)), float_lanes(M(i, 1)), float_lanes(M(i, 2))};
  const FloatVec3 shift = spread(t);
  for (std::size_t k = 0; k < points.count; k += kLaneCount) {
    const FloatVec3 p{load_floats(points.x + k), load_floats(points.y + k), load_floats(points.z + k)};
    store_floats(turned(row[0], p) + shift.x, to + k);
    store_floats(turned(row[1], p) + shift.y, to + points.count + k);
    store_floats(turned(row[2], p) + shift.z, to + 2 * points.count + k);
  }
}

/// Places up to eight of the edges; what fills the block crosses nothing, since its normals are zero.
RIGOR_FLOAT_LANES void arcs_kernel(const FloatHull& hull, std::span<const int> edges, const CorePlace& place,
                                   ArcBlocks::Block& block) {
  static constexpr FloatHull::ArcRecord nothing{};
  FloatSquare first, second;
  for (std::size_t k = 0; k < kLaneCount; ++k) {
    const FloatHull::ArcRecord& arc = k < edges.size() ? hull.arcs[at(edges[k])] : nothing;
    first.row[k] = load_floats(arc.along);
    second.row[k] = load_floats(arc.along + 8);
  }
  first = transpose(first);
  second = transpose(second);
  // Edge vectors and points by the scaled rotation, normals by the rotation.
  FloatLanes local[ArcBlocks::part_count];
  for (int k = 0; k < ArcBlocks::part_count; ++k) local[k] = k < 8 ? first.row[k] : second.row[k - 8];
  const Vec3f none = Vec3f::Zero();
  place_part(local + ArcBlocks::along, place.M, none, block.part + ArcBlocks::along);
  place_part(local + ArcBlocks::normal_0, place.R, none, block.part + ArcBlocks::normal_0);
  place_part(local + ArcBlocks::normal_1, place.R, none, block.part + ArcBlocks::normal_1);
  place_part(local + ArcBlocks::point, place.M, place.t, block.part + ArcBlocks::point);
}

RIGOR_FLOAT_LANES FloatVec3 spread_part(const ArcBlocks::Block& block, ArcBlocks::Part part,
                                        std::size_t lane) {
  return {float_lanes(block.part[part][lane]), float_lanes(block.part[part + 1][lane]),
          float_lanes(block.part[part + 2][lane])};
}
RIGOR_FLOAT_LANES FloatVec3 load_part(const ArcBlocks::Block& block, ArcBlocks::Part part) {
  return {load_floats(block.part[part]), load_floats(block.part[part + 1]),
          load_floats(block.part[part + 2])};
}

/// One edge of A in all lanes: its vector, its two normals and a point of it.
struct ArcLanes {
  FloatVec3 u, n0, n1, p;
};

/// Which edges of the block cross the edge of A on the Gauss map with more separation than `least`; their
/// separations.
///
/// Source: Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013.
RIGOR_FLOAT_LANES unsigned cross_block(const ArcLanes& a, const ArcBlocks::Block& b, float least,
                                       float* separations) {
  constexpr float least_square_sine = 1e-8f;
  const FloatVec3 v = load_part(b, ArcBlocks::along);
  const FloatVec3 n_B0 = load_part(b, ArcBlocks::normal_0), n_B1 = load_part(b, ArcBlocks::normal_1);
  // The arcs cross if the ends of each are on either side of the circle of the other, and the crossing is on
  // the same half of the sphere.
  const FloatLanes a0 = dot(a.n0, v), a1 = dot(a.n1, v), b0 = dot(n_B0, a.u), b1 = dot(n_B1, a.u);
  const FloatLanes zero = float_lanes(0);
  const IntLanes is_crossing = (a0 * a1 < zero) & (b0 * b1 < zero) & (b0 * a1 < zero);
  if (lane_bits(is_crossing) == 0) return 0;
  // The axis is across both edges, with the sign that points out of A.
  const FloatVec3 w = cross(a.u, v);
  const FloatLanes square = dot(w, w), outward = dot(w, a.n0 + a.n1) - dot(w, n_B0 + n_B1);
  // The separation over all four ends: nearly parallel edges give an axis that is a little off, never a
  // separation that is too large.
  const FloatLanes sign = outward < zero ? float_lanes(-1) : float_lanes(1);
  const FloatLanes height = sign * dot(w, load_part(b, ArcBlocks::point) - a.p) +
                            float_min(sign * dot(w, v), zero) - float_max(sign * dot(w, a.u), zero);
  const FloatLanes separation = height / float_sqrt(square);
  store_floats(separation, separations);
  return lane_bits(is_crossing & (separation > float_lanes(least)) &
                   (square > float_lanes(least_square_sine) * dot(a.u, a.u) * dot(v, v)));
}

RIGOR_FLOAT_LANES EdgeChoice edges_kernel(const ArcBlocks& a, const ArcBlocks& b, float least) {
  EdgeChoice best{-1, -1, least};
  float separations[kLaneCount];
  for (std::size_t i = 0; i < a.count(); ++i) {
    const ArcBlocks::Block& block = a.blocks()[i / kLaneCount];
    const std::size_t own = i % kLaneCount;
    // One edge of A against all blocks of B. Ties go to the earlier pair.
    const ArcLanes arc{
        spread_part(block, ArcBlocks::along, own), spread_part(block, ArcBlocks::normal_0, own),
        spread_part(block, ArcBlocks::normal_1, own), spread_part(block, ArcBlocks::point, own)};
    for (std::size_t k = 0; k < b.blocks().size(); ++k) {
      unsigned bits = cross_block(arc, b.blocks()[k], best.separation, separations);
      for (; bits != 0; bits &= bits - 1) {
        // The best may have grown since the block was tested.
        const int lane = std::countr_zero(bits);
        if (!(separations[lane] > best.separation)) continue;
        best = {static_cast<int>(i), static_cast<int>(k) * kLaneCount + lane, separations[lane]};
      }
    }
  }
  return best;
}

/// The squared distances of eight segments from one, as in nearest_on_segments().
RIGOR_FLOAT_LANES void distances_kernel(const Vec3f& p, const Vec3f& along, const SegmentLanes& segments,
                                        float* squares) {
  constexpr float least_square_sine = 1e-6f;
  const FloatLanes zero = float_lanes(0), one = float_lanes(1);
  const FloatVec3 u = spread(along);
  const FloatVec3 v{load_floats(segments.v[0]), load_floats(segments.v[1]), load_floats(segments.v[2])};
  const FloatVec3 w =
      FloatVec3{load_floats(segments.q[0]), load_floats(segments.q[1]), load_floats(segments.q[2])} -
      spread(p);
  const FloatLanes uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const FloatVec3 across = cross(u, v);
  const FloatLanes determinant = dot(across, across);
  const FloatLanes inverse_uu = uu > zero ? one / uu : zero, inverse_vv = vv > zero ? one / vv : zero;
  const auto clamp = [&](const FloatLanes& x) __attribute__((always_inline)) {
    return float_min(one, float_max(zero, x));
  };
  // Nearest points of the lines, clamped to one segment, then to the other, and back.
  const IntLanes is_oblique = determinant > float_lanes(least_square_sine) * uu * vv;
  FloatLanes s = is_oblique ? clamp((uw * vv - vw * uv) / determinant) : zero;
  FloatLanes t = clamp((s * uv - vw) * inverse_vv);
  s = clamp((t * uv + uw) * inverse_uu);
  t = clamp((s * uv - vw) * inverse_vv);
  const FloatVec3 between = w + t * v - s * u;
  store_floats(dot(between, between), squares);
}

RIGOR_FLOAT_LANES float least_kernel(const float* x, std::size_t count) {
  FloatLanes least = load_floats(x);
  for (std::size_t k = kLaneCount; k < count; k += kLaneCount) least = float_min(least, load_floats(x + k));
  return -spread_max(-least)[0];
}

RIGOR_FLOAT_LANES void up_to_kernel(const std::vector<float>& x, float most, std::vector<int>& places) {
  for (std::size_t k = 0; k < x.size(); k += kLaneCount) {
    unsigned bits = lane_bits(load_floats(x.data() + k) <= float_lanes(most));
    for (; bits != 0; bits &= bits - 1) places.push_back(static_cast<int>(k) + std::countr_zero(bits));
  }
}

#if defined(__x86_64__)
#define RIGOR_AVX2 [[gnu::target("avx2")]]
#else
#define RIGOR_AVX2
#endif

RIGOR_AVX2 Support support_avx2(const LaneColumns& points, const Vec3f& n) {
  return support_kernel(points, n);
}
RIGOR_AVX2 SupportSet support_set_avx2(const LaneColumns& points, int count, const Vec3f& n, float drop) {
  return support_set_kernel(points, count, n, drop);
}
RIGOR_AVX2 void heights_avx2(const LaneColumns& points, const Vec3f& n, const float* offsets,
                             float* heights) {
  heights_kernel(points, n, offsets, heights);
}
RIGOR_AVX2 void above_avx2(const float* x, float least_x, const float* y, float least_y, int count,
                           std::vector<int>& places) {
  above_kernel(x, least_x, y, least_y, count, places);
}
RIGOR_AVX2 void columns_avx2(const LaneColumns& points, const Mat3f& M, const Vec3f& t, float* to) {
  columns_kernel(points, M, t, to);
}
RIGOR_AVX2 float separation_avx2(const SupportCore& a, const SupportCore& b, const Vec3f& d, const Vec3f& n) {
  return separation_kernel(a, b, d, n);
}
RIGOR_AVX2 void arcs_avx2(const FloatHull& hull, std::span<const int> edges, const CorePlace& place,
                          ArcBlocks::Block& block) {
  arcs_kernel(hull, edges, place, block);
}
RIGOR_AVX2 EdgeChoice edges_avx2(const ArcBlocks& a, const ArcBlocks& b, float least) {
  return edges_kernel(a, b, least);
}
RIGOR_AVX2 void distances_avx2(const Vec3f& p, const Vec3f& u, const std::vector<SegmentLanes>& segments,
                               float* squares) {
  for (std::size_t k = 0; k < segments.size(); ++k)
    distances_kernel(p, u, segments[k], squares + k * kLaneCount);
}
RIGOR_AVX2 void up_to_avx2(const std::vector<float>& x, float most, std::vector<int>& places) {
  up_to_kernel(x, most, places);
}
RIGOR_AVX2 float least_avx2(const float* x, std::size_t count) {
  return least_kernel(x, count);
}

}  // namespace

Support find_support(const LaneColumns& points, const Vec3f& n, LaneTarget target) {
  return target == LaneTarget::avx2 ? support_avx2(points, n) : support_kernel(points, n);
}

SupportSet find_support_set(const LaneColumns& points, int count, const Vec3f& n, float drop,
                            LaneTarget target) {
  return target == LaneTarget::avx2 ? support_set_avx2(points, count, n, drop)
                                    : support_set_kernel(points, count, n, drop);
}

void find_heights(const LaneColumns& points, const Vec3f& n, const float* offsets, LaneTarget target,
                  float* heights) {
  target == LaneTarget::avx2 ? heights_avx2(points, n, offsets, heights)
                             : heights_kernel(points, n, offsets, heights);
}

void list_above(const LevelColumn& x, const LevelColumn& y, int count, LaneTarget target,
                std::vector<int>& places) {
  places.clear();
  const float *const xs = x.numbers.data(), *const ys = y.numbers.data();
  target == LaneTarget::avx2 ? above_avx2(xs, x.level, ys, y.level, count, places)
                             : above_kernel(xs, x.level, ys, y.level, count, places);
}

float find_separation(const SupportCore& a, const SupportCore& b, const Vec3f& d, const Vec3f& n,
                      LaneTarget target) {
  return target == LaneTarget::avx2 ? separation_avx2(a, b, d, n) : separation_kernel(a, b, d, n);
}

void PlacedColumns::place(const LaneColumns& points, const Mat3f& M, const Vec3f& t, LaneTarget target) {
  count_ = points.count;
  if (numbers_.size() < 3 * count_) numbers_.resize(3 * count_);
  target == LaneTarget::avx2 ? columns_avx2(points, M, t, numbers_.data())
                             : columns_kernel(points, M, t, numbers_.data());
}

void ArcBlocks::place(const FloatHull& hull, std::span<const int> edges, const CorePlace& place,
                      LaneTarget target) {
  edges_.assign(edges.begin(), edges.end());
  blocks_.resize((edges.size() + kLaneCount - 1) / kLaneCount);
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const std::size_t first = k * kLaneCount;
    const std::span<const int> part =
        edges.subspan(first, std::min<std::size_t>(kLaneCount, edges.size() - first));
    target == LaneTarget::avx2 ? arcs_avx2(hull, part, place, blocks_[k])
                               : arcs_kernel(hull, part, place, blocks_[k]);
  }
}

EdgeChoice find_best_edges(const ArcBlocks& a, const ArcBlocks& b, float least, LaneTarget target) {
  return target == LaneTarget::avx2 ? edges_avx2(a, b, least) : edges_kernel(a, b, least);
}

void find_square_distances(const Vec3f& p, const Vec3f& u, const std::vector<SegmentLanes>& segments,
                           LaneTarget target, float* squares) {
  if (target == LaneTarget::avx2) return distances_avx2(p, u, segments, squares);
  for (std::size_t k = 0; k < segments.size(); ++k)
    distances_kernel(p, u, segments[k], squares + k * kLaneCount);
}

float least_of(const std::vector<float>& x, LaneTarget target) {
  return target == LaneTarget::avx2 ? least_avx2(x.data(), x.size()) : least_kernel(x.data(), x.size());
}

void list_up_to(const std::vector<float>& x, float most, LaneTarget target, std::vector<int>& places) {
  places.clear();
  target == LaneTarget::avx2 ? up_to_avx2(x, most, places) : up_to_kernel(x, most, places);
}

}  // namespace rigor
