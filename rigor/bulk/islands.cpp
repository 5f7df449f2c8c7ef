#include "rigor/bulk/islands.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace rigor {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

BulkIslands::BulkIslands(const Model& model) {
  for (const Body& body : model.bodies()) is_dynamic_.push_back(body.motion == MotionType::dynamic);
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    const std::vector<int> bodies = model.bodies_of_joint(i);
    for (std::size_t k = 1; k < bodies.size(); ++k) lasting_.emplace_back(bodies[0], bodies[k]);
  }
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring && spring->body_A != world_body && spring->body_B != world_body)
      lasting_.emplace_back(spring->body_A, spring->body_B);
  }
  build(ManifoldMemories{});
}

void BulkIslands::build(const std::vector<ManifoldMemory>& contacts) {
  begin();
  for (const ManifoldMemory& contact : contacts) join(contact.body_A, contact.body_B);
  finish();
}

void BulkIslands::begin() {
  islands_.resize(is_dynamic_.size());
  for (std::size_t i = 0; i < islands_.size(); ++i) islands_[i] = static_cast<int>(i);
  for (const auto& [a, b] : lasting_) join(a, b);
}

void BulkIslands::finish() {
  for (std::size_t i = 0; i < islands_.size(); ++i)
    islands_[i] = is_dynamic_[i] ? root_of(static_cast<int>(i)) : -1;
}

int BulkIslands::root_of(int body) {
  while (islands_[at(body)] != body) {
    islands_[at(body)] = islands_[at(islands_[at(body)])];
    body = islands_[at(body)];
  }
  return body;
}

/// Union by the lower number, paths halved: Tarjan and van Leeuwen, Worst-Case Analysis of Set Union
/// Algorithms, J. ACM 31(2), 1984.
void BulkIslands::join(int a, int b) {
  if (!is_dynamic_[at(a)] || !is_dynamic_[at(b)]) return;
  a = root_of(a);
  b = root_of(b);
  islands_[at(std::max(a, b))] = std::min(a, b);
}

}  // namespace rigor
