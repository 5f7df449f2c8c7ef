#include "rigor/contact/resting/paradox.hpp"

#include "rigor/contact/resting/resting.hpp"
#include "rigor/solver/coulomb/coulomb_local.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

namespace {

Paradox paradox_of(int solutions) {
  if (solutions == 1) return {};
  return {solutions == 0 ? Paradox::Kind::inconsistent : Paradox::Kind::indeterminate, 0};
}

Paradox find_paradox_of_one(const ContactSystem& system, const std::vector<Wrench>& wrenches, const Vec2& u_t,
                            double slip_tolerance) {
  // A contact that slips: its sliding equation alone. One that may stick: all solutions of its local problem.
  const Mat3 K = delassus(system);
  const Vec3 b = free_contact_accelerations(system, wrenches);
  const double mu = system.contacts.front().friction;
  if (u_t.norm() > slip_tolerance)
    return paradox_of(count_sliding_solutions(sliding_response(K, mu, u_t.normalized()), b[2]));
  // Joints can make K singular: then only w is unique, and that is enough.
  if (system.joints) return {};
  return paradox_of(static_cast<int>(solve_coulomb_local_all(K, b, mu).size()));
}

}  // namespace

Paradox find_paradox(const ContactSystem& system, const std::vector<Wrench>& wrenches, double slip_tolerance,
                     bool have_forces) {
  const std::size_t count = system.contacts.size();
  const bool is_one = count == 1 && !system.contacts.front().stop;
  if (!is_one && have_forces) return {};
  const VecX u = relative_velocities(system);
  if (is_one) return find_paradox_of_one(system, wrenches, u.head<2>(), slip_tolerance);

  // Several contacts without forces: the one whose friction helps pressing most is named.
  const MatX A = delassus(system);
  Paradox paradox;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const Vec2 u_t = u.segment<2>(row);
    const Contact& contact = system.contacts[i];
    if (contact.stop || contact.friction == 0 || u_t.norm() <= slip_tolerance) continue;
    const double response = sliding_response(A.block<3, 3>(row, row), contact.friction, u_t.normalized());
    if (response < least) paradox = {Paradox::Kind::inconsistent, i};
    least = std::min(least, response);
  }
  return paradox;
}

}  // namespace rigor
