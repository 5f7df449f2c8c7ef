#include "rigor/geometry/broad_phase/pair_set.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <iterator>

namespace rigor {

namespace {

/// If more than one in this many items have left their grown boxes, the tree is rebuilt: that is cheaper than
/// inserting them one by one.
constexpr std::size_t kRebuildPart = 16;

}  // namespace

PairSet::PairSet(BroadPhaseMethod method, double margin) : method_(method), margin_(margin) {
  RIGOR_ASSERT(margin >= 0);
}

void PairSet::update(std::span<const Aabb> boxes) {
  // Tree: the candidates whose own boxes overlap. Sweep and prune keeps the pairs themselves.
  std::vector<BoxPair> now;
  if (method_ == BroadPhaseMethod::tree) {
    update_candidates(boxes);
    for (const BoxPair& pair : candidates_) {
      if (boxes[at(pair.a)].overlaps(boxes[at(pair.b)])) {
        now.push_back(pair);
      }
    }
  } else {
    sweep_.update(boxes);
    now = sweep_.pairs();
  }
  // The changes are the differences of the two sorted lists.
  entered_.clear();
  left_.clear();
  std::set_difference(now.begin(), now.end(), pairs_.begin(), pairs_.end(), std::back_inserter(entered_));
  std::set_difference(pairs_.begin(), pairs_.end(), now.begin(), now.end(), std::back_inserter(left_));
  pairs_.swap(now);
}

void PairSet::update_candidates(std::span<const Aabb> boxes) {
  if (grown_.size() != boxes.size()) {
    rebuild(boxes);
    return;
  }
  // The candidates of a box that is still inside its grown box are still valid.
  std::vector<int> escaped;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!grown_[i].contains(boxes[i])) escaped.push_back(static_cast<int>(i));
  }
  if (escaped.size() * kRebuildPart > boxes.size()) {
    rebuild(boxes);
    return;
  }
  for (const int id : escaped) {
    const std::size_t i = at(id);
    grown_[i] = boxes[i].grown(margin_);
    tree_.set(id, grown_[i]);
  }
  replace(escaped);
}

void PairSet::rebuild(std::span<const Aabb> boxes) {
  grown_.clear();
  std::vector<BoxItem> items;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    grown_.push_back(boxes[i].grown(margin_));
    items.push_back({static_cast<int>(i), grown_.back()});
  }
  tree_.build(items);
  candidates_ = tree_.overlapping_pairs();
}

/// Finds the candidates of these items anew; those of all others remain.
void PairSet::replace(const std::vector<int>& escaped) {
  if (escaped.empty()) return;
  std::vector<bool> has_escaped(grown_.size(), false);
  for (const int id : escaped) has_escaped[at(id)] = true;
  std::erase_if(candidates_,
                [&](const BoxPair& pair) { return has_escaped[at(pair.a)] || has_escaped[at(pair.b)]; });
  const std::ptrdiff_t kept = static_cast<std::ptrdiff_t>(candidates_.size());
  std::vector<int> near;
  for (const int id : escaped) {
    tree_.overlapping(grown_[at(id)], near);
    for (const int other : near) {
      // A pair of two escaped items is found twice and added once.
      if (other == id || (has_escaped[at(other)] && other < id)) continue;
      candidates_.push_back({std::min(id, other), std::max(id, other)});
    }
  }
  std::sort(candidates_.begin() + kept, candidates_.end());
  std::inplace_merge(candidates_.begin(), candidates_.begin() + kept, candidates_.end());
}

}  // namespace rigor
