#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/model/contact_key.hpp"
#include "rigor/model/model.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A coordinate of a joint that acts like a contact: at a limit, or held by a force that is bounded.
struct JointStop {
  enum class Kind {
    lower,     ///< The coordinate is at its lower limit: a normal along it.
    upper,     ///< The same at the upper limit, in the opposite direction.
    friction,  ///< Dry friction holds the rate at zero, with |force| ≤ its largest.
    motor,     ///< A motor holds the rate at its velocity, with |force| ≤ its largest.
  };
  int joint;  ///< Model index.
  int axis;   ///< Coordinate.
  Kind kind;
};

/// A contact between shapes of two bodies, at an instant. The normal points from A to B; impulses λ push B
/// along +n and A along -n.
struct Contact {
  int body_A, body_B;    ///< Indices into the model; at least one is dynamic.
  int shape_A, shape_B;  ///< Indices into the bodies' shapes.
  ContactPoint point;
  double friction;                    ///< μ of the pair.
  double restitution;                 ///< e of the pair.
  double rolling_friction = 0;        ///< ρ of the pair [m].
  double torsional_friction = 0;      ///< σ of the pair [m].
  double tangential_restitution = 0;  ///< e_t of the pair; 0: none.
  double static_friction = 0;         ///< μ_s of the pair; less than μ: as μ.
  /// Set for a row of a joint's coordinate: there are no shapes then (negative numbers that tell stops
  /// apart), the frame is that of W, body_A is body_B where the other one is the world, and n (limits) or t1
  /// (friction, motors) is the coordinate.
  std::optional<JointStop> stop = std::nullopt;

  /// Whether it is dry friction or a motor: nothing there could open or collide.
  bool is_bounded_force() const {
    return stop && (stop->kind == JointStop::Kind::friction || stop->kind == JointStop::Kind::motor);
  }

  bool is_motor() const { return stop && stop->kind == JointStop::Kind::motor; }

  /// Whether what sticks is held by more than μ λ_n.
  bool has_static_friction() const { return !stop && static_friction > friction; }

  ContactKey key() const { return {body_A, body_B, shape_A, shape_B, point.feature}; }

  /// Where impulses act, on both bodies alike so that angular momentum is exact: half way between the witness
  /// points [m].
  Vec3 p_W() const { return 0.5 * (point.p_WA + point.p_WB); }
};

/// Where a body is, how it moves and how it resists, at an instant; all in W, about the centre of mass.
struct BodyKinetics {
  Vec3 x = Vec3::Zero();                ///< p_WB [m].
  Mat3 R = Mat3::Identity();            ///< R_WB.
  Vec3 v = Vec3::Zero();                ///< [m/s].
  Vec3 w = Vec3::Zero();                ///< [rad/s].
  double inverse_mass = 0;              ///< [1/kg]; 0 for kinematic and fixed bodies.
  Mat3 inverse_inertia = Mat3::Zero();  ///< I⁻¹ in W [1/(kg m²)]; 0 as above.
  Mat3 inertia = Mat3::Zero();          ///< I in W [kg m²]; 0 as above.

  Pose pose() const { return {R, x}; }
  /// Velocity of the material point at p_WP [m/s].
  Vec3 velocity_at(const Vec3& p_WP) const { return v + w.cross(p_WP - x); }
};

/// Kinetics of a dynamic body at a phase.
BodyKinetics dynamic_kinetics(const Body& body, const BodyPhase& phase);
/// Kinetics of a kinematic or fixed body at time t.
BodyKinetics prescribed_kinetics(const Body& body, double t);

/// All contacts of two bodies closer than the tolerance [m], in the order of shapes and features. A point
/// that two shapes of a body share (a common corner) is listed once.
std::vector<Contact> find_contacts(const Model& model, int a, int b, const Pose& X_WA, const Pose& X_WB,
                                   double tolerance);
/// The same up to a gap beyond the tolerance.
std::vector<Contact> find_contacts(const Model& model, int a, int b, const Pose& X_WA, const Pose& X_WB,
                                   const ContactReach& within);

/// The contacts of bodies that move: where shapes meet at edges or corners, those along the direction in
/// which they part fastest (parting_contacts.hpp).
std::vector<Contact> find_contacts(const Model& model, int a, int b, const BodyKinetics& A,
                                   const BodyKinetics& B, double tolerance);

}  // namespace rigor
