#include "rigor/bulk/hull_lanes.hpp"

#include "rigor/bulk/float_lanes.hpp"

#include <limits>

namespace rigor {

namespace {

RIGOR_FLOAT_LANES void map_kernel(const LaneColumns& from, const Mat3f& M, const Vec3f& t, float* const* to) {
  for (int row = 0; row < 3; ++row) {
    const FloatLanes mx = float_lanes(M(row, 0)), my = float_lanes(M(row, 1)), mz = float_lanes(M(row, 2));
    const FloatLanes shift = float_lanes(t[row]);
    for (std::size_t k = 0; k < from.count; k += kLaneCount)
      store_floats(
          mx * load_floats(from.x + k) + my * load_floats(from.y + k) + mz * load_floats(from.z + k) + shift,
          to[row] + k);
  }
}

RIGOR_FLOAT_LANES void heights_kernel(const LaneColumns& points, const Vec3f& n, float* heights) {
  const FloatLanes nx = float_lanes(n.x()), ny = float_lanes(n.y()), nz = float_lanes(n.z());
  for (std::size_t k = 0; k < points.count; k += kLaneCount)
    store_floats(
        nx * load_floats(points.x + k) + ny * load_floats(points.y + k) + nz * load_floats(points.z + k),
        heights + k);
}

RIGOR_FLOAT_LANES float lowest_kernel(const LaneColumns& points, const Vec3f& n) {
  const FloatLanes nx = float_lanes(n.x()), ny = float_lanes(n.y()), nz = float_lanes(n.z());
  FloatLanes lowest = float_lanes(std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < points.count; k += kLaneCount)
    lowest = float_min(lowest, nx * load_floats(points.x + k) + ny * load_floats(points.y + k) +
                                   nz * load_floats(points.z + k));
  float lanes[kLaneCount];
  store_floats(lowest, lanes);
  float least = lanes[0];
  for (int i = 1; i < kLaneCount; ++i) least = lanes[i] < least ? lanes[i] : least;
  return least;
}

/// Source: Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013.
RIGOR_FLOAT_LANES unsigned arcs_kernel(const ArcColumns& a, std::size_t i, const ArcColumns& b,
                                       std::size_t first) {
  FloatLanes own[ArcColumns::column_count], other[ArcColumns::column_count];
  for (int c = 0; c < ArcColumns::column_count; ++c) {
    own[c] = float_lanes(a.column[c][i]);
    other[c] = load_floats(&b.column[c][first]);
  }
  const FloatVec3 u{own[0], own[1], own[2]}, v{other[0], other[1], other[2]};
  const FloatLanes a0 = dot(FloatVec3{own[3], own[4], own[5]}, v);
  const FloatLanes a1 = dot(FloatVec3{own[6], own[7], own[8]}, v);
  const FloatLanes b0 = dot(FloatVec3{other[3], other[4], other[5]}, u);
  const FloatLanes b1 = dot(FloatVec3{other[6], other[7], other[8]}, u);
  const FloatLanes zero = float_lanes(0);
  const IntLanes cross = (a0 * a1 < zero) & (b0 * b1 < zero) & (b0 * a1 < zero);
  std::int32_t lanes[kLaneCount];
  std::memcpy(lanes, &cross, sizeof lanes);
  unsigned mask = 0;
  for (unsigned k = 0; k < kLaneCount; ++k) mask |= lanes[k] != 0 ? 1u << k : 0u;
  return mask;
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void map_avx2(const LaneColumns& from, const Mat3f& M, const Vec3f& t,
                                      float* const* to) {
  map_kernel(from, M, t, to);
}
[[gnu::target("avx2")]] void heights_avx2(const LaneColumns& points, const Vec3f& n, float* heights) {
  heights_kernel(points, n, heights);
}
[[gnu::target("avx2")]] float lowest_avx2(const LaneColumns& points, const Vec3f& n) {
  return lowest_kernel(points, n);
}
[[gnu::target("avx2")]] unsigned arcs_avx2(const ArcColumns& a, std::size_t i, const ArcColumns& b,
                                           std::size_t first) {
  return arcs_kernel(a, i, b, first);
}
#else
void map_avx2(const LaneColumns& from, const Mat3f& M, const Vec3f& t, float* const* to) {
  map_kernel(from, M, t, to);
}
void heights_avx2(const LaneColumns& points, const Vec3f& n, float* heights) {
  heights_kernel(points, n, heights);
}
float lowest_avx2(const LaneColumns& points, const Vec3f& n) {
  return lowest_kernel(points, n);
}
unsigned arcs_avx2(const ArcColumns& a, std::size_t i, const ArcColumns& b, std::size_t first) {
  return arcs_kernel(a, i, b, first);
}
#endif

}  // namespace

void map_columns(const LaneColumns& from, const Mat3f& M, const Vec3f& t, LaneTarget target,
                 float* const* to) {
  target == LaneTarget::avx2 ? map_avx2(from, M, t, to) : map_kernel(from, M, t, to);
}

void find_heights(const LaneColumns& points, const Vec3f& n, LaneTarget target, float* heights) {
  target == LaneTarget::avx2 ? heights_avx2(points, n, heights) : heights_kernel(points, n, heights);
}

float find_lowest(const LaneColumns& points, const Vec3f& n, LaneTarget target) {
  return target == LaneTarget::avx2 ? lowest_avx2(points, n) : lowest_kernel(points, n);
}

void ArcColumns::clear() {
  for (std::vector<float>& values : column) values.clear();
  edge.clear();
}

void ArcColumns::add(int e, const Vec3f& u, const Vec3f& n0, const Vec3f& n1) {
  for (int k = 0; k < 3; ++k) {
    column[k].push_back(u[k]);
    column[3 + k].push_back(n0[k]);
    column[6 + k].push_back(n1[k]);
  }
  edge.push_back(e);
}

void ArcColumns::pad() {
  for (std::vector<float>& values : column)
    values.resize((values.size() + kLaneCount - 1) / kLaneCount * kLaneCount, 0.0f);
}

unsigned find_crossing_arcs(const ArcColumns& a, std::size_t i, const ArcColumns& b, std::size_t first,
                            LaneTarget target) {
  return target == LaneTarget::avx2 ? arcs_avx2(a, i, b, first) : arcs_kernel(a, i, b, first);
}

}  // namespace rigor
