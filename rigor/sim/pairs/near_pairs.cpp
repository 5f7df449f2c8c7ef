#include "rigor/sim/pairs/near_pairs.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

Pose pose_of(const State& state, int body) {
  return {rotation_matrix(state.orientation(body)), state.position(body)};
}

Aabb body_box(const Model& model, const State& state, int body) {
  Aabb box{Vec3::Constant(std::numeric_limits<double>::infinity()),
           Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (const BodyShape& shape : model.body(body).shapes) {
    box = box.united(axis_aligned_box(shape.shape, pose_of(state, body) * shape.X_BS));
  }
  return box;
}

std::vector<std::pair<int, int>> near_pairs(const Model& model, const State& state, double margin) {
  // Bounded bodies in a tree; planes meet everything.
  AabbTree tree;
  std::vector<Aabb> boxes;
  std::vector<int> unbounded;
  for (int i = 0; i < model.body_count(); ++i) {
    boxes.push_back(body_box(model, state, i).grown(margin));
    if (model.body(i).shapes.empty()) continue;
    if (std::isfinite(model.body(i).bounding_radius)) {
      tree.set(i, boxes.back());
    } else {
      unbounded.push_back(i);
    }
  }

  // Boxes that meet, of bodies that may collide.
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> near;
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).shapes.empty() || !std::isfinite(model.body(i).bounding_radius)) continue;
    poll_interrupt();
    tree.overlapping(boxes[at(i)], near);
    for (const int other : near) {
      if (other > i && model.may_collide(i, other)) pairs.push_back({i, other});
    }
    for (const int other : unbounded) {
      if (model.may_collide(i, other)) pairs.push_back(std::minmax(i, other));
    }
  }
  return pairs;
}

}  // namespace rigor
