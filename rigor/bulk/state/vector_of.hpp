#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Three 32-bit numbers, as records of bodies and manifolds hold them, in double precision.
inline Vec3 vector_of(const float* p) {
  return Vec3(p[0], p[1], p[2]);
}

}  // namespace rigor
