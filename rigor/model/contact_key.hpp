#pragma once

#include <compare>
#include <cstdint>

namespace rigor {

/// What tells contacts apart, in the order in which they are found and listed: the bodies, their shapes, and
/// where on the shapes.
struct ContactKey {
  int body_A = -1, body_B = -1;    ///< Model indices.
  int shape_A = -1, shape_B = -1;  ///< Of these bodies; negative: a stop of a joint, as in Contact.
  std::uint64_t feature = 0;  ///< Which features of the shapes meet; of a manifold, its number in the pair.

  auto operator<=>(const ContactKey& other) const = default;
};

}  // namespace rigor
