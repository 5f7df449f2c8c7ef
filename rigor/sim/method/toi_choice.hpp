#pragma once

#include "rigor/contact/time_of_impact.hpp"

namespace rigor {

struct Method;

/// How the method searches for times of impact.
ToiOptions toi_choice(const Method& method);

}  // namespace rigor
