#include "rigor/geometry/broad_phase/box_pairs.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Number of boxes in a leaf. So few are cheaper to compare one by one than to divide further.
constexpr int kLeafSize = 4;

/// Binary tree over the boxes. Each node holds a range of `order_`, its children the two halves of the range.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Aabb>& boxes) : boxes_(boxes), order_(boxes.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
    if (!boxes.empty()) build(0, static_cast<int>(boxes.size()));
  }

  std::vector<std::array<int, 2>> pairs() {
    if (!nodes_.empty()) visit(0, 0);
    std::sort(pairs_.begin(), pairs_.end());
    return std::move(pairs_);
  }

 private:
  struct Node {
    Aabb box;
    int first, count;
    int left = -1, right = -1;  ///< -1 in leaves.
  };

  int build(int first, int count) {
    Node node{boxes_[at(order_[at(first)])], first, count};
    for (int i = first; i < first + count; ++i) node.box = node.box.united(boxes_[at(order_[at(i)])]);
    const int id = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    if (count <= kLeafSize) return id;

    // The median of the centres along the longest side divides the range in halves; ties are broken by index,
    // so that the result is the same everywhere.
    int axis;
    (node.box.upper - node.box.lower).maxCoeff(&axis);
    const int half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](int i, int j) {
      const double a = boxes_[at(i)].lower[axis] + boxes_[at(i)].upper[axis];
      const double b = boxes_[at(j)].lower[axis] + boxes_[at(j)].upper[axis];
      return a < b || (a == b && i < j);
    });
    const int left = build(first, half);
    const int right = build(first + half, count - half);
    nodes_[at(id)].left = left;
    nodes_[at(id)].right = right;
    return id;
  }

  /// Compares two subtrees; one with itself stands for the pairs inside it. Of two different ones the larger
  /// is opened.
  void visit(int a, int b) {
    const Node &node_a = nodes_[at(a)], &node_b = nodes_[at(b)];
    if (!node_a.box.overlaps(node_b.box)) return;
    poll_interrupt();
    if (a == b && node_a.left >= 0) {
      visit(node_a.left, node_a.left);
      visit(node_a.left, node_a.right);
      visit(node_a.right, node_a.right);
    } else if (node_a.left < 0 && node_b.left < 0) {
      compare(node_a, node_b, a == b);
    } else if (node_b.left < 0 || (node_a.left >= 0 && node_a.count >= node_b.count)) {
      visit(node_a.left, b);
      visit(node_a.right, b);
    } else {
      visit(a, node_b.left);
      visit(a, node_b.right);
    }
  }

  void compare(const Node& a, const Node& b, bool is_same) {
    for (int i = a.first; i < a.first + a.count; ++i) {
      for (int j = is_same ? i + 1 : b.first; j < b.first + b.count; ++j) {
        const int u = order_[at(i)], v = order_[at(j)];
        if (boxes_[at(u)].overlaps(boxes_[at(v)])) pairs_.push_back({std::min(u, v), std::max(u, v)});
      }
    }
  }

  const std::vector<Aabb>& boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
  std::vector<std::array<int, 2>> pairs_;
};

}  // namespace

std::vector<std::array<int, 2>> overlapping_pairs(const std::vector<Aabb>& boxes) {
  return BoxTree(boxes).pairs();
}

}  // namespace rigor
