#pragma once

#include "rigor/bulk/bulk_bodies.hpp"

namespace rigor {

/// Principal axes and moments of a body at the begin of a step: what makes its angular velocity turn by
/// itself.
struct BodyGyration {
  float R_WB[9];     ///< Row by row.
  float moments[3];  ///< [kg m²].
};
BodyGyration gyration_of(const Body& body, const Quat& q_WB);

/// Whether its moments of inertia are equal: then its angular velocity stays while it turns.
bool is_round(const Body& body);

/// What the gyroscopic torque -ω × I ω changes of the angular velocity w [rad/s], in W, within h [s]: one
/// Newton step of the implicit equation, shortened where it would gain energy.
///
/// Source: Catto, Numerical Methods, Game Developers Conference 2015.
void gyroscopic_change(const BodyGyration& body, const float* w, float h, float* change);

}  // namespace rigor
