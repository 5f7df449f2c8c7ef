#include "rigor/contact/resting/rolling_friction.hpp"

#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// Of a body, from the mean of its principal moments [m]; infinite for prescribed bodies.
double radius_of_gyration(const BodyKinetics& body) {
  if (body.inverse_mass == 0) return std::numeric_limits<double>::infinity();
  return std::sqrt(body.inertia.trace() / 3 * body.inverse_mass);
}

/// Moment on B for each unit of λ_n, in W [m].
Vec3 moment_arm(const ContactSystem& system, std::size_t i, double still) {
  const Contact& contact = system.contacts[i];
  const Vec3 w = relative_angular_velocity(system, i);
  const double slow = still / std::min(radius_of_gyration(system.of(contact.body_A)),
                                       radius_of_gyration(system.of(contact.body_B)));
  Vec3 arm = Vec3::Zero();
  const double rolling = std::max(slow, w.head<2>().norm()), spinning = std::max(slow, std::abs(w.z()));
  if (rolling > 0) arm.head<2>() = -contact.rolling_friction / rolling * w.head<2>();
  if (spinning > 0) arm.z() = -contact.torsional_friction / spinning * w.z();
  return system.frames[i] * arm;
}

}  // namespace

Mat6 rolling_friction_delassus(const ContactSystem& system, std::size_t i) {
  if (system.joints) {
    // What joints do about an impulse is part of the response.
    const Eigen::Index row = 6 * static_cast<Eigen::Index>(i);
    return contact_response(moment_rows(system)).block<6, 6>(row, row);
  }
  const Contact& contact = system.contacts[i];
  const Mat3& C = system.frames[i];
  Mat6 K = Mat6::Zero();
  for (const int index : {contact.body_A, contact.body_B}) {
    const BodyKinetics& body = system.of(index);
    // u = v + ω × r; both bodies add alike, since the signs of impulse and velocity cancel.
    Mat6 J = Mat6::Zero();
    J.topLeftCorner<3, 3>() = C.transpose();
    J.topRightCorner<3, 3>() = -C.transpose() * skew(contact.p_W() - body.x);
    J.bottomRightCorner<3, 3>() = C.transpose();
    Mat6 inverse_mass = Mat6::Zero();
    inverse_mass.topLeftCorner<3, 3>().diagonal().setConstant(body.inverse_mass);
    inverse_mass.bottomRightCorner<3, 3>() = body.inverse_inertia;
    K += J * inverse_mass * J.transpose();
  }
  return 0.5 * (K + K.transpose());
}

Vec3 relative_angular_velocity(const ContactSystem& system, std::size_t i) {
  const Contact& contact = system.contacts[i];
  return system.frames[i].transpose() * (system.of(contact.body_B).w - system.of(contact.body_A).w);
}

std::vector<Wrench> with_rolling_friction(const ContactSystem& system,
                                          const std::vector<ContactState>& states,
                                          std::vector<Wrench> wrenches, double direction_tolerance,
                                          double still) {
  if (std::none_of(system.contacts.begin(), system.contacts.end(), resists_rotation)) return wrenches;

  constexpr int most_iterations = 50;
  constexpr double rounding = 1e-15;
  VecX lambda = contact_forces(system, states, wrenches, direction_tolerance);
  std::vector<Wrench> result;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    // The moments of the present normal forces.
    result = wrenches;
    for (std::size_t i = 0; i < system.contacts.size(); ++i) {
      const double normal = std::max(0.0, lambda[3 * static_cast<Eigen::Index>(i) + 2]);
      const Vec3 moment_W = normal * moment_arm(system, i, still);
      result[at(system.local_index(system.contacts[i].body_A))].tau_W -= moment_W;
      result[at(system.local_index(system.contacts[i].body_B))].tau_W += moment_W;
    }

    // The normal forces under them, until these change no more.
    const VecX next = contact_forces(system, states, result, direction_tolerance);
    const double change = (next - lambda).cwiseAbs().maxCoeff();
    lambda = next;
    if (change <= rounding * lambda.cwiseAbs().maxCoeff()) break;
  }
  return result;
}

WorkDone rolling_power(const ContactSystem& system, const std::vector<Wrench>& without,
                       const std::vector<Wrench>& with) {
  WorkDone power;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const double of_body = (with[b].tau_W - without[b].tau_W).dot(system.kinetics[b].w);
    power.friction -= of_body;
    if (system.kinetics[b].inverse_mass == 0) power.supplied -= of_body;
  }
  return power;
}

}  // namespace rigor
