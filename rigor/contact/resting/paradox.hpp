#pragma once

#include "rigor/contact/system/contact_system.hpp"

#include <vector>

namespace rigor {

/// What Coulomb's law leaves open at resting contacts (Painlevé).
struct Paradox {
  enum class Kind {
    none,           ///< One solution, as far as is known.
    inconsistent,   ///< No finite forces.
    indeterminate,  ///< Several.
  };
  Kind kind = Kind::none;
  std::size_t contact = 0;  ///< Where; of several sliding contacts the one of the least sliding_response.
};

/// Whether the problem of solve_resting (arguments as there) has no solution or several. Of one contact it
/// says so exactly. Of several contacts it takes the solver's word (`have_forces`) that there is no solution,
/// if one of them slides with friction: contacts that may stick always have one.
Paradox find_paradox(const ContactSystem& system, const std::vector<Wrench>& wrenches, double slip_tolerance,
                     bool have_forces);

}  // namespace rigor
