#include "rigor/sim/penalty/penalty_forces.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Normal force of contact i at its relative velocity u; none of forces with a largest value.
double normal_force_at(const Touching& touching, std::size_t i, const Vec3& u) {
  const Contact& contact = touching.system.contacts[i];
  if (contact.is_bounded_force()) return 0;
  const PenaltyContact& spring = touching.springs[i];
  return normal_force(spring.spring, pressed_depth(spring, contact.point.gap), -u.z());
}

Vec3 velocity_at(const VecX& u, std::size_t i) {
  return u.segment<3>(3 * static_cast<Eigen::Index>(i));
}

bool has_moments(const Contact& contact) {
  return !contact.stop && (contact.rolling_friction > 0 || contact.torsional_friction > 0);
}

Vec3 relative_angular_velocity(const ContactSystem& system, const Contact& contact) {
  return system.of(contact.body_B).w - system.of(contact.body_A).w;
}

/// v, shortened to the limit if it is longer.
Vec3 shortened(const Vec3& v, double limit) {
  const double length = v.norm();
  return length > limit ? Vec3(v * (limit / length)) : v;
}

/// Parts of v along n and across it.
struct Parts {
  Vec3 along, across;
};
Parts parts_of(const Vec3& v, const Vec3& n) {
  const Vec3 along = v.dot(n) * n;
  return {along, v - along};
}

/// Moment on B at relative angular velocity w: a bristle of angles, stiff and damped as that of slip at the
/// arms ρ and σ, bounded by ρ f_n across the normal and by σ f_n along it.
Vec3 moment_on_B(const Contact& contact, const PenaltyContact& spring, const Vec3& w, double f_n) {
  const double rho = contact.rolling_friction, sigma = contact.torsional_friction;
  // Spring and damper of the bristle [N/m rad], before the arms.
  const Parts parts =
      parts_of(spring.bristle_stiffness * spring.rotation_W + spring.bristle_damping * w, contact.point.n_W);
  return -shortened(rho * rho * parts.across, rho * f_n) -
         shortened(sigma * sigma * parts.along, sigma * f_n);
}

}  // namespace

VecX penalty_forces(const Touching& touching) {
  const ContactSystem& system = touching.system;
  const VecX u = relative_velocities(system);
  VecX forces(u.size());
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    // Normal force of the spring and its damper; friction of the bristle, bounded by Coulomb's cone.
    const Vec3 own = velocity_at(u, i);
    const double f_n = normal_force_at(touching, i, own);
    const double limit = friction_limit(system.contacts[i], system.rows[i], f_n);
    const Vec2 f_t = bristle_force(touching.springs[i], system.frames[i], own, limit);
    forces.segment<3>(3 * static_cast<Eigen::Index>(i)) = Vec3(f_t.x(), f_t.y(), f_n);
  }
  return forces;
}

namespace {

/// Moments of all contacts that resist rotation; on_B(i, w): that of contact i on B at relative angular
/// velocity w.
template <class OnB>
PenaltyMoments summed_moments(const Touching& touching, const OnB& on_B) {
  const ContactSystem& system = touching.system;
  PenaltyMoments moments;
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (!has_moments(contact)) continue;
    moments.wrenches.resize(system.bodies.size());
    const Vec3 w = relative_angular_velocity(system, contact);
    const Vec3 tau = on_B(i, w);
    moments.power_taken -= tau.dot(w);
    // The moment acts on B, its opposite on A.
    for (const auto& [body, sign] : {std::pair{contact.body_A, -1.0}, std::pair{contact.body_B, 1.0}}) {
      const BodyKinetics& kinetics = system.of(body);
      if (kinetics.inverse_mass > 0) {
        moments.wrenches[at(system.local_index(body))].tau_W += sign * tau;
      } else {
        // A prescribed body takes its moment from outside, and exerts the opposite on the other body.
        moments.external_W -= sign * tau;
        moments.power_of_prescribed -= sign * tau.dot(kinetics.w);
      }
    }
  }
  return moments;
}

}  // namespace

PenaltyMoments penalty_moments(const Touching& touching, const VecX& forces) {
  return summed_moments(touching, [&](std::size_t i, const Vec3& w) {
    return moment_on_B(touching.system.contacts[i], touching.springs[i], w, velocity_at(forces, i).z());
  });
}

PenaltyMoments stopping_moments(const Touching& touching, const VecX& forces, double h) {
  const ContactSystem& system = touching.system;
  // Contacts of each body: they share the moment that stops it.
  std::vector<double> sharers(system.bodies.size(), 0);
  for (const Contact& contact : system.contacts) {
    if (!has_moments(contact)) continue;
    for (const int body : {contact.body_A, contact.body_B}) sharers[at(system.local_index(body))] += 1;
  }
  return summed_moments(touching, [&](std::size_t i, const Vec3& w) {
    const Contact& contact = system.contacts[i];
    // The moment that stops the relative rotation within h, as if each contact had its share of the bodies.
    double mobility = 0;
    for (const int body : {contact.body_A, contact.body_B})
      mobility += sharers[at(system.local_index(body))] * system.of(body).inverse_inertia.trace();
    const Parts parts = parts_of(w / (h * mobility), contact.point.n_W);
    // Within the same limits as the bristles.
    const double f_n = velocity_at(forces, i).z();
    return Vec3(-shortened(parts.across, contact.rolling_friction * f_n) -
                shortened(parts.along, contact.torsional_friction * f_n));
  });
}

void move_bristles(double h, Touching& touching) {
  const VecX u = relative_velocities(touching.system);
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    PenaltyContact& spring = touching.springs[i];
    const Contact& contact = touching.system.contacts[i];
    if (!(spring.bristle_stiffness > 0)) continue;
    // Bristles follow the slip and the relative rotation while they touch.
    const double t = touching.share_touched[i] * h;
    move_bristle(touching.system.frames[i], t * velocity_at(u, i).head<2>(), spring);
    if (has_moments(contact)) spring.rotation_W += t * relative_angular_velocity(touching.system, contact);
  }
}

void slide_bristles(Touching& touching) {
  const VecX u = relative_velocities(touching.system);
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    PenaltyContact& spring = touching.springs[i];
    const Contact& contact = touching.system.contacts[i];
    if (!(spring.bristle_stiffness > 0)) continue;
    // Sliding: the bristle of slip shrinks to what the friction limit holds.
    const double f_n = normal_force_at(touching, i, velocity_at(u, i));
    slide_bristle(friction_limit(contact, touching.system.rows[i], f_n), spring);
    if (!has_moments(contact)) continue;
    // Rolling and spinning: k ρ² |φ| ≤ ρ f_n across the normal, and likewise with σ along it.
    const Parts angle = parts_of(spring.rotation_W, contact.point.n_W);
    const double rho = contact.rolling_friction, sigma = contact.torsional_friction;
    spring.rotation_W = Vec3::Zero();
    if (rho > 0) spring.rotation_W += shortened(angle.across, f_n / (rho * spring.bristle_stiffness));
    if (sigma > 0) spring.rotation_W += shortened(angle.along, f_n / (sigma * spring.bristle_stiffness));
  }
}

ElasticEnergies elastic_energies(const Touching& touching) {
  ElasticEnergies energies;
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    const Contact& contact = touching.system.contacts[i];
    energies.normal += normal_energy(touching.springs[i], contact.point.gap);
    energies.bristles += bristle_energy(contact, touching.springs[i]);
  }
  return energies;
}

}  // namespace rigor
