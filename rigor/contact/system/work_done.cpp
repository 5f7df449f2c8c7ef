#include "rigor/contact/system/work_done.hpp"

namespace rigor {

std::vector<Vec6> velocities_of(const ContactSystem& system) {
  std::vector<Vec6> result(system.bodies.size());
  for (std::size_t b = 0; b < result.size(); ++b) result[b] << system.kinetics[b].v, system.kinetics[b].w;
  return result;
}

std::vector<Vec6> mean_velocities(const ContactSystem& system, const std::vector<Wrench>& impulses) {
  std::vector<Vec6> result = velocities_of(system);
  for (std::size_t b = 0; b < result.size(); ++b) {
    const BodyKinetics& body = system.kinetics[b];
    result[b].head<3>() += 0.5 * body.inverse_mass * impulses[b].f_W;
    result[b].tail<3>() += 0.5 * (body.inverse_inertia * impulses[b].tau_W);
  }
  return result;
}

WorkDone work_of_contacts(const ContactSystem& system, const VecX& lambda,
                          const std::vector<Vec6>& velocities) {
  WorkDone work;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const ContactJacobian& rows = system.rows[i];
    const Vec3 own = lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
    const std::size_t a = at(system.local_index(contact.body_A)), b = at(system.local_index(contact.body_B));
    const Vec3 of_A = rows.A * velocities[a], of_B = rows.B * velocities[b];

    // What prescribed bodies do against the force on them.
    if (system.kinetics[a].inverse_mass == 0) work.supplied -= own.dot(of_A);
    if (system.kinetics[b].inverse_mass == 0) work.supplied -= own.dot(of_B);

    // Along the tangents a motor does work, and friction takes it.
    const double power = own.head<2>().dot((of_A + of_B).head<2>());
    if (contact.is_motor()) {
      work.supplied += power;
      work.motors += power;
    } else {
      work.friction -= power;
    }
  }
  return work;
}

WorkDone work_of_joints(const JointSystem& joints, const VecX& lambda, const VecX& rate_errors) {
  WorkDone work;
  work.motors = joints.power_of_motors(lambda, rate_errors);
  work.supplied = work.motors + joints.power_of_prescribed(lambda);
  return work;
}

}  // namespace rigor
