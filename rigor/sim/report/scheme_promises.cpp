#include "rigor/sim/report/scheme_promises.hpp"

#include <algorithm>

namespace rigor {

SchemePromises weaker_of(const SchemePromises& a, const SchemePromises& b) {
  return {.acts_in_steps = a.acts_in_steps || b.acts_in_steps,
          .knows_work = a.knows_work && b.knows_work,
          .energy_share = std::max(a.energy_share, b.energy_share),
          .energy_floor = std::max(a.energy_floor, b.energy_floor),
          .momentum_share = std::max(a.momentum_share, b.momentum_share),
          .rounding_share = std::max(a.rounding_share, b.rounding_share),
          .weight_share = std::max(a.weight_share, b.weight_share),
          .force_uncertainty = std::max(a.force_uncertainty, b.force_uncertainty),
          .joint_drift = std::max(a.joint_drift, b.joint_drift),
          .penetration = std::max(a.penetration, b.penetration),
          .penetration_share = std::max(a.penetration_share, b.penetration_share)};
}

}  // namespace rigor
