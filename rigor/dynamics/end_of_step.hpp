#pragma once

#include "rigor/dynamics/integrator.hpp"

namespace rigor {

/// integrate_step without the motion within the step: `dense` is empty. The end and its error have the same
/// bits; dop853 asks for twelve wrenches instead of sixteen.
SystemStep integrate_end_of_step(IntegratorName name, OrientationForm form,
                                 std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
                                 double t, double h, const WrenchField& wrenches,
                                 const IntegratorTolerances& tolerances);

}  // namespace rigor
