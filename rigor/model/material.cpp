#include "rigor/model/material.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

PairCoefficients combined_coefficients(const Material& a, const Material& b) {
  // sqrt(μ²) may differ from μ by rounding: equal coefficients stay as they are.
  const auto mean = [](double of_a, double of_b) { return of_a == of_b ? of_a : std::sqrt(of_a * of_b); };
  std::optional<double> static_friction;
  if (a.static_friction || b.static_friction)
    static_friction = mean(a.sticking_friction(), b.sticking_friction());
  return {mean(a.friction, b.friction),
          std::max(a.restitution, b.restitution),
          mean(a.rolling_friction, b.rolling_friction),
          mean(a.torsional_friction, b.torsional_friction),
          std::max(a.tangential_restitution, b.tangential_restitution),
          static_friction};
}

}  // namespace rigor
