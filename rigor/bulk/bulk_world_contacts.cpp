// Which bodies may touch in a step, and where.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/bulk_world_scratch.hpp"
#include "rigor/core/index.hpp"

#include <cstddef>

namespace rigor {

namespace {

/// The margin is how far a body falls from rest in this many steps, so that points are found before they
/// touch.
constexpr double margin_steps = 2;

}  // namespace

/// Pairs within the distance of free fall are contacts, g t²/2; what a body's velocity adds to it is each
/// pair's own.
double BulkWorld::pair_margin(double h) const {
  return 0.5 * model_->g_W().norm() * (margin_steps * h) * (margin_steps * h);
}

/// Finds the pairs and manifolds of all that moves. Islands that these disturb wake, and then what they touch
/// is looked for too, until no island wakes.
void BulkWorld::find_contacts(double h) {
  Scratch& s = *scratch_;
  const double margin = pair_margin(h);
  bool is_done = false;
  while (!is_done) {
    // Sleeping bodies stand, so that pairs of two of them are not looked for.
    if (s.sleepers) s.sleepers->lay_down(bodies_);
    s.pair_finder.find_pairs(bodies_, h, margin, s.executor, s.pairs);
    s.narrow_phase.find_manifolds(bodies_, s.pairs, s.executor, s.manifolds);
    is_done = !s.sleepers || !s.sleepers->wake(bodies_, memory_, s.pairs, s.manifolds);
  }
  s.hidden_sides.take_out(*model_, bodies_, s.pairs, s.manifolds);
}

/// Marks the bodies that have manifolds, which need inertia in W, and those on springs.
void BulkWorld::find_touching_bodies() {
  Scratch& s = *scratch_;
  s.touches.assign(bodies_.x.size(), 0);
  for (std::size_t i = 0; i < s.manifolds.size(); ++i) {
    const ShapePair& pair = s.pairs[at(s.manifolds.pair(i))];
    s.touches[at(pair.body_A)] = s.touches[at(pair.body_B)] = 1;
  }
  s.forces.mark_bodies_on_springs(s.touches);
}

}  // namespace rigor
