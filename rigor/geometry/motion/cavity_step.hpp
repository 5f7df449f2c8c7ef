#pragma once

#include "rigor/geometry/motion/time_of_contact.hpp"

namespace rigor {

/// A step from t, at most to t_end, during which no corner of the shape inside comes nearer to the cavity's
/// wall than `level` [m]; the step in s. A corner at r from the centre, moving with velocity u relative to
/// it, is at most |r + τ u| + ½ a τ² from the centre at t + τ, where a bounds the relative acceleration. This
/// is a convex function of τ, so the clearance is concave.
double safe_step_in_cavity(const MovingShape& cavity, const MovingShape& inside, double t, double t_end,
                           double level);

}  // namespace rigor
