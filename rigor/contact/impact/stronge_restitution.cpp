#include "rigor/contact/impact/restitution_law.hpp"

namespace rigor {

// Energetic restitution: of the work that compression stored, restitution gives back the share e². A second
// compression stores more, so the lowest work counts.
RestitutionEnd stronge_restitution(double e, const CompressionRecord& compression) {
  return {ImpactQuantity::work, (1 - e * e) * compression.work};
}

}  // namespace rigor
