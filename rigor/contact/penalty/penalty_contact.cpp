#include "rigor/contact/penalty/penalty_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Of bristles: those that stick come to rest within a few oscillations.
constexpr double bristle_damping_ratio = 0.5;

}  // namespace

PenaltyContact penalty_contact(const PenaltyChoice& choice, const ContactMemory& memory) {
  const auto& v = memory.values;
  return {.spring = {choice.law, v[0], v[1], choice.limit()},
          .speed = v[2],
          .offset = v[3],
          .bristle_stiffness = v[4],
          .bristle_damping = v[5],
          .slip_W = Vec3(v[6], v[7], v[8]),
          .rotation_W = Vec3(v[9], v[10], v[11])};
}

void remember(const PenaltyContact& contact, ContactMemory& memory) {
  memory.values = {contact.spring.stiffness, contact.spring.damping,    contact.speed,
                   contact.offset,           contact.bristle_stiffness, contact.bristle_damping,
                   contact.slip_W.x(),       contact.slip_W.y(),        contact.slip_W.z(),
                   contact.rotation_W.x(),   contact.rotation_W.y(),    contact.rotation_W.z()};
}

ContactMobility contact_mobility(const ContactSystem& system, std::size_t contact) {
  const Contact& geometry = system.contacts[contact];
  Mat3 K = Mat3::Zero();
  for (const auto& [body, J] : {std::pair{geometry.body_A, &system.rows[contact].A},
                                std::pair{geometry.body_B, &system.rows[contact].B}}) {
    const BodyKinetics& of_body = system.of(body);
    K += of_body.inverse_mass * J->leftCols<3>() * J->leftCols<3>().transpose() +
         J->rightCols<3>() * of_body.inverse_inertia * J->rightCols<3>().transpose();
  }
  return {K(2, 2), std::max(K(0, 0), K(1, 1))};
}

PenaltyContact make_penalty_contact(const Contact& contact, const ContactMobility& mobility,
                                    const PenaltyChoice& choice, double speed, double depth) {
  const bool is_bounded = contact.is_bounded_force();
  const double response = is_bounded ? mobility.tangential : mobility.normal;
  PenaltyContact result;
  if (!(response > 0)) return result;  // Nothing that could move along it.
  result.speed = std::max(speed, choice.least_speed);
  result.spring =
      spring_for_impact(choice.law, contact.restitution, 1 / response, result.speed, choice.depth);
  result.spring.limit = choice.limit();
  if (choice.stiffness) {
    // Of the law of Hunt and Crossley: the secant to the stated depth.
    const double scale = choice.law == PenaltyNormalLaw::linear ? 1 : 1 / std::sqrt(choice.depth);
    const double ratio = *choice.stiffness * scale / result.spring.stiffness;
    result.spring.stiffness *= ratio;
    if (choice.law == PenaltyNormalLaw::linear) result.spring.damping *= std::sqrt(ratio);
  }
  if (speed <= calm_share * choice.least_speed) result = damped_for_rest(result, choice.depth);
  if (choice.damping) {
    result.spring.damping = choice.law == PenaltyNormalLaw::linear
                                ? *choice.damping
                                : *choice.damping / (result.spring.stiffness * std::pow(choice.depth, 1.5));
  }
  result.offset = depth > choice.depth ? depth : 0;
  return contact.friction > 0 ? with_bristle(result, mobility, choice.depth) : result;
}

PenaltyContact with_bristle(PenaltyContact contact, const ContactMobility& mobility, double depth) {
  if (!(mobility.tangential > 0)) return contact;
  contact.bristle_stiffness = stiffness_at(contact.spring, depth);
  contact.bristle_damping =
      2 * bristle_damping_ratio * std::sqrt(contact.bristle_stiffness / mobility.tangential);
  return contact;
}

PenaltyContact made_for_speed(PenaltyContact contact, double speed) {
  if (!(contact.speed > 0)) return contact;
  const double ratio = speed / contact.speed;
  const bool is_linear = contact.spring.law == PenaltyNormalLaw::linear;
  contact.spring.stiffness *= ratio * ratio;
  contact.spring.damping *= is_linear ? ratio : 1 / ratio;
  contact.bristle_stiffness *= ratio * ratio;
  contact.bristle_damping *= ratio;
  contact.speed = speed;
  return contact;
}

PenaltyContact damped_for_rest(PenaltyContact contact, double depth) {
  if (!(contact.speed > 0)) return contact;
  // Linear: c = 2 ζ √(k m) = 2 ζ k / ω, ω = speed / depth.
  constexpr double ratio = 0.5, restitution = 0.3;
  contact.spring.damping = contact.spring.law == PenaltyNormalLaw::linear
                               ? 2 * ratio * contact.spring.stiffness * depth / contact.speed
                               : hunt_crossley_damping(restitution) / contact.speed;
  return contact;
}

PenaltyContact pressed_by(PenaltyContact contact, const Vec3& force, const Mat3& frame, double gap) {
  contact.offset = -gap - depth_under(contact.spring, force.z());
  if (contact.bristle_stiffness > 0)
    contact.slip_W = frame.leftCols<2>() * (-1 / contact.bristle_stiffness * force.head<2>());
  return contact;
}

double pressed_depth(const PenaltyContact& contact, double gap) {
  return std::max(0.0, -gap - contact.offset);
}

double normal_energy(const PenaltyContact& contact, double gap) {
  return stored_energy(contact.spring, pressed_depth(contact, gap));
}

double bristle_energy(const Contact& geometry, const PenaltyContact& contact) {
  // The bristle of a motor is a part of the motor: what goes into it has not been supplied.
  if (geometry.is_motor()) return 0;
  const double rho = geometry.rolling_friction, sigma = geometry.torsional_friction;
  const Vec3 n = geometry.point.n_W;
  const double spin = contact.rotation_W.dot(n);
  const double roll = (contact.rotation_W - spin * n).squaredNorm();
  return 0.5 * contact.bristle_stiffness *
         (contact.slip_W.squaredNorm() + rho * rho * roll + sigma * sigma * spin * spin);
}

double friction_limit(const Contact& geometry, const ContactJacobian& rows, double normal_force) {
  return geometry.is_bounded_force() ? rows.load : geometry.friction * normal_force;
}

Vec2 bristle_force(const PenaltyContact& contact, const Mat3& frame, const Vec3& u, double limit) {
  const Vec2 slip = (frame.transpose() * contact.slip_W).head<2>();
  const Vec2 force = -(contact.bristle_stiffness * slip + contact.bristle_damping * u.head<2>());
  const double size = force.norm();
  return size > limit ? Vec2(force * (limit / size)) : force;
}

void move_bristle(const Mat3& frame, const Vec2& slip, PenaltyContact& contact) {
  const Vec2 kept = (frame.transpose() * contact.slip_W).head<2>();
  const double length = kept.norm();
  const Vec2 carried = length > 0 ? Vec2(kept * (contact.slip_W.norm() / length)) : kept;
  contact.slip_W = frame.leftCols<2>() * (carried + slip);
}

void slide_bristle(double limit, PenaltyContact& contact) {
  const double force = contact.bristle_stiffness * contact.slip_W.norm();
  if (force > limit) contact.slip_W *= limit / force;
}

}  // namespace rigor
