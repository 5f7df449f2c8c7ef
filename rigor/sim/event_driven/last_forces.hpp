#pragma once

#include "rigor/core/index.hpp"
#include "rigor/sim/pairs/touching_points.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace rigor {

/// The contact forces that events have found, each until the next event of one of its bodies.
class LastForces {
 public:
  /// Forgets all forces. Of each body whether it is ever forgotten by itself: static ones, and those on
  /// paths, have no events of their own.
  void reset(std::vector<bool> has_events) {
    forces_.assign(has_events.size(), {});
    version_.assign(has_events.size(), 0);
    has_events_ = std::move(has_events);
  }
  /// Forgets the forces on a body that has events.
  void forget(int body) {
    forces_[at(body)].clear();
    ++version_[at(body)];
  }
  /// A force that acts from now on, on at least one body that has events.
  void note(const ContactForce& force) {
    const int A = force.key.body_A, B = force.key.body_B;
    // With a body whose list is emptied, so that no list grows from event to event.
    forces_[at(has_events_[at(B)] ? B : A)].push_back({force, version_[at(A)], version_[at(B)]});
  }
  /// All that still act.
  std::vector<ContactForce> all() const {
    std::vector<ContactForce> result;
    for (const std::vector<Kept>& of_body : forces_) {
      for (const Kept& kept : of_body) {
        const ContactKey& key = kept.force.key;
        if (kept.version_A == version_[at(key.body_A)] && kept.version_B == version_[at(key.body_B)])
          result.push_back(kept.force);
      }
    }
    return result;
  }
  /// How many are kept, among them some that act no more.
  std::size_t kept_count() const {
    std::size_t count = 0;
    for (const std::vector<Kept>& of_body : forces_) count += of_body.size();
    return count;
  }

 private:
  struct Kept {
    ContactForce force;
    long version_A, version_B;  ///< Of its bodies, when it was found.
  };
  std::vector<std::vector<Kept>> forces_;  ///< Of each body as B, or as A where B has no events.
  std::vector<bool> has_events_;           ///< Of each body.
  std::vector<long> version_;              ///< Of each body: how often its forces were forgotten.
};

}  // namespace rigor
