#pragma once

#include "rigor/contact/time_of_impact.hpp"
#include "rigor/sim/method/method.hpp"

namespace rigor {

/// How the method searches for times of impact.
ToiOptions toi_choice(const Method& method);

}  // namespace rigor
