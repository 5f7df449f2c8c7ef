#include "rigor/contact/impact/restitution_law.hpp"

namespace rigor {

// Kinetic restitution: the normal impulse of restitution is e times that of the first compression.
RestitutionEnd poisson_restitution(double e, const CompressionRecord& compression) {
  return {ImpactQuantity::p, compression.p_before + (1 + e) * compression.p};
}

}  // namespace rigor
