#pragma once

#include "rigor/model/contact_key.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rigor {

/// What a scheme keeps of one contact from step to step: the deflections of springs, or where a solver begins
/// its search. Part of the State, so that a fresh stepper continues bit for bit.
struct ContactMemory {
  static constexpr std::size_t value_count = 12;

  int body_A = -1, body_B = -1;    ///< Model indices.
  int shape_A = -1, shape_B = -1;  ///< Of these bodies; negative: a stop of a joint, as in Contact.
  std::uint64_t feature = 0;       ///< Which features of the shapes meet.
  /// The scheme's own: penalty_contact.hpp names those of penalty contacts.
  std::array<double, value_count> values{};
  double energy = 0;  ///< Elastic energy that the contact holds at the State's time [J].

  bool operator==(const ContactMemory& other) const = default;
  ContactKey key() const { return {body_A, body_B, shape_A, shape_B, feature}; }
};

}  // namespace rigor
