#pragma once

#include "rigor/contact/contact.hpp"
#include "rigor/solver/coulomb_problem.hpp"

#include <vector>

namespace rigor {

/// A set of contacts at an instant with all bodies they touch: what contact space is built from. Velocities
/// of the n contacts are stacked as u = (t1, t2, n) of contact 0, of contact 1, ...
struct ContactSystem {
  std::vector<Contact> contacts;
  std::vector<int> bodies;  ///< Model indices, ascending; of the contacts' bodies and any others wanted.
  std::vector<BodyKinetics> kinetics;  ///< One a body of `bodies`.
  std::vector<Mat3> frames;            ///< C = [t1 t2 n] of each contact.

  /// Position of a body in `bodies`, which must hold it.
  int local_index(int body) const;
  const BodyKinetics& of(int body) const { return kinetics[static_cast<std::size_t>(local_index(body))]; }
  BodyKinetics& of(int body) { return kinetics[static_cast<std::size_t>(local_index(body))]; }
};

/// The system of these contacts; `bodies` must be ascending and hold every body of the contacts.
ContactSystem make_contact_system(std::vector<Contact> contacts, std::vector<int> bodies,
                                  std::vector<BodyKinetics> kinetics);

/// Delassus operator A = J M⁻¹ Jᵀ (3n × 3n): Δu = A λ for impulses λ at the contacts.
MatX delassus(const ContactSystem& system);

/// u = J V (3n) [m/s].
VecX relative_velocities(const ContactSystem& system);

/// Adds M⁻¹ Jᵀ λ to the velocities of the bodies; λ (3n) in the contact frames [N s].
void apply_impulses(const VecX& lambda, ContactSystem& system);

/// Impulse of contact i in W [N s] (or force, if λ are forces): +on B, -on A.
Vec3 world_impulse(const ContactSystem& system, const VecX& lambda, int i);

/// Kinetic energy of the dynamic bodies [J].
double kinetic_energy(const ContactSystem& system);

/// Work that prescribed bodies (kinematic) do on the others through the impulses λ: Σ λ · (velocity of the
/// prescribed side) [J]; a power if λ are forces.
double work_of_prescribed(const ContactSystem& system, const VecX& lambda);

}  // namespace rigor
