#include "rigor/sim/islands/displacement.hpp"

#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <algorithm>
#include <optional>

namespace rigor {

VecX separating_impulses(const ContactSystem& system, const std::vector<double>& lowest) {
  // The Coulomb problem without friction, with displacements for velocities: A δ + gap - lowest.
  const std::size_t count = system.contacts.size();
  CoulombProblem problem{MatX(), VecX::Zero(3 * static_cast<Eigen::Index>(count)),
                         std::vector<double>(count, 0.0), std::vector<FrictionRow>(count, FrictionRow::cone),
                         std::vector<Vec2>(count, Vec2::Zero())};
  for (std::size_t i = 0; i < count; ++i) {
    const Contact& contact = system.contacts[i];
    problem.b[3 * static_cast<Eigen::Index>(i) + 2] =
        contact.stop ? std::max(0.0, contact.point.gap) : contact.point.gap - lowest[i];
  }

  // Of many contacts on the sparse rows: any share of the load makes the same displacements. What they miss
  // is a ten-millionth of the overlaps, which is looked for afterwards anyway; pivoting on a thousand rows
  // for more digits takes a minute.
  constexpr std::size_t most_in_dense_methods = 16;
  constexpr double accepted_miss = 1e-7;
  const bool has_stops = std::any_of(system.contacts.begin(), system.contacts.end(),
                                     [](const Contact& contact) { return contact.stop.has_value(); });
  if (count > most_in_dense_methods && !system.joints && !has_stops) {
    CoulombOptions options;
    options.least_norm = false;
    options.resolution = 0;
    options.enough = accepted_miss;
    const std::optional<CoulombSolution> found =
        solve_in_motion_space({motion_rows(system), problem}, {}, options);
    if (found && found->residual <= accepted_miss) return found->lambda;
  }
  problem.A = delassus(system);
  return solve_coulomb(problem).lambda;
}

void apply_displacement(const VecX& delta, ContactSystem system, const std::vector<int>& bodies,
                        std::vector<BodyPhase>& phases) {
  // M⁻¹ Jᵀ δ, as velocities from rest.
  for (BodyKinetics& body : system.kinetics) body.v = body.w = Vec3::Zero();
  apply_impulses(delta, system);

  // x, q, and L, so that L + x × P stays.
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyKinetics& moved = system.of(bodies[i]);
    phases[i].x += moved.v;
    phases[i].L -= moved.v.cross(phases[i].P);
    phases[i].q = (rotation_exp(moved.w) * phases[i].q).normalized();
  }
}

void keep_angular_momenta(const std::vector<BodyPhase>& before, std::vector<BodyPhase>& phases) {
  for (std::size_t i = 0; i < phases.size(); ++i)
    phases[i].L -= (phases[i].x - before[i].x).cross(phases[i].P);
}

}  // namespace rigor
