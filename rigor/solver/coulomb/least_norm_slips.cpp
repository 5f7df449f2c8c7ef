#include "rigor/solver/coulomb/least_norm_slips.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/dense.hpp"

#include <cmath>
#include <deque>

namespace rigor {

using Eigen::Index;

namespace {

class LeastNormSlips {
 public:
  LeastNormSlips(const CoulombProblem& laws, const ContactModes& face, double accepted,
                 const ForcesOfModes& forces_of)
      : forces_of_(forces_of), modes_(face), accepted_(accepted) {
    for (std::size_t k = 0; k < face.modes.size(); ++k)
      if (face.modes[k] == ContactMode::slide && laws.rows[k] == FrictionRow::cone && laws.mu[k] > 0)
        free_slips_.push_back(k);
  }

  std::optional<CoulombSolution> solve() {
    constexpr int kMaxRounds = 50;
    VecX angles = slip_angles();
    first_ = angles;
    // The fixed point of slip angles → forces → slip angles.
    for (int round = 0; round < kMaxRounds; ++round) {
      std::optional<CoulombSolution> solution = forces_for(angles);
      if (!solution || solution->residual <= accepted_) return solution;
      const std::optional<VecX> change = find_angle_change(*solution);
      if (!change || free_slips_.empty()) return std::nullopt;
      angles = accelerated(angles, *change);
      if (!angles.allFinite()) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  VecX slip_angles() const {
    VecX angles(static_cast<Index>(free_slips_.size()));
    for (Index i = 0; i < angles.size(); ++i) {
      const Vec2& slip = modes_.slips[free_slips_[at(i)]];
      angles(i) = std::atan2(slip(1), slip(0));
    }
    return angles;
  }

  // Slips keep their bits as long as their angles do.
  std::optional<CoulombSolution> forces_for(const VecX& angles) {
    for (Index i = 0; i < angles.size(); ++i)
      if (angles(i) != first_(i))
        modes_.slips[free_slips_[at(i)]] = Vec2(std::cos(angles(i)), std::sin(angles(i)));
    return forces_of_(modes_);
  }

  // From the assumed slips to those of w.
  std::optional<VecX> find_angle_change(const CoulombSolution& solution) const {
    VecX change(static_cast<Index>(free_slips_.size()));
    for (Index i = 0; i < change.size(); ++i) {
      const std::size_t k = free_slips_[at(i)];
      const Vec2 w = solution.w.segment<2>(3 * static_cast<Index>(k));
      const Vec2& slip = modes_.slips[k];
      if (!(w.dot(slip) > 0)) return std::nullopt;
      change(i) = std::atan2(slip(0) * w(1) - slip(1) * w(0), slip.dot(w));
    }
    return change;
  }

  // Anderson's acceleration: the combination of the last points whose change would be least, were the map
  // linear.
  VecX accelerated(const VecX& angles, const VecX& change) {
    constexpr std::size_t kMemory = 5;
    if (last_change_.size() > 0) {
      change_differences_.push_back(change - last_change_);
      angle_differences_.push_back(angles - last_angles_);
      if (change_differences_.size() > kMemory) {
        change_differences_.pop_front();
        angle_differences_.pop_front();
      }
    }
    last_change_ = change;
    last_angles_ = angles;
    const Index memory = static_cast<Index>(change_differences_.size());
    VecX next = angles + change;
    if (memory == 0) return next;
    MatX dF(angles.size(), memory), dX(angles.size(), memory);
    for (Index j = 0; j < memory; ++j) {
      dF.col(j) = change_differences_[at(j)];
      dX.col(j) = angle_differences_[at(j)];
    }
    const VecX weights = least_norm_solution(dF, change);
    return next - (dX + dF) * weights;
  }

  const ForcesOfModes& forces_of_;
  ContactModes modes_;
  double accepted_;
  std::vector<std::size_t> free_slips_;  ///< Contacts whose slip direction is unknown.
  VecX first_;                           ///< Angles at the start.
  VecX last_angles_, last_change_;
  std::deque<VecX> angle_differences_, change_differences_;
};

}  // namespace

std::optional<CoulombSolution> find_least_norm(const CoulombProblem& problem, const ContactModes& face,
                                               double accepted) {
  return find_least_norm(
      problem, face, accepted, [&](const ContactModes& modes) -> std::optional<CoulombSolution> {
        const std::optional<VecX> forces = KnownModesSystem(problem, modes).find_in_cones();
        if (!forces) return std::nullopt;
        return make_solution(problem, clamp_to_cones(problem, *forces), modes.modes, accepted);
      });
}

std::optional<CoulombSolution> find_least_norm(const CoulombProblem& laws, const ContactModes& face,
                                               double accepted, const ForcesOfModes& forces_of) {
  return LeastNormSlips(laws, face, accepted, forces_of).solve();
}

}  // namespace rigor
