#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <cstddef>

namespace rigor {

/// The force that a contact makes of x = λ - c w, and what it does then.
struct ProjectedForce {
  ContactMode mode = ContactMode::open;
  Vec3 force = Vec3::Zero();  ///< P(x).
  Mat3 slope = Mat3::Zero();  ///< dP / dx.
};

/// Alart and Curnier's functions for contact k, with which Coulomb's law is λ = P(λ - c w) for any c > 0:
/// P_n = max(0, x_n), and P_t the point of the disk of radius μ P_n nearest to x_t; of rows whose slip is
/// known, friction against it. Where they have no derivative, the slope is that of one side.
///
/// Source: Alart and Curnier, A Mixed Formulation for Frictional Contact Problems Prone to Newton Like
/// Solution Methods, 1991.
ProjectedForce alart_curnier(const CoulombProblem& laws, std::size_t k, const Vec3& x);

}  // namespace rigor
