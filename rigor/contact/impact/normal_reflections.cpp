#include "rigor/contact/impact/normal_reflections.hpp"

#include "rigor/core/interrupt.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

/// Groups of more contacts are solved on their rows, and not kept.
constexpr std::size_t most_held_together = 48;

VecX normal_parts(const VecX& u) {
  VecX normals(u.size() / 3);
  for (Index i = 0; i < normals.size(); ++i) normals(i) = u(3 * i + 2);
  return normals;
}

VecX along_normals(const VecX& normals) {
  VecX all = VecX::Zero(3 * normals.size());
  for (Index i = 0; i < normals.size(); ++i) all(3 * i + 2) = normals(i);
  return all;
}

}  // namespace

NormalReflections::NormalReflections(const ImpactProblem& problem)
    : problem_(problem),
      couplings_(problem.A.normal_couplings()),
      lambda_(VecX::Zero(problem.u.size() / 3)),
      u_(normal_parts(problem.u)) {}

VecX NormalReflections::run() {
  // Finitely many reflections suffice; how many grows with the root of the mass ratios. What approaches after
  // the last is left to the plastic impact.
  constexpr int most_reflections = 10000;
  const double tolerance = rounding_speed(problem_.u);
  bool is_exact = true;
  for (int k = 0; k < most_reflections; ++k) {
    poll_interrupt();
    Group approaching;
    for (Index i = 0; i < u_.size(); ++i)
      if (u_(i) < -tolerance) approaching.push_back(static_cast<std::size_t>(i));

    // The rounding of many additions is not taken for the end.
    if (approaching.empty() && is_exact) break;
    if (approaching.empty()) {
      u_ = normal_parts(problem_.u + problem_.A * along_normals(lambda_));
      is_exact = true;
      continue;
    }

    // Groups that do not act on one another reflect side by side.
    for (const Group& group : groups_of(approaching)) {
      const std::optional<VecX> z = stop(group);
      if (!z) return along_normals(lambda_);
      for (std::size_t i = 0; i < group.size(); ++i) add(group[i], 2 * (*z)(static_cast<Index>(i)));
    }
    is_exact = false;
  }
  return along_normals(lambda_);
}

/// Adds a normal impulse and what it does to the velocities.
void NormalReflections::add(std::size_t contact, double impulse) {
  if (impulse == 0) return;
  lambda_(static_cast<Index>(contact)) += impulse;
  for (const DelassusOperator::Coupling& other : couplings_[contact])
    u_(static_cast<Index>(other.contact)) += other.response * impulse;
}

/// The contacts in groups of which none acts on another, each in order.
std::vector<NormalReflections::Group> NormalReflections::groups_of(const Group& approaching) const {
  std::vector<bool> is_left(couplings_.size(), false);
  for (const std::size_t i : approaching) is_left[i] = true;
  std::vector<Group> groups;
  for (const std::size_t first : approaching) {
    if (!is_left[first]) continue;
    Group group{first};
    is_left[first] = false;
    for (std::size_t k = 0; k < group.size(); ++k) {
      for (const DelassusOperator::Coupling& other : couplings_[group[k]]) {
        if (!is_left[other.contact]) continue;
        is_left[other.contact] = false;
        group.push_back(other.contact);
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

/// The normal impulses that stop a group; nothing if they are not found.
std::optional<VecX> NormalReflections::stop(const Group& group) {
  VecX u(static_cast<Index>(group.size()));
  for (std::size_t i = 0; i < group.size(); ++i) u(static_cast<Index>(i)) = u_(static_cast<Index>(group[i]));
  if (group.size() <= most_held_together) {
    if (std::optional<VecX> holding = hold_all(group, u)) return holding;
  }

  // Some let go: which ones the complementarity problem says.
  const ImpactProblem part = part_of(problem_, group, VecX::Zero(problem_.u.size()));
  const CoulombSolution stopped = solve_cones(part, along_normals(u), std::vector<double>(part.count(), 0.0));
  if (!stopped.converged) return std::nullopt;
  return normal_parts(stopped.lambda);
}

/// The impulses of least norm at which all contacts of the group stop, if none of them pulls.
std::optional<VecX> NormalReflections::hold_all(const Group& group, const VecX& u) {
  if (group.size() == 1) return VecX(-u / response_within(group)(0, 0));
  constexpr std::size_t most_kept = 512;
  constexpr double rounding = 1e-12;
  if (held_.size() >= most_kept) held_.clear();
  auto known = held_.find(group);
  if (known == held_.end()) known = held_.emplace(group, LeastNormSystem(response_within(group))).first;
  const LeastNormSystem& system = known->second;
  const VecX z = -system.solve(u);
  const double largest = z.cwiseAbs().maxCoeff();
  if (z.minCoeff() < -rounding * largest) return std::nullopt;
  const double left = (system.matrix() * z + u).cwiseAbs().maxCoeff();
  if (left > rounding * u.cwiseAbs().maxCoeff()) return std::nullopt;
  return VecX(z.cwiseMax(0));
}

/// The responses of the normals of a group to one another.
MatX NormalReflections::response_within(const Group& group) const {
  MatX N = MatX::Zero(static_cast<Index>(group.size()), static_cast<Index>(group.size()));
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (const DelassusOperator::Coupling& other : couplings_[group[i]]) {
      const auto place = std::lower_bound(group.begin(), group.end(), other.contact);
      if (place != group.end() && *place == other.contact)
        N(static_cast<Index>(i), place - group.begin()) = other.response;
    }
  }
  return N;
}

}  // namespace rigor
