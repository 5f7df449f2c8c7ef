#include "rigor/bulk/half_kicks.hpp"

#include "rigor/core/index.hpp"

#include <cstddef>

namespace rigor {

void HalfKicks::find(const std::vector<int>& moving, const std::vector<char>& touches,
                     const BulkBodies& bodies, BulkJoints& joints) {
  flies_.resize(bodies.x.size());
  for (int i = 0; i < bodies.count(); ++i)
    flies_[at(i)] = bodies.is_dynamic(i) && touches[at(i)] == 0 ? 1 : 0;
  joints.find_flying(bodies, flies_);
  flying_.clear();
  for (const int body : moving) {
    if (flies_[at(body)] != 0) flying_.push_back(body);
  }
}

void HalfKicks::begin(const Kick& kick, BulkJoints& joints, const Executor& executor,
                      BulkBodies& bodies) const {
  take_part(-0.5F, kick, executor, bodies);
  joints.solve_rates_of_flying(false, executor);
}

void HalfKicks::end(const Kick& kick, BulkJoints& joints, const Executor& executor,
                    BulkBodies& bodies) const {
  take_part(0.5F, kick, executor, bodies);
  joints.solve_rates_of_flying(true, executor);
}

/// Changes velocities as in that part of a substep.
void HalfKicks::take_part(float part, const Kick& kick, const Executor& executor, BulkBodies& bodies) const {
  const float time = part * kick.h;
  const bool has_turns = kick.gyroscopic_terms.has_any() && !flying_.empty();
  if (has_turns) kick.gyroscopic_terms.find_changes(time, bodies, executor, kick.turns, flies_);
  executor.for_ranges(static_cast<int>(flying_.size()), 1024, [&](int begin, int end) {
    for (int place = begin; place < end; ++place) {
      const std::size_t k = at(flying_[at(place)]);
      // Linear velocity first, then angular.
      float* const v = bodies.motion[k].v;
      for (const int half : {0, 4}) {
        FloatRow next = load_row(v + half) + time * load_row(kick.accelerations[k].data() + half);
        if (has_turns) next += load_row(kick.turns[k].data() + half);
        store_row(next, v + half);
      }
    }
  });
}

}  // namespace rigor
