#include "rigor/sim/penalty/penalty_touching.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

/// Share of the depth that springs are made for at which a contact that a step went past is met by a shorter
/// one: five times what the steps that end at it may miss.
constexpr double deep_share = 0.1;
/// Share of a contact's free mobility below which what joints leave of it is the rounding of their factors.
constexpr double mobility_rounding = 1e-12;

/// What joints leave of a mobility: 0 where they hold the bodies as rigidly as what moves on a path. No force
/// could move them there, and a spring made for their mass would ask for steps of its own frequency.
double held_mobility(double response, double free) {
  return response > mobility_rounding * free ? response : 0;
}

/// The memories of the State, each of which is taken once: by the contact of the same key, or by one of the
/// same shapes if the features have changed.
class MemoryIndex {
 public:
  explicit MemoryIndex(const std::vector<ContactMemory>& memories) {
    for (const ContactMemory& memory : memories) index_[memory.key()].push_back(&memory);
  }
  const ContactMemory* take(const ContactKey& wanted) {
    const auto found = index_.find(wanted);
    return found == index_.end() ? nullptr : take_first(found);
  }
  const ContactMemory* take_of_same_shapes(ContactKey wanted) {
    wanted.feature = 0;
    const auto found = index_.lower_bound(wanted);
    if (found == index_.end()) return nullptr;
    wanted.feature = found->first.feature;
    return found->first == wanted ? take_first(found) : nullptr;
  }
  /// Number and energy of the memories that no contact took.
  std::pair<long, double> rest() const {
    std::pair<long, double> rest{0, 0};
    for (const auto& [key, memories] : index_) {
      for (const ContactMemory* memory : memories) ++rest.first, rest.second += memory->energy;
    }
    return rest;
  }

 private:
  using Index = std::map<ContactKey, std::vector<const ContactMemory*>>;
  const ContactMemory* take_first(Index::iterator place) {
    const ContactMemory* const memory = place->second.front();
    place->second.erase(place->second.begin());
    if (place->second.empty()) index_.erase(place);
    return memory;
  }
  Index index_;
};

}  // namespace

void PenaltyTouching::add_springs(const State& state, Touching& touching, const PosesBefore* before) const {
  const ContactSystem& system = touching.system;
  const std::size_t n = system.contacts.size();
  const VecX u = relative_velocities(system);
  // A remembered contact has no bristle if it began before the surfaces had friction.
  const auto remembered = [&](std::size_t i, const ContactMemory& memory) {
    PenaltyContact spring = penalty_contact(choice_, memory);
    const Contact& contact = system.contacts[i];
    const bool lacks_bristle = contact.friction > 0 && spring.bristle_stiffness == 0 && !contact.stop;
    return lacks_bristle ? with_bristle(spring, contact_mobility(system, i), choice_.depth) : spring;
  };
  // Springs of contacts that the State remembers under the same key.
  MemoryIndex index(state.contacts);
  touching.springs.resize(n);
  touching.share_touched.assign(n, 1);
  std::vector<double> energies(n, 0);  // That the springs held before.
  const auto take = [&](std::size_t i, const ContactMemory& memory) {
    touching.springs[i] = remembered(i, memory);
    energies[i] = memory.energy - bristle_energy(system.contacts[i], touching.springs[i]);
  };
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < n; ++i) {
    if (const ContactMemory* const memory = index.take(system.contacts[i].key())) {
      take(i, *memory);
    } else {
      unknown.push_back(i);
    }
  }
  // The others take over a spring of the same shapes, or get a fresh one for their approach.
  MatX response;
  for (const std::size_t i : unknown) {
    const Contact& contact = system.contacts[i];
    if (const ContactMemory* const memory = index.take_of_same_shapes(contact.key())) {
      take(i, *memory);
      continue;
    }
    const double approach = std::max(0.0, -u[3 * static_cast<Eigen::Index>(i) + 2]);
    const bool is_fresh_impact =
        !contact.is_bounded_force() && contact.point.gap <= 0 && approach > resting_velocity_;
    if (is_fresh_impact) touching.begun.push_back(i);
    touching.springs[i] = fresh_spring(system, i, approach, response);
  }
  if (before != nullptr) limit_springs(energies, unknown, *before, touching);
  // Springs that began pressed forget their offset as the contact opens.
  for (std::size_t i = 0; i < n; ++i) {
    PenaltyContact& spring = touching.springs[i];
    spring.offset = std::min(spring.offset, std::max(0.0, -system.contacts[i].point.gap));
  }
  std::tie(touching.lost, touching.lost_energy) = index.rest();
}

