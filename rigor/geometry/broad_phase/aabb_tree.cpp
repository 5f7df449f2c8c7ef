#include "rigor/geometry/broad_phase/aabb_tree.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/box_area.hpp"

#include <algorithm>

namespace rigor {
namespace {

bool is_bounded(const Aabb& box) {
  return box.lower.allFinite() && box.upper.allFinite();
}

}  // namespace

void AabbTree::set(int id, const Aabb& box) {
  RIGOR_ASSERT(id >= 0);
  const std::size_t index = at(id);
  if (index >= leaf_of_.size()) leaf_of_.resize(index + 1, -1);
  const int old_leaf = leaf_of_[index];

  // An unbounded box goes into the list beside the tree.
  if (!is_bounded(box)) {
    remove(id);
    unbounded_.push_back({id, box});
    return;
  }
  if (old_leaf >= 0) {
    // An item that moves inside its parent's box keeps its place; only the bounds of its ancestors change.
    const int parent = nodes_[at(old_leaf)].parent;
    if (parent >= 0 && nodes_[at(parent)].box.contains(box)) {
      nodes_[at(old_leaf)].box = box;
      refit_upwards(parent);
      return;
    }
  }
  // Any other item is taken out and inserted where it now costs least.
  remove(id);
  const int leaf = new_node();
  nodes_[at(leaf)].box = box;
  nodes_[at(leaf)].id = id;
  leaf_of_[index] = leaf;
  insert_leaf(leaf);
}

void AabbTree::remove(int id) {
  const std::size_t index = at(id);
  if (id < 0 || index >= leaf_of_.size()) return;
  std::erase_if(unbounded_, [id](const Unbounded& item) { return item.id == id; });
  if (leaf_of_[index] < 0) return;
  remove_leaf(leaf_of_[index]);
  free_.push_back(leaf_of_[index]);
  leaf_of_[index] = -1;
}

std::vector<int> AabbTree::overlapping(const Aabb& box) const {
  std::vector<int> ids;
  overlapping(box, ids);
  return ids;
}

void AabbTree::overlapping(const Aabb& box, std::vector<int>& ids) const {
  ids.clear();
  for (const Unbounded& item : unbounded_) {
    if (item.box.overlaps(box)) ids.push_back(item.id);
  }
  // Depth first without a stack: down the left children, and back along the parents to the next right
  // sibling.
  int index = root_;
  while (index >= 0) {
    const Node& node = nodes_[at(index)];
    const bool meets = node.box.overlaps(box);
    if (meets && node.id >= 0) ids.push_back(node.id);
    if (meets && node.id < 0) {
      index = node.left;
      continue;
    }
    int parent = node.parent;
    while (parent >= 0 && nodes_[at(parent)].right == index) {
      index = parent;
      parent = nodes_[at(index)].parent;
    }
    index = parent >= 0 ? nodes_[at(parent)].right : -1;
  }
  std::sort(ids.begin(), ids.end());
}

int AabbTree::height() const {
  return root_ < 0 ? 0 : nodes_[at(root_)].height;
}

void AabbTree::clear() {
  nodes_.clear();
  free_.clear();
  leaf_of_.clear();
  unbounded_.clear();
  root_ = -1;
}

int AabbTree::new_node() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return static_cast<int>(nodes_.size()) - 1;
  }
  const int index = free_.back();
  free_.pop_back();
  nodes_[at(index)] = Node{};
  return index;
}

/// The node beside which a new leaf adds least to the surfaces on its path (surface-area heuristic): a random
/// box meets a node with a probability in proportion to its surface.
int AabbTree::find_sibling(const Aabb& box) const {
  int index = root_;
  double inherited = 0;  // Growth of the ancestors' areas if the leaf goes below them.
  while (nodes_[at(index)].id < 0) {
    const Node& node = nodes_[at(index)];
    const double joint_area = half_area(node.box.united(box));
    const double cost_here = inherited + joint_area;
    inherited += joint_area - half_area(node.box);

    // Lower bound of the cost below a child: a leaf is joined with the new one; an inner node grows, and the
    // new pair is at least as large as the new box.
    const auto cost_below = [&](int child_index) {
      const Node& child = nodes_[at(child_index)];
      const double joint = half_area(child.box.united(box));
      return inherited + (child.id >= 0 ? joint : joint - half_area(child.box) + half_area(box));
    };
    const double cost_left = cost_below(node.left);
    const double cost_right = cost_below(node.right);
    if (cost_here < cost_left && cost_here < cost_right) break;
    // Of equally good children the lower one keeps the tree balanced.
    const bool left_is_lower = nodes_[at(node.left)].height <= nodes_[at(node.right)].height;
    const bool goes_left = cost_left < cost_right || (cost_left == cost_right && left_is_lower);
    index = goes_left ? node.left : node.right;
  }
  return index;
}

