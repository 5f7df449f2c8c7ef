#include "rigor/bulk/broad_phase/near_bodies.hpp"

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace rigor {

namespace {

bool is_pair_before(const NearBodies::Pair& p, const NearBodies::Pair& q) {
  return p.a != q.a ? p.a < q.a : p.b < q.b;
}

/// The box relative to another origin, a little larger than rounding can make it.
FloatBox shifted(const FloatBox& box, const float* shift) {
  constexpr float rounding = 1e-6f;
  FloatBox moved;
  for (int k = 0; k < 3; ++k) {
    // Both the numbers and their sum are rounded.
    const float slack =
        rounding * (std::max(std::abs(box.lower[k]), std::abs(box.upper[k])) + std::abs(shift[k]));
    moved.lower[k] = box.lower[k] + shift[k] - slack;
    moved.upper[k] = box.upper[k] + shift[k] + slack;
  }
  return moved;
}

/// A box that overlaps nothing and holds nothing.
FloatBox empty_box() {
  constexpr float far = std::numeric_limits<float>::infinity();
  return {{far, far, far}, {-far, -far, -far}};
}

bool holds(const FloatBox& wide, const FloatBox& box) {
  bool is_inside = true;
  for (int k = 0; k < 3; ++k)
    is_inside &= bool(wide.lower[k] <= box.lower[k]) & bool(box.upper[k] <= wide.upper[k]);
  return is_inside;
}

}  // namespace

NearBodies::NearBodies(std::vector<int> moving, std::vector<int> standing, std::vector<float> radii,
                       float cell)
    : radii_(std::move(radii)), cell_(cell) {
  moving_.bodies = std::move(moving);
  standing_.bodies = std::move(standing);
  is_out_.resize(radii_.size());
  // Where the wide box of each body is.
  slot_.resize(radii_.size());
  kinds_.resize(radii_.size(), Kind::none);
  for (const int body : moving_.bodies) kinds_[at(body)] = Kind::moving;
  for (const int body : standing_.bodies) kinds_[at(body)] = Kind::standing;
  number_places(moving_);
  number_places(standing_);
}

void NearBodies::number_places(const Side& side) {
  for (std::size_t i = 0; i < side.bodies.size(); ++i) {
    const int place = static_cast<int>(i);
    if (side.bodies[i] >= 0) slot_[at(side.bodies[i])] = &side == &moving_ ? place : -1 - place;
  }
}

void NearBodies::change(const std::vector<Change>& changes, float cell) {
  cell_ = cell;
  if (changes.empty()) return;
  has_changed_ = true;
  std::fill(is_out_.begin(), is_out_.end(), 0);
  for (const Change& change : changes) {
    is_out_[at(change.body)] = 1;
    leave(change.body);
    radii_[at(change.body)] = change.radius;
    kinds_[at(change.body)] = change.kind;
    if (change.kind == Kind::moving) join(change.body, moving_);
    if (change.kind == Kind::standing) join(change.body, standing_);
  }
  std::erase_if(pairs_, [&](const Pair& pair) { return is_out_[at(pair.a)] || is_out_[at(pair.b)]; });
}

/// Takes a body off its side; its place is free for another.
void NearBodies::leave(int body) {
  if (kinds_[at(body)] == Kind::none) return;
  const bool is_moving = kinds_[at(body)] == Kind::moving;
  Side& side = is_moving ? moving_ : standing_;
  const int place = is_moving ? slot_[at(body)] : -1 - slot_[at(body)];
  side.bodies[at(place)] = -1;
  side.free.push_back(place);
  if (!is_built_) return;
  side.wide[at(place)] = empty_box();
  side.tree.replace(place, empty_box());
}

/// Puts a body on a side. Its box is put into the tree by the next update(), since it has left its wide box,
/// which holds nothing; where no place is free, the tree is built anew.
void NearBodies::join(int body, Side& side) {
  if (side.free.empty()) {
    is_built_ = false;
    side.free.push_back(static_cast<int>(side.bodies.size()));
    side.bodies.push_back(-1);
  }
  const int place = side.free.back();
  side.free.pop_back();
  side.bodies[at(place)] = body;
  slot_[at(body)] = &side == &moving_ ? place : -1 - place;
}

/// Before its tree is built: puts the bodies in the order of their numbers, with some free places behind them
/// where bodies come and go.
void NearBodies::close_gaps(Side& side) {
  constexpr std::size_t least_free = 32, free_share = 16;
  std::erase(side.bodies, -1);
  std::sort(side.bodies.begin(), side.bodies.end());
  side.free.clear();
  for (std::size_t k = least_free + side.bodies.size() / free_share; k > 0; --k) {
    side.free.push_back(static_cast<int>(side.bodies.size()));
    side.bodies.push_back(-1);
  }
  std::reverse(side.free.begin(), side.free.end());
  number_places(side);
}

/// The box with some room on all sides, and more in the direction of motion: it then stays inside for several
/// steps.
FloatBox NearBodies::wide_box(const Boxes& boxes, int body) const {
  // Four hundredths of a body's size on all sides, and its displacement in four steps.
  constexpr float room = 0.04f, steps = 4;
  const Vec3 d = boxes.origin - origin_;
  const float shift[] = {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())};
  FloatBox wide = shifted(boxes.box[at(body)], shift);
  for (int k = 0; k < 3; ++k) {
    const float ahead = steps * (boxes.h * boxes.motion[at(body)].v[k]);
    wide.lower[k] += std::min(ahead, 0.0f) - room * cell_;
    wide.upper[k] += std::max(ahead, 0.0f) + room * cell_;
  }
  return wide;
}

