#include "rigor/model/material.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

PairCoefficients combined_coefficients(const Material& a, const Material& b) {
  // sqrt(μ²) may differ from μ by rounding: equal coefficients stay as they are.
  const double friction = a.friction == b.friction ? a.friction : std::sqrt(a.friction * b.friction);
  return {friction, std::max(a.restitution, b.restitution)};
}

}  // namespace rigor
