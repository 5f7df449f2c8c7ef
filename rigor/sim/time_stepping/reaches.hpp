#pragma once

#include "rigor/dynamics/environment.hpp"

#include <vector>

namespace rigor {

/// Grows the reaches, one per body of the model [m], to how far the points of these bodies come within h at
/// the velocities of these phases; with a margin, so that they seldom grow twice.
void grow_reaches(const Model& model, const Environment& environment, double h,
                  const std::vector<int>& bodies, const std::vector<BodyPhase>& phases,
                  std::vector<double>& reaches);

/// The same for bodies with prescribed motions, at their velocities at t [s].
void grow_prescribed_reaches(const Model& model, double h, double t, std::vector<double>& reaches);

/// How far a point of a body can have been moved from one phase to another [m].
double reach_between(const Body& body, const BodyPhase& from, const BodyPhase& to);

}  // namespace rigor
