// What bodies keep of their motion that are deep in each other and were stopped.

#include "rigor/bulk/contacts/common_motion.hpp"
#include "rigor/bulk/passing/passing_guard.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <span>

namespace rigor {

void PassingGuard::calm_jams(BulkBodies& bodies) const {
  for (const Jam& jam : jams_) {
    const std::array<int, 2> both = {jam.body_A, jam.body_B};
    const bool is_A = bodies.is_dynamic(jam.body_A), is_B = bodies.is_dynamic(jam.body_B);
    // Two bodies keep their momenta; what is fixed takes those of the other.
    if (is_A && is_B) {
      keep_part_of_motion(*model_, both, common_motion(*model_, both, bodies), jam.share, bodies);
      continue;
    }
    // The work of a body that moves by itself is that of its contacts, so that it is left to these.
    if (is_A == is_B || bodies.has_velocity(is_A ? jam.body_B : jam.body_A)) continue;
    keep_part_of_motion(*model_, std::span(both).subspan(is_A ? 0 : 1, 1), {}, jam.share, bodies);
  }
}

}  // namespace rigor
