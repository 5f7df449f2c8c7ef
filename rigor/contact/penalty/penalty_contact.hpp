#pragma once

#include "rigor/contact/penalty/penalty_law.hpp"
#include "rigor/contact/system/contact_system.hpp"
#include "rigor/model/contact_memory.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace rigor {

/// How stiff and how damped penalty contacts are.
struct PenaltyChoice {
  PenaltyNormalLaw law = PenaltyNormalLaw::linear;
  double depth = 1e-4;                   ///< How deep an impact presses [m].
  double least_speed = 1e-3;             ///< Slower approaches count as this fast [m/s].
  std::optional<double> stiffness = {};  ///< Instead of what the depth asks for [N/m].
  std::optional<double> damping = {};    ///< Instead of what the restitution asks for [N s/m].
  bool hardens = false;                  ///< Beyond the depth, with room for the error of a sub-step.

  /// PenaltySpring::limit [m].
  double limit() const { return hardens ? 1.25 * depth : std::numeric_limits<double>::infinity(); }
};

/// The springs and dampers of one contact: a normal spring and, with friction, a bristle across it that a
/// slider keeps from carrying more than the cone allows; a bristle of angles for rolling and torsional
/// friction. Dry friction and motors of joints are bristles whose slider has a constant limit.
///
/// A contact that is first seen deeper than an impact presses counts its depth from `offset` on, so that
/// bodies which begin inside each other are held where they are and not thrown apart. One that begins at rest
/// and carries a force counts it from before the touch (a negative offset), so that it need not sink first.
struct PenaltyContact {
  PenaltySpring spring;
  double speed = 0;                ///< Approach that the spring is made for [m/s].
  double offset = 0;               ///< Depth at which the spring begins to push [m].
  double bristle_stiffness = 0;    ///< [N/m].
  double bristle_damping = 0;      ///< [N s/m].
  Vec3 slip_W = Vec3::Zero();      ///< Deflection of the bristle [m], of B against A.
  Vec3 rotation_W = Vec3::Zero();  ///< The same of the bristle of angles [rad].
};

/// What `memory.values` say, and the other way round.
PenaltyContact penalty_contact(const PenaltyChoice& choice, const ContactMemory& memory);
void remember(const PenaltyContact& contact, ContactMemory& memory);

/// Response of a contact alone: 1/m_eff along its normal and across it (the larger) [1/kg].
struct ContactMobility {
  double normal = 0;
  double tangential = 0;
};
ContactMobility contact_mobility(const ContactSystem& system, std::size_t contact);

/// A contact that moves and is pressed less than this share of what its spring is made for lies still.
inline constexpr double calm_share = 0.1;

/// A fresh contact that approaches at `speed` [m/s] (separating ones: 0) and is seen at `depth` [m].
PenaltyContact make_penalty_contact(const Contact& contact, const ContactMobility& mobility,
                                    const PenaltyChoice& choice, double speed, double depth);
/// The same contact with an undeflected bristle, as friction asks for.
PenaltyContact with_bristle(PenaltyContact contact, const ContactMobility& mobility, double depth);
/// The same spring made for another speed: stiffnesses go with its square, dampers keep their ratios.
PenaltyContact made_for_speed(PenaltyContact contact, double speed);

/// The same spring with the dampers of a contact that lies still, whatever its restitution is: half of the
/// critical damping [linear], or a restitution of 0.3.
PenaltyContact damped_for_rest(PenaltyContact contact, double depth);

/// A contact that stands at this gap [m] and carries this force on B (contact frame) [N], which lies in the
/// cone: its springs are pressed as far as that asks.
PenaltyContact pressed_by(PenaltyContact contact, const Vec3& force, const Mat3& frame, double gap);

/// Overlap that counts [m]; 0 for dry friction and motors.
double pressed_depth(const PenaltyContact& contact, double gap);
/// Elastic energy of normal springs and of bristles [J].
double normal_energy(const PenaltyContact& contact, double gap);
double bristle_energy(const Contact& geometry, const PenaltyContact& contact);

/// The largest force that friction has at this normal force [N]: μ f_n, or the load of a stop.
double friction_limit(const Contact& geometry, const ContactJacobian& rows, double normal_force);
/// Force of the bristle in the contact frame, at relative velocity u of the contact: -(k_t ξ + c_t u) within
/// the limit [N].
Vec2 bristle_force(const PenaltyContact& contact, const Mat3& frame, const Vec3& u, double limit);

/// Bristle after the contact frame rotated and the bodies moved by slip (2, in the frame) [m]: in the new
/// tangent plane, as long as it was.
void move_bristle(const Mat3& frame, const Vec2& slip, PenaltyContact& contact);
/// Lets the slider slip until the bristle carries no more than the limit [N].
void slide_bristle(double limit, PenaltyContact& contact);

}  // namespace rigor
