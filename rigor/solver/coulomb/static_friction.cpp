#include "rigor/solver/coulomb/static_friction.hpp"

#include "rigor/core/assert.hpp"

#include <utility>

namespace rigor {

StaticFrictionSolution solve_static_friction(
    const StaticFriction& friction,
    const std::function<CoulombSolution(const std::vector<double>& mu)>& solve) {
  const std::size_t count = friction.mu.size();
  RIGOR_ASSERT(friction.mu_static.size() == count && friction.sticks.size() == count);
  // At first all contacts that stuck before get μ_s.
  std::vector<double> mu = friction.mu;
  std::vector<bool> is_static = friction.sticks;
  for (std::size_t k = 0; k < count; ++k) {
    RIGOR_ASSERT(friction.mu_static[k] >= friction.mu[k]);
    if (is_static[k]) mu[k] = friction.mu_static[k];
  }
  // A contact that slips though it has μ_s gets μ for good, so this ends after n + 1 rounds.
  for (int round = 1;; ++round) {
    CoulombSolution solution = solve(mu);
    bool breaks_loose = false;
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_static[k] || solution.modes[k] != ContactMode::slide || mu[k] == friction.mu[k]) continue;
      is_static[k] = false;
      mu[k] = friction.mu[k];
      breaks_loose = true;
    }
    if (!breaks_loose) return {std::move(solution), std::move(mu), round};
  }
}

}  // namespace rigor
