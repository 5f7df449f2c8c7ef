#include "rigor/contact/contact_system.hpp"

#include "rigor/contact/contact_kinematics.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

int ContactSystem::local_index(int body) const {
  const auto place = std::lower_bound(bodies.begin(), bodies.end(), body);
  RIGOR_ASSERT(place != bodies.end() && *place == body);
  return static_cast<int>(place - bodies.begin());
}

ContactSystem make_contact_system(std::vector<Contact> contacts, std::vector<int> bodies,
                                  std::vector<BodyKinetics> kinetics) {
  ContactSystem system{std::move(contacts), std::move(bodies), std::move(kinetics), {}};
  RIGOR_ASSERT(system.bodies.size() == system.kinetics.size());
  for (const Contact& contact : system.contacts) system.frames.push_back(frame_with_z(contact.point.n_W));
  return system;
}

namespace {

/// Impulse at p on a body gives a velocity at q: (1/m) 1 - r~_q I⁻¹ r~_p.
Mat3 mobility(const BodyKinetics& body, const Vec3& q_W, const Vec3& p_W) {
  Mat3 result = -skew(q_W - body.x) * body.inverse_inertia * skew(p_W - body.x);
  result.diagonal().array() += body.inverse_mass;
  return result;
}

struct Side {
  int contact;
  double sign;  ///< +1 on B, -1 on A.
  Vec3 p_W;
};

/// For each body of the system the contacts that act on it.
std::vector<std::vector<Side>> sides_by_body(const ContactSystem& system) {
  std::vector<std::vector<Side>> sides(system.bodies.size());
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const int index = static_cast<int>(i);
    sides[static_cast<std::size_t>(system.local_index(contact.body_A))].push_back({index, -1, contact.p_W()});
    sides[static_cast<std::size_t>(system.local_index(contact.body_B))].push_back({index, 1, contact.p_W()});
  }
  return sides;
}

}  // namespace

MatX delassus(const ContactSystem& system) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(system.contacts.size());
  MatX A = MatX::Zero(size, size);
  const std::vector<std::vector<Side>> sides = sides_by_body(system);
  for (std::size_t b = 0; b < sides.size(); ++b) {
    const BodyKinetics& body = system.kinetics[b];
    if (body.inverse_mass == 0) continue;
    for (const Side& of_i : sides[b]) {
      for (const Side& of_k : sides[b]) {
        if (of_k.contact > of_i.contact) continue;
        const Mat3& C_i = system.frames[static_cast<std::size_t>(of_i.contact)];
        const Mat3& C_k = system.frames[static_cast<std::size_t>(of_k.contact)];
        A.block<3, 3>(3 * of_i.contact, 3 * of_k.contact) +=
            of_i.sign * of_k.sign * (C_i.transpose() * mobility(body, of_i.p_W, of_k.p_W) * C_k);
      }
    }
  }
  // Exactly symmetric: the upper triangle is the lower one.
  A.triangularView<Eigen::StrictlyUpper>() = A.transpose();
  return A;
}

VecX relative_velocities(const ContactSystem& system) {
  VecX u(3 * static_cast<Eigen::Index>(system.contacts.size()));
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    u.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        relative_velocity(contact, system.of(contact.body_A), system.of(contact.body_B));
  }
  return u;
}

Vec3 world_impulse(const ContactSystem& system, const VecX& lambda, int i) {
  return system.frames[static_cast<std::size_t>(i)] * lambda.segment<3>(3 * i);
}

void apply_impulses(const VecX& lambda, ContactSystem& system) {
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const Vec3 j_W = world_impulse(system, lambda, static_cast<int>(i));
    BodyKinetics& A = system.of(contact.body_A);
    BodyKinetics& B = system.of(contact.body_B);
    A.v -= A.inverse_mass * j_W;
    A.w -= A.inverse_inertia * (contact.p_W() - A.x).cross(j_W);
    B.v += B.inverse_mass * j_W;
    B.w += B.inverse_inertia * (contact.p_W() - B.x).cross(j_W);
  }
}

double kinetic_energy(const ContactSystem& system) {
  double energy = 0;
  for (const BodyKinetics& body : system.kinetics) {
    if (body.inverse_mass == 0) continue;
    energy += 0.5 * body.v.squaredNorm() / body.inverse_mass + 0.5 * body.w.dot(body.inertia * body.w);
  }
  return energy;
}

double work_of_prescribed(const ContactSystem& system, const VecX& lambda) {
  double work = 0;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const Vec3 j_W = world_impulse(system, lambda, static_cast<int>(i));
    const BodyKinetics& A = system.of(contact.body_A);
    const BodyKinetics& B = system.of(contact.body_B);
    if (A.inverse_mass == 0) work += j_W.dot(A.velocity_at(contact.p_W()));
    if (B.inverse_mass == 0) work -= j_W.dot(B.velocity_at(contact.p_W()));
  }
  return work;
}

}  // namespace rigor
