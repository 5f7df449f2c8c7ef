#pragma once

#include "rigor/contact/contact_system.hpp"

#include <vector>

namespace rigor {

/// How several impacts at one instant are resolved.
enum class SimultaneousLaw {
  reflections,  ///< Generalised reflections blended with the plastic solution: symmetric, never gains energy.
  lcp,  ///< Newton's law on all contacts at once: may gain energy and transmits too little through chains.
};

/// Outcome of an impact.
struct ImpactSolution {
  VecX lambda;      ///< 3n impulses in the contact frames [N s].
  double residual;  ///< Of the complementarity problem, relative.
  bool converged;
  int iterations;
};

/// Impulses that end the approach of all contacts at once, with Newton's restitution and Coulomb friction.
///
/// restitutions: e of each contact, as it is to be used here. Newton's law with friction for the contacts of
/// one pair of bodies:  u_n⁺ ≥ -e u_n⁻,  λ in the cone, friction opposing u_t⁺. Several pairs go by `law`.
/// Source: theory of generalised reflections: Smith, Kaufman, Vouga, Tamstorf, Grinspun, Reflections on
/// Simultaneous Impact, SIGGRAPH 2012; here blended as V⁺ = e V_GR + (1 - e) V_plastic, and followed by
/// friction within the cone of the normal impulses.
ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            SimultaneousLaw law);

}  // namespace rigor
