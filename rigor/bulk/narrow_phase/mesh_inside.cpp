#include "rigor/bulk/narrow_phase/mesh_inside.hpp"

#include "rigor/geometry/mesh/mesh_point.hpp"

#include <bit>

namespace rigor {

bool is_inside(const Mesh& mesh, const Vec3& c_M, PairHint& hint) {
  constexpr float part = 0.99f;  // What rounding may take.
  const Vec3f c = c_M.cast<float>();
  if (hint.axis != 0 && (c - hint.n).norm() < part * std::bit_cast<float>(hint.axis)) return false;
  const MeshPoint nearest = nearest_mesh_point(mesh, c_M);
  const bool inside = (c_M - nearest.p_M).dot(nearest.normal_M) < 0;
  const float distance = static_cast<float>(nearest.distance) - kCollisionRounding * c.lpNorm<1>();
  hint = inside || !(distance > 0) ? PairHint{} : PairHint{c, std::bit_cast<AxisCode>(distance)};
  return inside;
}

}  // namespace rigor
