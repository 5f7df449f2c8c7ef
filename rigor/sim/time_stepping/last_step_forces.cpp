#include "rigor/sim/time_stepping/last_step_forces.hpp"

#include "rigor/sim/time_stepping/step_rates.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace rigor {

namespace {

using Pair = std::pair<int, int>;

Pair pair_of(const ContactKey& key) {
  return {key.body_A, key.body_B};
}

/// The contact of these (places in the system) that a force acts at.
std::size_t contact_of(const ContactForce& force, const std::vector<Contact>& contacts,
                       std::span<const std::size_t> places) {
  const auto same = std::find_if(places.begin(), places.end(),
                                 [&](std::size_t i) { return contacts[i].key() == force.key; });
  if (same != places.end()) return *same;
  return *std::min_element(places.begin(), places.end(), [&](std::size_t i, std::size_t k) {
    return (contacts[i].p_W() - force.p_W).squaredNorm() < (contacts[k].p_W() - force.p_W).squaredNorm();
  });
}

}  // namespace

void LastStepForces::remember(std::vector<ContactForce> forces) {
  forces_ = std::move(forces);
  std::erase_if(forces_,
                [](const ContactForce& force) { return force.mode == TouchingPoint::Mode::unknown; });
  std::stable_sort(forces_.begin(), forces_.end(),
                   [](const ContactForce& a, const ContactForce& b) { return a.key < b.key; });
}

VecX LastStepForces::impulses(double h, const ContactSystem& system) const {
  // The contacts by pairs.
  const std::vector<Contact>& contacts = system.contacts;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < contacts.size() && !forces_.empty(); ++i)
    if (!contacts[i].stop) places.push_back(i);
  const auto pair_at = [&](std::size_t i) { return Pair(contacts[i].body_A, contacts[i].body_B); };
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t i, std::size_t k) { return pair_at(i) < pair_at(k); });

  // Each pair with its forces.
  VecX lambda;
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    const Pair pair = pair_at(places[first]);
    while (last < places.size() && pair_at(places[last]) == pair) ++last;
    const std::span<const std::size_t> of_pair(places.data() + first, last - first);
    auto force = std::lower_bound(forces_.begin(), forces_.end(), pair,
                                  [](const ContactForce& a, const Pair& b) { return pair_of(a.key) < b; });
    for (; force != forces_.end() && pair_of(force->key) == pair; ++force) {
      if (lambda.size() == 0) lambda = VecX::Zero(3 * static_cast<Eigen::Index>(contacts.size()));
      const std::size_t i = contact_of(*force, contacts, of_pair);
      lambda.segment<3>(normal_row(i) - 2) += h * (system.frames[i].transpose() * force->force_W);
    }
  }
  return lambda;
}

}  // namespace rigor
