#include "rigor/bulk/solved_manifold.hpp"

namespace rigor {

void remember_impulses(const std::array<float, 3>& n, const std::array<float, 3>& t1,
                       const ManifoldImpulses& impulses, ManifoldMemory& memory) {
  memory.normal_impulse = impulses.normal;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    const float t2 = n[l] * t1[m] - n[m] * t1[l];
    memory.friction_impulse_W[k] = impulses.tangent[0] * t1[k] + impulses.tangent[1] * t2;
    memory.rolling_impulse_W[k] = impulses.roll[0] * t1[k] + impulses.roll[1] * t2;
  }
  memory.twist_impulse = impulses.twist;
}

}  // namespace rigor
