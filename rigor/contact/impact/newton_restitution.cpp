#include "rigor/contact/impact/restitution_law.hpp"

namespace rigor {

// Kinematic restitution: the normal velocity is reversed and scaled, u_n⁺ = -e u_n⁻, whatever friction did.
RestitutionEnd newton_restitution(double e, const CompressionRecord& compression) {
  return {ImpactQuantity::u_n, -e * compression.u_n_before};
}

}  // namespace rigor
