#pragma once

#include "rigor/contact/system/contact_system.hpp"

#include <vector>

namespace rigor {

/// Springs between points of a group's bodies as rows of its step: the impulse ν of a spring along its line
/// leaves the rate u⁺ of its length with
///
///   u⁺ + softness ν + drive = 0.
///
/// ν is h times the force at a mean of the beginning and the end of the step, so that stiffness and damping
/// resist the impulses of contacts in it, as in (M + h θ D + h² θ² K) ΔV. Derivation:
/// docs/theory/time_stepping.md.
struct SpringRows {
  /// An end of a spring half way through the step.
  struct End {
    int body;  ///< Model index; world_body.
    Vec3 p_W, v_W;
  };
  std::vector<End> ends_A, ends_B;
  std::vector<Vec3> lines;  ///< From end A to end B, unit, in W.
  VecX softness;            ///< [1/kg].
  VecX drive;               ///< [m/s].
  VecX rates;               ///< u at the end of the step without springs and contacts [m/s].

  std::size_t count() const { return lines.size(); }
};

/// Beginning t [s] and length h [s] of a step, and the mean θ that it takes: displacements are
/// h ((1 - θ) u + θ u⁺).
struct StepSpan {
  double t, h, theta;
};

/// Finds the rows of a model's springs. Holds a reference to the model.
class ImplicitSprings {
 public:
  explicit ImplicitSprings(const Model& model);

  bool has_any() const { return !springs_.empty(); }
  /// Whether these bodies (ascending) have springs for which h is long, and none that is so taut that its
  /// stiffness across its line matters too. `begin`: all bodies of the group at the beginning of the step.
  bool are_stiff(const StepSpan& span, const std::vector<int>& bodies, const ContactSystem& begin) const;
  /// The rows at the places of `middle`, half way through the step, whose velocities are those of its end
  /// without springs and contacts.
  SpringRows rows(const StepSpan& span, const std::vector<int>& bodies, const ContactSystem& begin,
                  const ContactSystem& middle) const;

 private:
  std::vector<const Spring*> springs_of(const std::vector<int>& bodies) const;
  BodyKinetics end_body(int body, double t, const ContactSystem& system) const;

  const Model& model_;
  std::vector<const Spring*> springs_;
};

/// What prescribed bodies and the world supply through springs: an impulse with its moment about the origin
/// of W, and work [J].
struct OutsideImpulse {
  Wrench impulse;
  double work = 0;
};
/// Adds the impulses ν of the rows, one per spring, to those of the bodies of the system.
OutsideImpulse add_spring_impulses(const SpringRows& rows, const VecX& nu, const ContactSystem& system,
                                   std::vector<Wrench>& impulses);

}  // namespace rigor
