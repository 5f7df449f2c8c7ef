#pragma once

#include "rigor/contact/impact/impact_problem.hpp"
#include "rigor/sim/islands/contact_resolver.hpp"

#include <optional>

namespace rigor {

/// One collision of the trains that stand for contact in the impulse-based scheme.
///
/// A collision is slow if it approaches no faster than a fall through the envelope of the contact tolerance
/// ε, √(a ε), where a is the larger free acceleration of the two bodies. Restitution rises to 1 there, e' =
/// max(e, min(1, √(a ε) / |u_n|)), so that a body that is held up neither sinks nor comes to rest, and no
/// collision adds energy. Source: Mirtich and Canny, Impulse-based Simulation of Rigid Bodies, Symposium on
/// Interactive 3D Graphics, 1995; the speed at which e' rises is ours (docs/theory/impulse_based.md).
class MicroCollision {
 public:
  /// Holds references to both. With `method.micro_collisions: patched` slow collisions without rolling or
  /// torsional friction double the plastic impact (find_reversal), so that nothing creeps down a slope; with
  /// `plain` they are as every other collision, with e near 1.
  MicroCollision(const ContactSystemAssembler& assembler, const ContactResolver& resolver,
                 const Method& method);

  /// The contacts of the cluster that are no stops of joints, all of one pair of bodies, collide once, if
  /// they approach.
  void collide(Cluster& cluster, AdvanceReport& report) const;

 private:
  double slow_speed(const ContactSystem& system, double t) const;

  const ContactSystemAssembler& assembler_;
  const ContactResolver& resolver_;
  RestitutionLaw law_;
  double envelope_;
  bool is_patched_;
};

/// Twice the plastic impact λ. Where everything sticks in that one it is -2 A⁺ u, which reverses the relative
/// velocities of all contacts that press and keeps the kinetic energy; for one contact -2 K⁻¹ u. A contact
/// that slides in it gets the friction μ λ_n of its whole normal impulse, also where that reverses its
/// slip. The energy changes by 2 λ·w = -2 Σ μ λ_n |w_t|, w the velocities after the plastic impact. Nothing
/// if the plastic impact is not found. Source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body
/// Systems, thesis, 1996 (static contact); that sliding contacts double it too is ours
/// (docs/theory/impulse_based.md).
std::optional<ImpactSolution> find_reversal(const ImpactProblem& problem);

}  // namespace rigor
