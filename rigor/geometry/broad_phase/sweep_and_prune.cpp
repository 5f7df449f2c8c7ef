#include "rigor/geometry/broad_phase/sweep_and_prune.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rigor {

void SweepAndPrune::set(int id, const Aabb& box) {
  RIGOR_ASSERT(id >= 0);
  const std::size_t index = static_cast<std::size_t>(id);
  if (index >= items_.size()) items_.resize(index + 1, {{Vec3::Zero(), Vec3::Zero()}, false});
  if (items_[index].is_in) erase_ends(id);
  items_[index] = {box, true};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<End>& ends = ends_[static_cast<std::size_t>(axis)];
    for (const bool is_upper : {false, true}) {
      const End end{value_of(box, axis, is_upper), id, is_upper};
      ends.insert(std::lower_bound(ends.begin(), ends.end(), end), end);
    }
  }
}

void SweepAndPrune::remove(int id) {
  const std::size_t index = static_cast<std::size_t>(id);
  if (id < 0 || index >= items_.size() || !items_[index].is_in) return;
  erase_ends(id);
  items_[index].is_in = false;
}

void SweepAndPrune::erase_ends(int id) {
  const Aabb& box = items_[static_cast<std::size_t>(id)].box;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<End>& ends = ends_[static_cast<std::size_t>(axis)];
    for (const bool is_upper : {false, true}) {
      ends.erase(
          std::lower_bound(ends.begin(), ends.end(), End{value_of(box, axis, is_upper), id, is_upper}));
    }
  }
}

void SweepAndPrune::overlapping(const Aabb& box, std::vector<int>& ids) const {
  ids.clear();
  // Only boxes whose lower ends are not beyond the given box on the x axis can overlap it.
  for (const End& end : ends_[0]) {
    if (end.value > box.upper.x()) break;
    if (!end.is_upper && items_[static_cast<std::size_t>(end.id)].box.overlaps(box)) ids.push_back(end.id);
  }
  std::sort(ids.begin(), ids.end());
}

void SweepAndPrune::update(std::span<const Aabb> boxes) {
  if (items_.size() != boxes.size()) {
    start(boxes);
    return;
  }
  changed_.clear();
  for (int axis = 0; axis < 3; ++axis) sort_axis(ends_[static_cast<std::size_t>(axis)], boxes, axis);
  apply_changes(boxes);
}

/// Sorts the lists from scratch and finds the pairs by one sweep along the x axis.
void SweepAndPrune::start(std::span<const Aabb> boxes) {
  items_.clear();
  pairs_.clear();
  for (const Aabb& box : boxes) items_.push_back({box, true});
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<End>& ends = ends_[static_cast<std::size_t>(axis)];
    ends.clear();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (const bool is_upper : {false, true}) {
        ends.push_back({value_of(boxes[i], axis, is_upper), static_cast<int>(i), is_upper});
      }
    }
    std::sort(ends.begin(), ends.end());
  }
  // The sweep: a box is open between its two ends, and overlaps on x exactly the boxes that are open where it
  // begins.
  std::vector<int> open;
  for (const End& end : ends_[0]) {
    if (end.is_upper) {
      open.erase(std::find(open.begin(), open.end(), end.id));
      continue;
    }
    for (const int other : open) {
      if (boxes[static_cast<std::size_t>(other)].overlaps(boxes[static_cast<std::size_t>(end.id)])) {
        pairs_.push_back({std::min(other, end.id), std::max(other, end.id)});
      }
    }
    open.push_back(end.id);
  }
  std::sort(pairs_.begin(), pairs_.end());
}

/// Insertion sort of one axis: its time is that of the number of exchanges, which is small for small motions.
void SweepAndPrune::sort_axis(std::vector<End>& ends, std::span<const Aabb> boxes, int axis) {
  for (End& end : ends) end.value = value_of(boxes[static_cast<std::size_t>(end.id)], axis, end.is_upper);
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const End moved = ends[k];
    std::size_t at = k;
    for (; at > 0 && moved < ends[at - 1]; --at) {
      const End& passed = ends[at - 1];
      ends[at] = passed;
      // Two boxes begin or cease to overlap only where a lower end passes an upper one.
      if (passed.is_upper == moved.is_upper || passed.id == moved.id) continue;
      const std::size_t i = static_cast<std::size_t>(passed.id), j = static_cast<std::size_t>(moved.id);
      const bool did = items_[i].box.overlaps(items_[j].box), does = boxes[i].overlaps(boxes[j]);
      if (did != does) changed_.push_back({std::min(passed.id, moved.id), std::max(passed.id, moved.id)});
    }
    ends[at] = moved;
  }
}

void SweepAndPrune::apply_changes(std::span<const Aabb> boxes) {
  changed_ = sorted_unique(std::move(changed_));
  // A pair that changed is in exactly one of the old and the new set, so the new set is the symmetric
  // difference.
  std::vector<BoxPair> now;
  now.reserve(pairs_.size() + changed_.size());
  std::set_symmetric_difference(pairs_.begin(), pairs_.end(), changed_.begin(), changed_.end(),
                                std::back_inserter(now));
  pairs_.swap(now);
  for (std::size_t i = 0; i < boxes.size(); ++i) items_[i].box = boxes[i];
}

}  // namespace rigor
