#pragma once

#include "rigor/core/index.hpp"
#include "rigor/sim/pairs/touching_points.hpp"

#include <vector>

namespace rigor {

/// The contact forces that events have found, each until the next event of one of its bodies.
class LastForces {
 public:
  /// Forgets all forces, for so many bodies.
  void reset(int body_count) {
    forces_.assign(at(body_count), {});
    version_.assign(at(body_count), 0);
  }
  /// Forgets the forces on a body.
  void forget(int body) {
    forces_[at(body)].clear();
    ++version_[at(body)];
  }
  /// A force that acts from now on.
  void note(const ContactForce& force) {
    const int A = force.key.body_A, B = force.key.body_B;
    forces_[at(B)].push_back({force, version_[at(A)], version_[at(B)]});
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

 private:
  struct Kept {
    ContactForce force;
    long version_A, version_B;  ///< Of its bodies, when it was found.
  };
  std::vector<std::vector<Kept>> forces_;  ///< Of each body as B.
  std::vector<long> version_;              ///< Of each body: how often its forces were forgotten.
};

}  // namespace rigor
