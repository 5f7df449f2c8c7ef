#include "rigor/geometry/mesh/triangle_tree.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/mesh_edges.hpp"
#include "rigor/geometry/mesh/mesh_faces.hpp"
#include "rigor/geometry/shape/box_area.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace rigor {
namespace {

constexpr int kLeafSize = 4;   ///< Most triangles of a leaf: fewer cost more box tests than they save.
constexpr int kBinCount = 16;  ///< Bins of centres between which the heuristic may cut.

/// Recursive top-down build over `order[first, first + count)`.
class Builder {
 public:
  Builder(const TriangleMesh& mesh, TriangleTree& tree) : tree_(tree) {
    for (const std::array<int, 3>& t : mesh.triangles) {
      Aabb box = empty_box();
      for (const int v : t) {
        const Vec3& p = mesh.vertices[at(v)];
        box = box.united({p, p});
      }
      boxes_.push_back(box);
      centers_.push_back(0.5 * (box.lower + box.upper));
    }
  }

  void build(int first, int count) {
    const std::size_t index = tree_.nodes.size();
    tree_.nodes.push_back({bounds(first, count), first, count});
    if (count <= kLeafSize) return;
    // The left subtree follows its parent, so that only the index of the right child is stored.
    const int left_count = partition(first, count);
    build(first, left_count);
    tree_.nodes[index].first = static_cast<int>(tree_.nodes.size());
    tree_.nodes[index].count = 0;
    build(first + left_count, count - left_count);
  }

 private:
  struct Bin {
    Aabb box = empty_box();
    int count = 0;
  };

  int triangle(int k) const { return tree_.order[at(k)]; }
  const Vec3& center(int t) const { return centers_[at(t)]; }

  Aabb bounds(int first, int count) const {
    Aabb box = empty_box();
    for (int k = first; k < first + count; ++k) box = box.united(boxes_[at(triangle(k))]);
    return box;
  }

  /// Reorders the range and returns how many triangles belong to the left child: at the cheapest cut between
  /// bins along the longest side of the box of centres, or at the median where all centres coincide.
  int partition(int first, int count) {
    Aabb range = empty_box();
    for (int k = first; k < first + count; ++k)
      range = range.united({center(triangle(k)), center(triangle(k))});
    // Centres that coincide cannot be told apart by a plane.
    int axis = 0;
    const double length = (range.upper - range.lower).maxCoeff(&axis);
    if (!(length > 0)) return count / 2;

    const auto bin_of = [&](int t) {
      const double place = (center(t)(axis) - range.lower(axis)) / length;
      return std::min(kBinCount - 1, static_cast<int>(kBinCount * place));
    };
    const int cut = cheapest_cut(first, count, bin_of);
    const auto begin = tree_.order.begin() + first;
    // A stable partition, so that the tree depends on the mesh alone.
    const auto middle = std::stable_partition(begin, begin + count, [&](int t) { return bin_of(t) < cut; });
    return static_cast<int>(middle - begin);
  }

  /// Surface-area heuristic: the cut with the least sum of area · count of both sides. The extreme bins are
  /// never empty, so that both sides have triangles.
  template <typename BinOf>
  int cheapest_cut(int first, int count, const BinOf& bin_of) const {
    std::array<Bin, kBinCount> bins;
    for (int k = first; k < first + count; ++k) {
      Bin& bin = bins[at(bin_of(triangle(k)))];
      bin.box = bin.box.united(boxes_[at(triangle(k))]);
      ++bin.count;
    }
    // One sweep from the right for the cost of every right side, one from the left for the sum.
    std::array<double, kBinCount> right_cost{};
    Bin right;
    for (std::size_t b = kBinCount; b-- > 1;) {
      right.box = right.box.united(bins[b].box);
      right.count += bins[b].count;
      right_cost[b] = half_area(right.box) * right.count;
    }
    Bin left;
    double best_cost = std::numeric_limits<double>::infinity();
    int best = 1;
    for (std::size_t b = 1; b < kBinCount; ++b) {
      left.box = left.box.united(bins[b - 1].box);
      left.count += bins[b - 1].count;
      const double cost = half_area(left.box) * left.count + right_cost[b];
      if (cost < best_cost) {
        best_cost = cost;
        best = static_cast<int>(b);
      }
    }
    return best;
  }

  TriangleTree& tree_;
  std::vector<Aabb> boxes_;
  std::vector<Vec3> centers_;
};

}  // namespace

std::vector<int> TriangleTree::overlapping(const Aabb& box) const {
  // Depth first, with the right children still to be visited on a stack.
  std::vector<int> hits;
  std::size_t index = 0;
  std::vector<std::size_t> right_children;
  while (index < nodes.size()) {
    const Node& node = nodes[index];
    const bool meets = node.box.overlaps(box);
    if (meets && node.count == 0) {
      right_children.push_back(at(node.first));
      ++index;
      continue;
    }
    if (meets) hits.insert(hits.end(), order.begin() + node.first, order.begin() + node.first + node.count);
    if (right_children.empty()) break;
    index = right_children.back();
    right_children.pop_back();
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

std::shared_ptr<const TriangleTree> make_triangle_tree(const TriangleMesh& mesh) {
  const std::shared_ptr<TriangleTree> tree = std::make_shared<TriangleTree>();
  find_mesh_edges(mesh, *tree);
  for (std::size_t t = 0; t < tree->triangles.size(); ++t) {
    // Triangles without area have no normal and are left out.
    if (!tree->triangles[t].normal.isZero(0)) tree->order.push_back(static_cast<int>(t));
  }
  tree->wide = make_wide_tree(mesh, tree->order);
  if (tree->order.empty()) return tree;
  Builder(mesh, *tree).build(0, static_cast<int>(tree->order.size()));
  tree->size = (tree->nodes.front().box.upper - tree->nodes.front().box.lower).maxCoeff();
  find_mesh_faces(mesh, *tree);
  return tree;
}

int edge_number(const TriangleMesh& mesh, const TriangleTree& tree, int t, int k) {
  const int other = tree.triangles[at(t)].neighbour[at(k)];
  if (other < 0 || other > t) return 3 * t + k;
  const int start = mesh.triangles[at(t)][at((k + 1) % 3)];
  for (int j = 0; j < 3; ++j) {
    if (mesh.triangles[at(other)][at(j)] == start) return 3 * other + j;
  }
  return 3 * t + k;
}

}  // namespace rigor
