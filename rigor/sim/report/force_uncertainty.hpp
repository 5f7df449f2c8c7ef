#pragma once

#include "rigor/contact/system/contact_system.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/report/advance_report.hpp"

namespace rigor {

/// Notes how well the forces λ (3n) of contacts, which solvers know to 1e-10 of the largest in the system,
/// determine the accelerations of the bodies that carry them, relative to those of their own weights, or to a
/// part of what all their forces give them where that is more. A light
/// body under one 1e10 times heavier is beyond what numbers of 64 bits tell: whether it stays is chance.
void note_force_uncertainty(const ContactSystem& system, const VecX& lambda, const Environment& environment,
                            double t, AdvanceReport& report);

}  // namespace rigor