PenaltyContact PenaltyTouching::fresh_spring(const ContactSystem& system, std::size_t i, double approach,
                                             MatX& response) const {
  // What the contact moves: with joints, by the response of the whole mechanism.
  const Contact& contact = system.contacts[i];
  ContactMobility mobility = contact_mobility(system, i);
  if (system.joints) {
    if (response.size() == 0) response = delassus(system);
    const Eigen::Index k = 3 * static_cast<Eigen::Index>(i);
    mobility = {held_mobility(response(k + 2, k + 2), mobility.normal),
                held_mobility(std::max(response(k, k), response(k + 1, k + 1)), mobility.tangential)};
  }
  PenaltyChoice choice = choice_;
  choice.least_speed = least_speed(contact);
  return make_penalty_contact(contact, mobility, choice, approach, -contact.point.gap);
}

void PenaltyTouching::limit_springs(const std::vector<double>& energies,
                                    const std::vector<std::size_t>& unknown, const PosesBefore& before,
                                    Touching& touching) const {
  const ContactSystem& system = touching.system;
  const VecX u = relative_velocities(system);
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (contact.stop || contact.is_bounded_force() || contact.point.gap > 0) continue;
    // Most springs go on with less than they held.
    const double depth = pressed_depth(touching.springs[i], contact.point.gap);
    const bool is_new = std::ranges::binary_search(unknown, i);
    if (!is_new && stored_energy(touching.springs[i].spring, depth) <= energies[i]) continue;
    const double closed = most_closed(model_, before, contact, system.of(contact.body_A).pose(),
                                      system.of(contact.body_B).pose());
    limit_depth(contact, energies[i], closed, touching.springs[i]);
    if (!is_new) continue;
    if (energies[i] == 0) touching.share_touched[i] = std::min(1.0, -contact.point.gap / closed);
    note_missed(contact, -u[3 * static_cast<Eigen::Index>(i) + 2], closed, touching);
  }
}

void PenaltyTouching::note_missed(const Contact& contact, double approach, double closed,
                                  Touching& touching) const {
  // Not what no shorter step would meet sooner: what lies deep under a contact that changes its features.
  const double depth = -contact.point.gap;
  if (depth <= deep_share * choice_.depth || closed <= 0.5 * deep_share * choice_.depth) return;
  constexpr double least = 0.1, most = 0.8;
  const double share = std::clamp(approach > 0 ? 1 - depth / closed : least, least, most);
  if (share < touching.missed.share) touching.missed = {share, closed};
}

void PenaltyTouching::limit_depth(const Contact& contact, double energy, double closed,
                                  PenaltyContact& spring) {
  const double depth = pressed_depth(spring, contact.point.gap);
  if (!(depth > 0) || stored_energy(spring.spring, depth) <= energy) return;
  // Steps are as short as springs need that harden; where a normal turns fast they may still have gone by
  // more than what multiplies the force by e.
  const double held = depth_holding(spring.spring, energy);
  const double hardened = std::max(held, spring.spring.limit) + hardening_length(spring.spring);
  const double most = std::min(held + closed, hardened);
  if (depth > most) spring.offset += depth - most;
}

}  // namespace rigor
