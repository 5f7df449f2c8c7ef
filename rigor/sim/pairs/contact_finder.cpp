#include "rigor/sim/pairs/contact_finder.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"

#include <algorithm>
#include <tuple>

namespace rigor {

namespace {

/// The box with so many times the room in which a body may move before the broad phase is told.
Aabb roomy(const Aabb& box, double times) {
  constexpr double share = 0.1;
  return box.grown(times * share * (box.upper - box.lower).minCoeff());
}

}  // namespace

ContactFinder::ContactFinder(const Model& model, BroadPhaseMethod method)
    : model_(model),
      boxes_(make_broad_phase(method)),
      box_of_(at(model.body_count())),
      kept_of_(box_of_.size()),
      known_(box_of_.size(), false),
      is_here_(box_of_.size(), true) {}

void ContactFinder::look_only_at(const std::vector<bool>& bodies) {
  is_here_ = bodies;
  for (int i = 0; i < model_.body_count(); ++i) {
    if (is_here_[at(i)] || !known_[at(i)]) continue;
    boxes_->remove(i);
    known_[at(i)] = false;
  }
}

std::vector<std::pair<int, int>> ContactFinder::near_pairs(const State& state,
                                                           const std::vector<double>& reaches) {
  RIGOR_ASSERT(reaches.size() == box_of_.size());

  // The boxes of all bodies, grown by their reaches.
  for (int i = 0; i < model_.body_count(); ++i) {
    if (!is_here_[at(i)] || model_.body(i).shapes.empty()) continue;
    const std::size_t k = at(i);
    box_of_[k] = body_box(model_, state, i).grown(reaches[k]);
    if (known_[k] && kept_of_[k].contains(box_of_[k]) && roomy(box_of_[k], 2).contains(kept_of_[k])) continue;
    known_[k] = true;
    kept_of_[k] = roomy(box_of_[k], 1);
    boxes_->set(i, kept_of_[k]);
  }

  // Boxes that meet, of bodies that may collide.
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> near;
  for (int i = 0; i < model_.body_count(); ++i) {
    if (!is_here_[at(i)] || model_.body(i).shapes.empty()) continue;
    const bool is_dynamic = model_.body(i).motion == MotionType::dynamic;
    boxes_->overlapping(box_of_[at(i)], near);
    for (const int other : near) {
      if (other <= i || !box_of_[at(i)].overlaps(box_of_[at(other)]) || !model_.may_collide(i, other))
        continue;
      if (is_dynamic || model_.body(other).motion == MotionType::dynamic) pairs.push_back({i, other});
    }
  }
  return pairs;
}

std::vector<Contact> ContactFinder::find(const State& state, const std::vector<double>& reaches,
                                         double tolerance) {
  // Boxes that are no farther apart than the tolerance meet.
  std::vector<double> grown = reaches;
  for (double& reach : grown) reach += 0.5 * tolerance;
  std::vector<Contact> contacts;
  for (const auto& pair : near_pairs(state, grown)) {
    const double reach = tolerance + reaches[at(pair.first)] + reaches[at(pair.second)];
    const std::vector<Contact> found = find(state, pair, {tolerance, reach});
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  // Pairs are in order, and so are the shapes of each.
  return contacts;
}

std::vector<Contact> ContactFinder::find(const State& state, const std::pair<int, int>& pair,
                                         const ContactReach& within) const {
  const auto& [a, b] = pair;
  return find_contacts(model_, a, b, pose_of(state, a), pose_of(state, b), within);
}

}  // namespace rigor