void NearBodies::find_escaped(const Boxes& boxes, const Executor& executor) {
  constexpr int grain = 512;
  const Vec3 d = boxes.origin - origin_;
  const float shift[] = {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())};
  // In parallel which bodies have left their wide boxes; their list is then in the order of bodies for any
  // number of threads.
  escaped_.clear();
  for (Side* side : {&moving_, &standing_}) {
    executor.for_ranges(static_cast<int>(side->bodies.size()), grain, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const int body = side->bodies[at(i)];
        if (body < 0) continue;
        is_out_[at(body)] = !holds(side->wide[at(i)], shifted(boxes.box[at(body)], shift));
      }
    });
    for (const int body : side->bodies)
      if (body >= 0 && is_out_[at(body)]) escaped_.push_back(body);
  }
}

void NearBodies::update(const Boxes& boxes, const PairFilter& filter, const Executor& executor) {
  if (is_built_) {
    find_escaped(boxes, executor);
    if (escaped_.empty()) return;
    // A few boxes are replaced in the trees. Replaced boxes make a tree worse, so all of them are searched
    // again when they add up to a quarter.
    replaced_ += escaped_.size();
    if (4 * replaced_ < moving_.bodies.size()) return replace(boxes, filter, executor);
  }
  build(boxes, filter, executor);
}

void NearBodies::build(const Boxes& boxes, const PairFilter& filter, const Executor& executor) {
  constexpr int blocks_of_a_part = 16;
  is_built_ = true;
  replaced_ = 0;
  origin_ = boxes.origin;
  if (has_changed_) {
    close_gaps(moving_);
    close_gaps(standing_);
    has_changed_ = false;
  }
  // Wide boxes of all bodies, and a tree of each kind.
  for (Side* side : {&moving_, &standing_}) {
    side->wide.resize(side->bodies.size());
    executor.for_ranges(static_cast<int>(side->bodies.size()), 512, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const int body = side->bodies[at(i)];
        side->wide[at(i)] = body < 0 ? empty_box() : wide_box(boxes, body);
      }
    });
    side->tree.build(side->wide, cell_);
  }
  // All pairs, in parts of a few blocks; their order is made afterwards.
  const int block_count = moving_.tree.block_count();
  std::vector<std::vector<Pair>> parts(at((block_count + blocks_of_a_part - 1) / blocks_of_a_part));
  executor.for_ranges(static_cast<int>(parts.size()), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k)
      search_blocks(k * blocks_of_a_part, std::min((k + 1) * blocks_of_a_part, block_count), filter,
                    parts[at(k)]);
  });
  put_in_order(parts, executor);
}

void NearBodies::search_blocks(int begin, int end, const PairFilter& filter, std::vector<Pair>& found) const {
  // Boxes of moving bodies among themselves, and against those of standing ones.
  std::vector<BoxTree::Pair> own, other;
  for (int block = begin; block < end; ++block) {
    moving_.tree.find_own_pairs(block, own);
    moving_.tree.find_pairs_with(standing_.tree, block, other);
  }
  const auto add = [&](int a, int b) {
    if (may_meet(a, b, filter)) found.push_back({std::min(a, b), std::max(a, b)});
  };
  for (const BoxTree::Pair& pair : own) add(moving_.bodies[at(pair.a)], moving_.bodies[at(pair.b)]);
  for (const BoxTree::Pair& pair : other) add(moving_.bodies[at(pair.a)], standing_.bodies[at(pair.b)]);
}

