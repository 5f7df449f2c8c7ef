#pragma once

#include "rigor/model/findings.hpp"
#include "rigor/model/material.hpp"

namespace rigor {

/// Adds what is wrong with the name or the numbers of a material.
void check_material(const Material& material, Findings& findings);
/// The same for the coefficients of a pair.
void check_coefficients(const PairCoefficients& pair, Findings& findings);

}  // namespace rigor
