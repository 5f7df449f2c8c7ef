#pragma once

#include "rigor/dynamics/motion.hpp"

namespace rigor {

/// A time from t on in which no point of one body goes deeper into the other than `slack` [s]; at most t_end
/// - t, and more than 0. The bodies may touch at t, or overlap by less than the slack, which must be > 0 [m].
///
/// For bodies whose contact lasts, conservative advancement stands still at the contact. Here the gap along
/// the normal, fixed or rotating with either body, may fall to -slack (SeparationBound, of second order):
/// what slides, rolls or rocks advances far, and what spins fast by no more than its points need for the
/// slack.
double bounded_overlap_step(const Body& A, const Motion& of_A, const Body& B, const Motion& of_B, double t,
                            double t_end, double slack);

}  // namespace rigor
