#include "rigor/bulk/graph/jointed_bodies.hpp"

#include "rigor/bulk/graph/disjoint_sets.hpp"

#include <numeric>

namespace rigor {

void JointedBodies::find(const Model& model) {
  is_jointed_.assign(at(model.body_count()), 0);
  groups_.resize(is_jointed_.size());
  std::iota(groups_.begin(), groups_.end(), 0);
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    int first = -1;
    for (const int body : model.bodies_of_joint(j)) {
      if (model.body(body).motion != MotionType::dynamic) continue;
      is_jointed_[at(body)] = 1;
      if (first < 0) first = body;
      join_sets(groups_, first, body);
    }
  }
  // From now on each body knows its root itself.
  for (int& group : groups_) group = find_root(groups_, group);
}

}  // namespace rigor
