#pragma once

#include "rigor/model/time_function.hpp"

#include <string>

namespace rigor {

/// The function of a formula in t, which several threads may evaluate at once. Throws InputError.
TimeFunction time_formula(const std::string& text);

/// From now on scene files may hold such formulas. Programs that link this layer call it at their start.
void use_time_formulas();

}  // namespace rigor
