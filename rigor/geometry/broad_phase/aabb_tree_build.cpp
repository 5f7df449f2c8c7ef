#include "rigor/core/index.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/shape/box_area.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace rigor {
namespace {

constexpr std::size_t kBinCount = 16;  ///< The heuristic tries the cuts between the bins.

struct Bin {
  Aabb box = empty_box();
  std::size_t count = 0;
};

/// The cut with the least sum of area · count over both sides (Wald 2007). The bins before it go to the left.
std::size_t cheapest_cut(const std::array<Bin, kBinCount>& bins) {
  // Two sweeps suffice: the first, from the right, leaves the cost of everything right of each cut; the
  // second, from the left, adds the left side.
  std::array<double, kBinCount> right_cost{};
  Bin right, left;
  for (std::size_t b = kBinCount; b-- > 1;) {
    right.box = right.box.united(bins[b].box);
    right.count += bins[b].count;
    right_cost[b] = half_area(right.box) * static_cast<double>(right.count);
  }
  double best_cost = std::numeric_limits<double>::infinity();
  std::size_t best = 1;
  for (std::size_t b = 1; b < kBinCount; ++b) {
    left.box = left.box.united(bins[b - 1].box);
    left.count += bins[b - 1].count;
    const double cost = half_area(left.box) * static_cast<double>(left.count) + right_cost[b];
    if (cost < best_cost) {
      best_cost = cost;
      best = b;
    }
  }
  return best;
}

/// Puts the items of the left child first and returns their number. The cut is between bins along the longest
/// side of the box of the centres, or in the middle if all centres coincide.
std::size_t partition(std::span<BoxItem> items) {
  Aabb range = empty_box();  // Of the doubled centres.
  for (const BoxItem& item : items) {
    const Vec3 twice = item.box.lower + item.box.upper;
    range = range.united({twice, twice});
  }
  int axis = 0;
  const double length = (range.upper - range.lower).maxCoeff(&axis);
  if (!(length > 0)) return items.size() / 2;

  const auto bin_of = [&](const BoxItem& item) {
    const double place = (item.box.lower(axis) + item.box.upper(axis) - range.lower(axis)) / length;
    return std::min(kBinCount - 1, static_cast<std::size_t>(static_cast<double>(kBinCount) * place));
  };
  // Binning: each bin knows the number and the box of the items whose centres it holds.
  std::array<Bin, kBinCount> bins;
  for (const BoxItem& item : items) {
    Bin& bin = bins[bin_of(item)];
    bin.box = bin.box.united(item.box);
    ++bin.count;
  }
  const std::size_t cut = cheapest_cut(bins);
  const auto middle =
      std::partition(items.begin(), items.end(), [&](const BoxItem& item) { return bin_of(item) < cut; });
  return at(middle - items.begin());
}

}  // namespace

void AabbTree::build(std::span<const BoxItem> items) {
  clear();
  std::vector<BoxItem> bounded;
  bounded.reserve(items.size());
  for (const BoxItem& item : items) {
    const std::size_t index = at(item.id);
    if (index >= leaf_of_.size()) leaf_of_.resize(index + 1, -1);
    if (item.box.lower.allFinite() && item.box.upper.allFinite()) {
      bounded.push_back(item);
    } else {
      unbounded_.push_back({item.id, item.box});
    }
  }
  // A binary tree with n leaves has 2 n - 1 nodes.
  if (bounded.empty()) return;
  nodes_.reserve(2 * bounded.size() - 1);
  root_ = build_range(bounded, -1);
}

/// Builds the subtree of the items, top down, and returns its root.
int AabbTree::build_range(std::span<BoxItem> items, int parent) {
  const int index = new_node();
  nodes_[at(index)].parent = parent;
  if (items.size() == 1) {
    Node& leaf = nodes_[at(index)];
    leaf.box = items[0].box;
    leaf.id = items[0].id;
    leaf_of_[at(leaf.id)] = index;
    return index;
  }
  const std::size_t left_count = partition(items);
  const int left = build_range(items.first(left_count), index);
  const int right = build_range(items.subspan(left_count), index);
  nodes_[at(index)].left = left;
  nodes_[at(index)].right = right;
  refit(index);
  return index;
}

void AabbTree::refit(std::span<const Aabb> boxes) {
  // Children come before their parents: the nodes in breadth-first order, backwards.
  std::vector<int> order;
  order.reserve(nodes_.size());
  if (root_ >= 0) order.push_back(root_);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Node& node = nodes_[at(order[k])];
    if (node.id < 0) order.insert(order.end(), {node.left, node.right});
  }
  for (std::size_t k = order.size(); k-- > 0;) {
    Node& node = nodes_[at(order[k])];
    if (node.id < 0) {
      refit(order[k]);
      continue;
    }
    RIGOR_ASSERT(at(node.id) < boxes.size());
    node.box = boxes[at(node.id)];
    RIGOR_ASSERT(node.box.lower.allFinite() && node.box.upper.allFinite());
  }
}

std::vector<BoxPair> AabbTree::overlapping_pairs() const {
  std::vector<BoxPair> pairs;
  const auto add = [&](int a, int b) { pairs.push_back({std::min(a, b), std::max(a, b)}); };
  // Pairs of subtrees that are still to be compared. A subtree paired with itself stands for the pairs of
  // items inside it.
  std::vector<std::pair<int, int>> waiting;
  if (root_ >= 0) waiting.emplace_back(root_, root_);
  while (!waiting.empty()) {
    const auto [a, b] = waiting.back();
    waiting.pop_back();
    const Node &node_a = nodes_[at(a)], &node_b = nodes_[at(b)];
    if (a == b) {
      if (node_a.id >= 0) continue;
      waiting.insert(waiting.end(),
                     {{node_a.left, node_a.left}, {node_a.right, node_a.right}, {node_a.left, node_a.right}});
      continue;
    }
    // Of two subtrees whose boxes overlap the higher one is replaced by its children, until both are leaves.
    if (!node_a.box.overlaps(node_b.box)) continue;
    if (node_a.id >= 0 && node_b.id >= 0) {
      add(node_a.id, node_b.id);
    } else if (node_b.id >= 0 || (node_a.id < 0 && node_a.height >= node_b.height)) {
      waiting.insert(waiting.end(), {{node_a.left, b}, {node_a.right, b}});
    } else {
      waiting.insert(waiting.end(), {{a, node_b.left}, {a, node_b.right}});
    }
  }
  // Unbounded items are compared with all others; a pair of two of them is found twice and added once.
  std::vector<int> ids;
  for (const Unbounded& item : unbounded_) {
    overlapping(item.box, ids);
    for (const int other : ids) {
      const bool is_unbounded = leaf_of_[at(other)] < 0;
      if (!is_unbounded || other > item.id) add(item.id, other);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace rigor
