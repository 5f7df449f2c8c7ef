#include "rigor/core/index.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"

#include <limits>
#include <queue>
#include <tuple>

namespace rigor {
namespace {

/// A node that is still to be examined, or an item beside the tree.
struct PendingNode {
  double bound;
  int id;  ///< Id of the item; -1 for an inner node, which comes before items with the same bound.
  int node;

  bool operator>(const PendingNode& other) const {
    return std::tie(bound, id, node) > std::tie(other.bound, other.id, other.node);
  }
};

}  // namespace

void AabbTree::search(const std::function<double(const Aabb&)>& bound,
                      const std::function<double(int)>& visit) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  double limit = never;
  std::priority_queue<PendingNode, std::vector<PendingNode>, std::greater<>> waiting;
  const auto push = [&](const Aabb& box, int id, int node) {
    const double least = bound(box);
    if (least < never && least <= limit) waiting.push({least, id, node});
  };
  for (const Unbounded& item : unbounded_) push(item.box, item.id, -1);
  if (root_ >= 0) {
    const Node& root = nodes_[at(root_)];
    push(root.box, root.id, root_);
  }
  // Best first: when an item is at the top, no box that is left can have a smaller bound. Inner nodes come
  // before items of the same bound, so that all of these are known before the first is visited.
  while (!waiting.empty() && waiting.top().bound <= limit) {
    const PendingNode next = waiting.top();
    waiting.pop();
    if (next.id >= 0) {
      limit = visit(next.id);
      continue;
    }
    const Node& node = nodes_[at(next.node)];
    for (const int child : {node.left, node.right}) {
      const Node& below = nodes_[at(child)];
      push(below.box, below.id, child);
    }
  }
}

}  // namespace rigor
