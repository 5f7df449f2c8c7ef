#include "rigor/sim/report/force_uncertainty.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

void note_force_uncertainty(const ContactSystem& system, const VecX& lambda, const Environment& environment,
                            double t, AdvanceReport& report) {
  constexpr double known_share = 1e-10, vouching_share = 1e-3;
  // The largest force on each body, and the sum of all.
  std::vector<double> largest(system.bodies.size(), 0.0);
  std::vector<Vec3> sums(system.bodies.size(), Vec3::Zero());
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (contact.stop) continue;
    const Vec3 force_W = world_impulse(system, lambda, static_cast<int>(i));
    for (const auto& [body, sign] : {std::pair{contact.body_A, -1.0}, std::pair{contact.body_B, 1.0}}) {
      const std::size_t b = at(system.local_index(body));
      largest[b] = std::max(largest[b], force_W.norm());
      sums[b] += sign * force_W;
    }
  }

  // What a share of it does to the body, against its weight, or a part of what all forces together do if that
  // is more: those of a body that rolls fast are known as well as its acceleration is. It is a part, since
  // forces that are wrong must not vouch for themselves.
  for (std::size_t b = 0; b < largest.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) continue;
    const double weight = environment.steady_acceleration(system.bodies[b]).norm();
    if (weight == 0) continue;
    const double inverse_mass = system.kinetics[b].inverse_mass;
    const double share = known_share * largest[b] * inverse_mass /
                         std::max(weight, vouching_share * inverse_mass * sums[b].norm());
    if (share > report.force_uncertainty.share) report.force_uncertainty = {share, system.bodies[b], t};
  }
}

}  // namespace rigor
