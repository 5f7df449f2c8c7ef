#pragma once

#include "rigor/geometry/motion/time_of_contact.hpp"

namespace rigor {

/// A span from t on, at most to t_end, during which no corner of B comes nearer to the wall than `level` [m].
/// A moving corner at r from the centre, with velocity u against it, is at most |r + τ u| + ½ a τ² from it
/// later, where a bounds the accelerations: a convex function of τ.
double safe_step_in_cavity(const MovingShape& cavity, const MovingShape& inside, double t, double t_end,
                           double level);

}  // namespace rigor
