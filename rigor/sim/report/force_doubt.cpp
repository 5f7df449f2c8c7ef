#include "rigor/sim/report/force_doubt.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {

void note_force_doubt(const ContactSystem& system, const VecX& lambda, const Environment& environment,
                      double t, AdvanceReport& report) {
  constexpr double known_share = 1e-10;
  // The largest force on each body.
  std::vector<double> largest(system.bodies.size(), 0.0);
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (contact.stop) continue;
    const double force = lambda.segment<3>(3 * static_cast<Eigen::Index>(i)).norm();
    for (const int body : {contact.body_A, contact.body_B}) {
      double& of_body = largest[at(system.local_index(body))];
      of_body = std::max(of_body, force);
    }
  }

  // What a share of it does to the body, against its weight.
  for (std::size_t b = 0; b < largest.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) continue;
    const double weight = environment.steady_acceleration(system.bodies[b]).norm();
    if (weight == 0) continue;
    const double share = known_share * largest[b] * system.kinetics[b].inverse_mass / weight;
    if (share > report.force_doubt.share) report.force_doubt = {share, system.bodies[b], t};
  }
}

}  // namespace rigor
