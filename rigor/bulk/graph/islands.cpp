#include "rigor/bulk/graph/islands.hpp"

#include "rigor/bulk/graph/disjoint_sets.hpp"
#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <variant>

namespace rigor {

BulkIslands::BulkIslands(const Model& model) {
  for (const Body& body : model.bodies()) is_dynamic_.push_back(body.motion == MotionType::dynamic);
  tie(model);
  forget();
}

void BulkIslands::change(const Model& model, const ChangedBodies& changed) {
  for (const int body : changed.bodies)
    is_dynamic_[at(body)] = model.body(body).motion == MotionType::dynamic;
  if (changed.are_ties_new) tie(model);
  forget();
}

/// Which dynamic bodies joints and springs hold together.
void BulkIslands::tie(const Model& model) {
  lasting_.clear();
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    const std::vector<int> bodies = model.bodies_of_joint(i);
    for (std::size_t k = 1; k < bodies.size(); ++k) lasting_.emplace_back(bodies[0], bodies[k]);
  }
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring && spring->body_A != world_body && spring->body_B != world_body)
      lasting_.emplace_back(spring->body_A, spring->body_B);
  }
  std::erase_if(lasting_, [&](const Pair& pair) {
    return !is_dynamic_[at(pair.first)] || !is_dynamic_[at(pair.second)];
  });
}

/// Forgets the last list of contacts.
void BulkIslands::forget() {
  // Without contacts, each dynamic body is an island, but for those that are tied.
  pairs_.clear();
  islands_.resize(is_dynamic_.size());
  for (std::size_t i = 0; i < is_dynamic_.size(); ++i)
    islands_[i] = is_dynamic_[i] ? static_cast<int>(i) : -1;
  for (const Pair& pair : lasting_) join(pair);
  for (int& island : islands_) island = island < 0 ? -1 : find_root(islands_, island);
}

void BulkIslands::build(const std::vector<ManifoldMemory>& contacts) {
  next_.clear();
  for (const ManifoldMemory& contact : contacts) add(contact.body_A, contact.body_B);
  update();
}

void BulkIslands::add(int a, int b) {
  if (!is_dynamic_[at(a)] || !is_dynamic_[at(b)]) return;
  const Pair pair = std::minmax(a, b);
  if (!next_.empty() && next_.back() == pair) return;
  if (next_.size() == next_.capacity()) make_room(next_.size() + 64, next_);
  next_.push_back(pair);
}

/// Goes from the islands of the previous pairs to those of the current ones.
void BulkIslands::update() {
  if (!std::is_sorted(next_.begin(), next_.end())) next_ = sorted_unique(std::move(next_));
  // While bodies rest, the pairs stay the same.
  if (next_ == pairs_) return;
  // Only islands that lost a contact are taken apart; then all contacts join again.
  lost_.clear();
  std::set_difference(pairs_.begin(), pairs_.end(), next_.begin(), next_.end(), std::back_inserter(lost_));
  if (!lost_.empty()) dissolve_those_that_lost();
  for (const Pair& pair : next_) join(pair);
  for (int& island : islands_) island = island < 0 ? -1 : find_root(islands_, island);
  pairs_.swap(next_);
}

/// Takes apart the islands that lost a contact: their bodies are alone again, but for joints and springs.
void BulkIslands::dissolve_those_that_lost() {
  has_lost_.assign(islands_.size(), 0);
  for (const Pair& pair : lost_) has_lost_[at(island_of(pair.first))] = 1;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (islands_[i] >= 0 && has_lost_[at(islands_[i])] != 0) islands_[i] = static_cast<int>(i);
  }
  for (const Pair& pair : lasting_) join(pair);
}

void BulkIslands::join(const Pair& pair) {
  join_sets(islands_, pair.first, pair.second);
}

}  // namespace rigor
