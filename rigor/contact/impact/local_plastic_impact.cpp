#include "rigor/contact/impact/local_plastic_impact.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rigor {

namespace {

/// Problems of fewer contacts are solved at once.
constexpr std::size_t few_contacts = 48;

/// The bodies (nodes of the rows) on which the impact acts.
class ActingBodies {
 public:
  explicit ActingBodies(const ContactRows& rows) : rows_(rows), acts_(rows.node_count(), false) {}

  /// Adds the bodies of contacts that approach by more than the tolerance. Returns whether there are new
  /// ones.
  bool add_approaching(const VecX& u, double tolerance) {
    bool is_new = false;
    for (std::size_t i = 0; i < rows_.contacts.size(); ++i)
      if (normal_velocity(u, i) < -tolerance) is_new = add_bodies_of(i) || is_new;
    return is_new;
  }

  /// Adds what touches them, so many times.
  void add_rings(int rings) {
    for (int ring = 0; ring < rings; ++ring) {
      std::vector<std::size_t> touching;
      for (std::size_t i = 0; i < rows_.contacts.size(); ++i)
        if (has_any(i)) touching.push_back(i);
      for (const std::size_t i : touching) add_bodies_of(i);
    }
  }

  /// The contacts between them, and between them and what does not give way.
  std::vector<std::size_t> contacts() const {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < rows_.contacts.size(); ++i) {
      const ContactRows::Sides& sides = rows_.contacts[i];
      if (std::all_of(sides.begin(), sides.end(),
                      [this](const auto& side) { return acts_or_is_fixed(side); }))
        chosen.push_back(i);
    }
    return chosen;
  }

 private:
  bool acts_or_is_fixed(const ContactRows::Side& side) const { return side.node < 0 || acts_[at(side.node)]; }

  bool has_any(std::size_t contact) const {
    const ContactRows::Sides& sides = rows_.contacts[contact];
    return std::any_of(sides.begin(), sides.end(),
                       [this](const auto& side) { return side.node >= 0 && acts_[at(side.node)]; });
  }

  bool add_bodies_of(std::size_t contact) {
    bool is_new = false;
    for (const ContactRows::Side& side : rows_.contacts[contact]) {
      if (acts_or_is_fixed(side)) continue;
      acts_[at(side.node)] = true;
      is_new = true;
    }
    return is_new;
  }

  const ContactRows& rows_;
  std::vector<bool> acts_;
};

/// The contacts chosen as a problem on their rows.
CoulombSolution solve_chosen(const ImpactProblem& problem, const std::vector<std::size_t>& chosen,
                             const VecX& u) {
  ImpactProblem part = part_of(problem, chosen, u);
  if (!part.rows) part.rows = std::make_shared<const ContactRows>(rows_of(*problem.rows, chosen));
  return solve_cones(part, part.u, frictions(part));
}

/// What was found for the contacts chosen as an answer for all.
CoulombSolution for_all(const ImpactProblem& problem, const std::vector<std::size_t>& chosen, const VecX& u,
                        CoulombSolution found) {
  CoulombSolution all = std::move(found);
  const VecX lambda = std::exchange(all.lambda, VecX::Zero(u.size()));
  const std::vector<ContactMode> modes =
      std::exchange(all.modes, std::vector<ContactMode>(problem.count(), ContactMode::open));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    all.lambda.segment<3>(row_of(chosen[i])) = lambda.segment<3>(row_of(i));
    all.modes[chosen[i]] = modes[i];
  }
  all.w = u + problem.A * all.lambda;
  return all;
}

}  // namespace

CoulombSolution solve_plastic_where_it_acts(const ImpactProblem& problem, const VecX& u) {
  constexpr double negligible = 1e-10, most_of_all = 0.5;
  if (!problem.rows || problem.count() < few_contacts) return solve_cones(problem, u, frictions(problem));

  // Further rings each time, so that what spreads far is soon solved as a whole.
  const double tolerance = negligible * u.cwiseAbs().maxCoeff();
  ActingBodies acting(*problem.rows);
  VecX w = u;
  for (int rings = 1; acting.add_approaching(w, tolerance); rings *= 2) {
    acting.add_rings(rings);
    const std::vector<std::size_t> chosen = acting.contacts();
    // A part that has most of the contacts saves nothing.
    if (static_cast<double>(chosen.size()) > most_of_all * static_cast<double>(problem.count())) break;
    // The answer of the part is one for all if nothing outside approaches because of it.
    CoulombSolution found = for_all(problem, chosen, u, solve_chosen(problem, chosen, u));
    w = found.w;
    ActingBodies next = acting;
    if (!next.add_approaching(w, tolerance)) return found;
  }
  return solve_cones(problem, u, frictions(problem));
}

}  // namespace rigor