/// Whether two bodies may touch whose wide boxes overlap: by their rounded boxes, and by the Model.
bool NearBodies::may_meet(int a, int b, const PairFilter& filter) const {
  return rounded_boxes_touch(wide_of(a), radius(a), wide_of(b), radius(b)) && filter.may_collide(a, b);
}

const FloatBox& NearBodies::wide_of(int body) const {
  const int slot = slot_[at(body)];
  return slot >= 0 ? moving_.wide[at(slot)] : standing_.wide[at(-1 - slot)];
}

/// Sorts all pairs: each goes to the section of the list that belongs to its first body, and sections are
/// sorted by the second.
void NearBodies::put_in_order(const std::vector<std::vector<Pair>>& parts, const Executor& executor) {
  // Counting sort by the first body.
  std::vector<int> begin(slot_.size() + 1, 0);
  for (const std::vector<Pair>& part : parts)
    for (const Pair& pair : part) ++begin[at(pair.a) + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  renew(at(begin.back()), pairs_);
  for (const std::vector<Pair>& part : parts)
    for (const Pair& pair : part) pairs_[at(begin[at(pair.a)]++)] = pair;
  // Each entry is now the beginning of the next body's section.
  executor.for_ranges(static_cast<int>(begin.size()), 512, [&](int from, int to) {
    for (int i = from; i < to; ++i)
      std::sort(pairs_.begin() + (i == 0 ? 0 : begin[at(i - 1)]), pairs_.begin() + begin[at(i)],
                is_pair_before);
  });
}

/// Replaces the wide boxes of bodies that have left theirs, and finds their pairs.
void NearBodies::replace(const Boxes& boxes, const PairFilter& filter, const Executor& executor) {
  for (const int body : escaped_) {
    const bool is_moving = slot_[at(body)] >= 0;
    Side& side = is_moving ? moving_ : standing_;
    const int slot = is_moving ? slot_[at(body)] : -1 - slot_[at(body)];
    side.wide[at(slot)] = wide_box(boxes, body);
    side.tree.replace(slot, side.wide[at(slot)]);
  }
  // Their pairs, in parts; all wide boxes are in place by now.
  constexpr int bodies_of_a_part = 16;
  const int count = static_cast<int>(escaped_.size());
  std::vector<std::vector<Pair>> parts(at((count + bodies_of_a_part - 1) / bodies_of_a_part));
  executor.for_ranges(static_cast<int>(parts.size()), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const int last = std::min((k + 1) * bodies_of_a_part, count);
      for (int i = k * bodies_of_a_part; i < last; ++i) find_pairs_of(escaped_[at(i)], filter, parts[at(k)]);
    }
  });
  found_.clear();
  for (const std::vector<Pair>& part : parts) found_.insert(found_.end(), part.begin(), part.end());
  merge_found();
}

/// Adds the pairs of a body that has escaped.
void NearBodies::find_pairs_of(int body, const PairFilter& filter, std::vector<Pair>& found) const {
  std::vector<int> touched;
  const auto add_overlaps = [&](const Side& side) {
    touched.clear();
    side.tree.find_overlaps(wide_of(body), touched);
    for (const int slot : touched) {
      const int other = side.bodies[at(slot)];
      // A pair of two that have escaped is found twice, and taken once.
      if (other == body || (is_out_[at(other)] && other < body) || !may_meet(body, other, filter)) continue;
      found.push_back({std::min(body, other), std::max(body, other)});
    }
  };
  add_overlaps(moving_);
  // Two bodies that stand are no pair.
  if (slot_[at(body)] >= 0) add_overlaps(standing_);
}

/// Replaces the pairs of escaped bodies by those that were found.
void NearBodies::merge_found() {
  std::sort(found_.begin(), found_.end(), is_pair_before);
  std::erase_if(pairs_, [&](const Pair& pair) { return is_out_[at(pair.a)] || is_out_[at(pair.b)]; });
  merge_into(found_, is_pair_before, pairs_);
}

}  // namespace rigor
