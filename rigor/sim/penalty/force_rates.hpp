#pragma once

#include "rigor/contact/penalty/penalty_rates.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/model/model.hpp"

namespace rigor {

/// Bounds of the rates [1/s] at which the springs, dampers and drags of the scene and the springs and dampers
/// of its joints make bodies swing and settle: explicit steps must resolve them. 0 if there are none; drags
/// in closed form are not counted.
///
/// With μ = 1/m + r²/I of a spring's end on a body (r: its distance from the centre of mass, I: the least
/// moment), the energy of the springs in units of that of the masses is Σ_b (Σ_i √(k_i μ_ib) x_i)² ≤ 2 max_b
/// Σ_i k_i μ_ib |x|², since a spring is at two bodies: ω² ≤ 2 max_b Σ_i k_i μ_ib, and so for dampers with c
/// instead of k. Of a joint's law μ is 1/m + r²/I along a displacement and eᵀ I⁻¹ e about the axis e of an
/// angle.
PenaltyRates rates_of_forces(const Model& model, const Environment& environment, double target_step);

/// Whether the drag of a body, with its other own forces, is integrated in closed form: where no joint holds
/// the body, whose forces would not know of it, or where it is so fast that steps [s] cannot resolve it.
bool drags_in_closed_form(const Model& model, const Environment& environment, int body, double target_step);

}  // namespace rigor
