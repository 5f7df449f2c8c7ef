#pragma once

// Arithmetic on four doubles at a time, written once for every processor: inside functions with that target
// the compiler makes AVX2 instructions of it, and otherwise instructions on pairs of doubles. Both give the
// same bits, since no operation is contracted.

#include <cstdint>
#include <cstring>

#pragma GCC diagnostic ignored "-Wpsabi"  // All functions here are inlined: there is no ABI to change.

namespace rigor {

using Lanes = double __attribute__((vector_size(32)));
using LaneIntegers = std::int32_t __attribute__((vector_size(16)));
using LaneMask = std::int64_t __attribute__((vector_size(32)));

#define RIGOR_LANES [[gnu::always_inline]] inline

RIGOR_LANES Lanes lanes_of(double x) {
  return Lanes{x, x, x, x};
}
RIGOR_LANES Lanes load_lanes(const double* p) {
  Lanes x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
/// Four 16-bit integers as numbers.
RIGOR_LANES Lanes load_integers(const std::int16_t* p) {
  std::int16_t x __attribute__((vector_size(8)));
  std::memcpy(&x, p, sizeof x);
  return __builtin_convertvector(__builtin_convertvector(x, LaneIntegers), Lanes);
}
RIGOR_LANES Lanes load_integers(const std::uint16_t* p) {
  std::uint16_t x __attribute__((vector_size(8)));
  std::memcpy(&x, p, sizeof x);
  return __builtin_convertvector(__builtin_convertvector(x, LaneIntegers), Lanes);
}
RIGOR_LANES void store_lanes(const Lanes& x, double* p) {
  std::memcpy(p, &x, sizeof x);
}
RIGOR_LANES Lanes lane_max(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
RIGOR_LANES Lanes lane_min(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}
RIGOR_LANES Lanes lane_abs(const Lanes& a) {
  return lane_max(a, -a);
}

/// Four vectors at a time: one lane of each coordinate belongs to each vector.
struct LaneVec3 {
  Lanes x, y, z;
};
RIGOR_LANES LaneVec3 operator+(const LaneVec3& a, const LaneVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
RIGOR_LANES LaneVec3 operator-(const LaneVec3& a, const LaneVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
RIGOR_LANES LaneVec3 operator*(const Lanes& s, const LaneVec3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
RIGOR_LANES Lanes dot(const LaneVec3& a, const LaneVec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
RIGOR_LANES LaneVec3 cross(const LaneVec3& a, const LaneVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace rigor