void AabbTree::insert_leaf(int leaf) {
  if (root_ < 0) {
    root_ = leaf;
    return;
  }
  // A new node takes the place of the sibling and becomes the parent of both.
  const int sibling = find_sibling(nodes_[at(leaf)].box);
  const int parent = new_node();
  const int grandparent = nodes_[at(sibling)].parent;
  replace_child(grandparent, sibling, parent);

  Node& joint = nodes_[at(parent)];
  joint.left = sibling;
  joint.right = leaf;
  nodes_[at(sibling)].parent = parent;
  nodes_[at(leaf)].parent = parent;
  refit_upwards(parent);
}

void AabbTree::remove_leaf(int leaf) {
  const int parent = nodes_[at(leaf)].parent;
  if (parent < 0) {
    root_ = -1;
    return;
  }
  // The sibling of the leaf takes the place of their parent.
  const Node& joint = nodes_[at(parent)];
  const int sibling = joint.left == leaf ? joint.right : joint.left;
  const int grandparent = joint.parent;
  replace_child(grandparent, parent, sibling);
  free_.push_back(parent);
  refit_upwards(grandparent);
}

void AabbTree::refit(int index) {
  Node& node = nodes_[at(index)];
  const Node& left = nodes_[at(node.left)];
  const Node& right = nodes_[at(node.right)];
  node.box = left.box.united(right.box);
  node.height = 1 + std::max(left.height, right.height);
}

/// Brings boxes and heights up to date from the node towards the root, as far as anything changes, and
/// rotates each node on this path.
void AabbTree::refit_upwards(int index) {
  while (index >= 0) {
    const Node& node = nodes_[at(index)];
    const Aabb box = node.box;
    const int height = node.height;
    refit(index);
    rotate(index);
    if (node.height == height && node.box.lower == box.lower && node.box.upper == box.upper) return;
    index = node.parent;
  }
}

/// Tree rotation: exchanges a child of the node with a child of its sibling where that shrinks the sibling
/// most; among equal areas, where it makes the node lower (items in one place would otherwise form a list).
void AabbTree::rotate(int index) {
  const Node& node = nodes_[at(index)];
  int best_child = -1, best_grandchild = -1;
  double best_gain = 0;
  int best_drop = 0;

  for (const int child : {node.left, node.right}) {
    const int sibling_index = child == node.left ? node.right : node.left;
    const Node& sibling = nodes_[at(sibling_index)];
    if (sibling.id >= 0) continue;
    const Node& moved = nodes_[at(child)];
    for (const int grandchild : {sibling.left, sibling.right}) {
      const Node& stays = nodes_[at(grandchild == sibling.left ? sibling.right : sibling.left)];
      const Node& rises = nodes_[at(grandchild)];
      // The sibling keeps one of its children and gets the child of the node in place of the other.
      const double gain = half_area(sibling.box) - half_area(stays.box.united(moved.box));
      const int height_after = 1 + std::max(rises.height, 1 + std::max(stays.height, moved.height));
      const int drop = node.height - height_after;
      if (gain > best_gain || (gain == best_gain && drop > best_drop)) {
        best_child = child;
        best_grandchild = grandchild;
        best_gain = gain;
        best_drop = drop;
      }
    }
  }
  if (best_child < 0) return;
  swap_subtrees(best_child, best_grandchild);
  refit(index);
}

void AabbTree::swap_subtrees(int child, int grandchild) {
  const int node = nodes_[at(child)].parent;
  const int sibling = nodes_[at(grandchild)].parent;
  replace_child(node, child, grandchild);
  replace_child(sibling, grandchild, child);
  refit(sibling);
}

void AabbTree::replace_child(int parent, int old_child, int new_child) {
  nodes_[at(new_child)].parent = parent;
  if (parent < 0) {
    root_ = new_child;
    return;
  }
  Node& node = nodes_[at(parent)];
  (node.left == old_child ? node.left : node.right) = new_child;
}

}  // namespace rigor
