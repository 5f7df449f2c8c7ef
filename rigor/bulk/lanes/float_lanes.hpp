#pragma once

// Eight floats at a time, written once for every processor: the compiler makes AVX2 of it inside functions
// with that target and SSE2 otherwise. Both give the same bits (no operation is contracted).

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

// Functions that pass lanes by value are inlined, or called within one target only: there is no ABI to
// change.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace rigor {

constexpr int kLaneCount = 8;
using FloatLanes = float __attribute__((vector_size(32)));
using IntLanes = std::int32_t __attribute__((vector_size(32)));

#define RIGOR_FLOAT_LANES [[gnu::always_inline]] inline

RIGOR_FLOAT_LANES FloatLanes float_lanes(float x) {
  return FloatLanes{x, x, x, x, x, x, x, x};
}
RIGOR_FLOAT_LANES FloatLanes load_floats(const float* p) {
  FloatLanes x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
RIGOR_FLOAT_LANES void store_floats(const FloatLanes& x, float* p) {
  std::memcpy(p, &x, sizeof x);
}
RIGOR_FLOAT_LANES FloatLanes float_max(const FloatLanes& a, const FloatLanes& b) {
  return a > b ? a : b;
}
RIGOR_FLOAT_LANES FloatLanes float_min(const FloatLanes& a, const FloatLanes& b) {
  return a < b ? a : b;
}
/// Of each lane; rounded correctly, as everywhere. (On four lanes at a time, which every x86-64 has; the
/// square root of the library sets errno, which the compiler does not put into lanes.)
RIGOR_FLOAT_LANES FloatLanes float_sqrt(const FloatLanes& x) {
#if defined(__SSE__)
  // The two halves of the lanes, since registers of eight floats need AVX.
  float root[kLaneCount];
  store_floats(x, root);
  _mm_storeu_ps(root, _mm_sqrt_ps(_mm_loadu_ps(root)));
  _mm_storeu_ps(root + 4, _mm_sqrt_ps(_mm_loadu_ps(root + 4)));
  return load_floats(root);
#else
  FloatLanes root;
  for (int i = 0; i < kLaneCount; ++i) root[i] = std::sqrt(x[i]);
  return root;
#endif
}

/// Three coordinates in lanes.
struct FloatVec3 {
  FloatLanes x, y, z;
};
RIGOR_FLOAT_LANES FloatVec3 operator+(const FloatVec3& a, const FloatVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
RIGOR_FLOAT_LANES FloatVec3 operator-(const FloatVec3& a, const FloatVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
RIGOR_FLOAT_LANES FloatVec3 operator*(const FloatLanes& s, const FloatVec3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
RIGOR_FLOAT_LANES FloatLanes dot(const FloatVec3& a, const FloatVec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
RIGOR_FLOAT_LANES FloatVec3 cross(const FloatVec3& a, const FloatVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A symmetric matrix in lanes.
struct FloatSym3 {
  FloatLanes xx, yy, zz, xy, xz, yz;
};
RIGOR_FLOAT_LANES FloatVec3 operator*(const FloatSym3& m, const FloatVec3& a) {
  return {m.xx * a.x + m.xy * a.y + m.xz * a.z, m.xy * a.x + m.yy * a.y + m.yz * a.z,
          m.xz * a.x + m.yz * a.y + m.zz * a.z};
}

/// Eight rows of eight floats, transposed: lane i of result j is float j of row i.
struct FloatSquare {
  FloatLanes row[kLaneCount];
};
RIGOR_FLOAT_LANES FloatSquare transpose(const FloatSquare& m) {
  const FloatLanes* r = m.row;
  FloatSquare a, b, c;
  // Rows 2k and 2k + 1 are interleaved float by float, within each half of four lanes.
  for (int i = 0; i < kLaneCount; i += 2) {
    a.row[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a.row[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  // Pairs of rows are interleaved two floats at a time: each half now holds four rows' floats of one column.
  for (int i = 0; i < kLaneCount; i += 4) {
    for (int k = 0; k < 2; ++k) {
      const FloatLanes& near = a.row[i + k];
      const FloatLanes& far = a.row[i + k + 2];
      b.row[i + 2 * k] = __builtin_shufflevector(near, far, 0, 1, 8, 9, 4, 5, 12, 13);
      b.row[i + 2 * k + 1] = __builtin_shufflevector(near, far, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  // The lower halves of the upper and the lower four rows make the first four columns, the upper halves the
  // rest.
  for (int i = 0; i < kLaneCount / 2; ++i) {
    c.row[i] = __builtin_shufflevector(b.row[i], b.row[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    c.row[i + 4] = __builtin_shufflevector(b.row[i], b.row[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
  return c;
}

}  // namespace rigor
