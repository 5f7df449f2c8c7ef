#pragma once

#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/geometry/mesh/triangle_pair.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/mesh/wide_tree.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace rigor {

/// The walk over two trees that all queries of two meshes share. A visitor decides which pairs matter:
///
///   double limit()                pairs of boxes with a greater bound (see child_bounds) are skipped
///   Vec3 direction()              a unit vector, in A, along which B may be apart from A, or zero
///   void pass(a, b)               is told of these; a and b are places in the trees
///   bool meet(a, b)               visits two triangles (at these places); true ends the walk
class MeshPairSearch {
 public:
  /// A pair of places in both trees that is still to be visited.
  struct Entry {
    double bound;
    int a, b;
  };

  MeshPairSearch(const Mesh& a, const Mesh& b, const Pose& X_AB)
      : a_(a), b_(b), tree_A_(a.tree->wide), tree_B_(b.tree->wide), X_AB_(X_AB), X_BA_(X_AB.inverse()) {
    const OrientedBox &root_A = tree_A_.root, &root_B = tree_B_.root;
    const double size = root_A.center.norm() + root_A.half.sum() + root_B.center.norm() + root_B.half.sum();
    rounding_ = 16 * std::numeric_limits<double>::epsilon() * (size + X_AB.p.norm());
    stack_.reserve(256);
  }

  /// A few roundings of the coordinates of both meshes in one frame [m].
  double rounding() const { return rounding_; }
  /// Number of node tests so far.
  int cost() const { return cost_; }

  TriangleCorners corners_A(int triangle) const { return corners(*a_.mesh, triangle); }
  /// In the frame of A.
  TriangleCorners corners_B(int triangle) const {
    TriangleCorners t = corners(*b_.mesh, triangle);
    for (Vec3& p : t) p = X_AB_ * p;
    return t;
  }
  OrientedBox box_A(int place) const { return tree_A_.box_at(place); }
  /// In the frame of B.
  OrientedBox box_B(int place) const { return tree_B_.box_at(place); }
  const Pose& X_AB() const { return X_AB_; }
  int triangle_A(int place) const { return ~tree_A_.child_at(place); }
  int triangle_B(int place) const { return ~tree_B_.child_at(place); }

  /// The pair of leaves that descending into the nearest child leads to. Both trees must have nodes, and the
  /// visitor's limit must be infinite.
  template <typename Visitor>
  Entry nearest_leaves(Visitor& visitor) {
    Entry entry{0, -1, -1};
    for (;;) {
      const int child_A = tree_A_.child_at(entry.a), child_B = tree_B_.child_at(entry.b);
      if (child_A < 0 && child_B < 0) return entry;
      stack_.clear();
      open(entry, child_A, child_B, visitor);
      entry = stack_.back();
    }
  }

  /// Visits everything below a pair of places; true if the visitor ended the walk.
  template <typename Visitor>
  bool walk(const Entry& start, Visitor& visitor) {
    if (tree_A_.nodes.empty() || tree_B_.nodes.empty()) return false;
    stack_.assign(1, start);
    while (!stack_.empty()) {
      // The limit may have fallen since the pair was pushed.
      const Entry entry = stack_.back();
      stack_.pop_back();
      if (entry.bound > visitor.limit()) {
        visitor.pass(entry.a, entry.b);
        continue;
      }
      const int child_A = tree_A_.child_at(entry.a), child_B = tree_B_.child_at(entry.b);
      // Pairs of boxes are opened; two leaves are two triangles, which the visitor decides about.
      count_following(1);
      if (child_A >= 0 || child_B >= 0) {
        open(entry, child_A, child_B, visitor);
      } else if (visitor.meet(entry.a, entry.b)) {
        return true;
      }
    }
    return false;
  }

 private:
  static TriangleCorners corners(const TriangleMesh& mesh, int triangle) {
    const std::array<int, 3>& v = mesh.triangles[at(triangle)];
    return {mesh.vertices[at(v[0])], mesh.vertices[at(v[1])], mesh.vertices[at(v[2])]};
  }
  static OrientedBox moved(const Pose& X, const OrientedBox& box) {
    return {X * box.center, X.R * box.axes, box.half};
  }

  /// Replaces a pair by the pairs of the children of its larger box with the other box, without those beyond
  /// the limit; the nearest is on top.
  template <typename Visitor>
  void open(const Entry& entry, int child_A, int child_B, Visitor& visitor) {
    const OrientedBox box_A = tree_A_.box_at(entry.a), box_B = tree_B_.box_at(entry.b);
    // The larger box is opened, since its bounds are the coarser ones; a leaf cannot be.
    const bool open_A = child_B < 0 || (child_A >= 0 && box_A.half.squaredNorm() >= box_B.half.squaredNorm());
    const int node_index = open_A ? child_A : child_B;
    const WideTree::Node& node = (open_A ? tree_A_ : tree_B_).nodes[at(node_index)];
    // One test bounds all children of the opened node, in the frame of their mesh.
    const Vec3 n_A = visitor.direction();
    const OtherBox other = open_A ? OtherBox{moved(X_AB_, box_B), -n_A, rounding_}
                                  : OtherBox{moved(X_BA_, box_A), X_BA_.R * n_A, rounding_};
    ++cost_;
    count_following(1);
    const ChildBounds bounds = child_bounds(node, other);
    const double limit = visitor.limit();
    const std::size_t first = stack_.size();
    for (int k = 0; k < node.count; ++k) {
      const int place = node_index * WideTree::kWidth + k;
      const Entry next{bounds[at(k)], open_A ? place : entry.a, open_A ? entry.b : place};
      if (next.bound > limit) {
        visitor.pass(next.a, next.b);
        continue;
      }
      // Insertion sort: bounds fall from the bottom to the top.
      stack_.push_back(next);
      std::size_t spot = stack_.size() - 1;
      for (; spot > first && stack_[spot - 1].bound < next.bound; --spot) stack_[spot] = stack_[spot - 1];
      stack_[spot] = next;
    }
  }

  const Mesh& a_;
  const Mesh& b_;
  const WideTree& tree_A_;
  const WideTree& tree_B_;
  const Pose X_AB_, X_BA_;
  double rounding_;
  int cost_ = 0;
  std::vector<Entry> stack_;
};

}  // namespace rigor
