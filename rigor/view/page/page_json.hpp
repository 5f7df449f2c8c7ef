#pragma once

#include "rigor/math/types.hpp"

#include <nlohmann/json.hpp>

namespace rigor {

/// Vectors and orientations as pages hold them: [x, y, z] and [w, x, y, z].
inline nlohmann::ordered_json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
inline nlohmann::ordered_json json_of(const Quat& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace rigor
