#pragma once

#include "rigor/math/types.hpp"

#include <string>

namespace rigor {

/// K of a contact of bodies that joints hold: K = J (M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹) Jᵀ, since the impact
/// goes through the joints at once. inverse_mass: M⁻¹ (6n × 6n or of any generalised velocities), J (3 × 6n):
/// u = J V, G (rows × 6n): G V = 0. Redundant rows of G are allowed. Without rows: K = J M⁻¹ Jᵀ.
Mat3 constrained_collision_matrix(const MatX& inverse_mass, const MatX& J, const MatX& G);

/// Generalised velocity after an impulse at such a contact: V + (M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹) Jᵀ λ.
VecX constrained_velocity_change(const MatX& inverse_mass, const MatX& J, const MatX& G, const Vec3& lambda);

/// What is wrong with K as the matrix of an impact: it must be finite, symmetric and positive semidefinite
/// (to rounding) with K_nn > 0. Empty if nothing.
std::string check_collision_matrix(const Mat3& K);

}  // namespace rigor
