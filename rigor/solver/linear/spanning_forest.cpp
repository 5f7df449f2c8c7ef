#include "rigor/solver/linear/spanning_forest.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace rigor {
namespace {

/// Sets of nodes that are joined so far; the ground is the element after the last node.
class JoinedNodes {
 public:
  explicit JoinedNodes(int count) : parents_(at(count)) { std::iota(parents_.begin(), parents_.end(), 0); }
  /// False if they were joined before.
  bool join(int a, int b) {
    a = first_of(a);
    b = first_of(b);
    if (a == b) return false;
    parents_[at(std::max(a, b))] = std::min(a, b);
    return true;
  }

 private:
  int first_of(int a) {
    while (parent(a) != a) a = parent(a) = parent(parent(a));
    return a;
  }
  int& parent(int a) { return parents_[at(a)]; }
  std::vector<int> parents_;
};

/// Links to be taken into a forest, those of most rows first (Kruskal): few rows are left to close loops.
std::vector<int> links_by_rows(const ConstraintGraph& graph) {
  std::vector<int> links(graph.links.size());
  std::iota(links.begin(), links.end(), 0);
  const auto rows = [&graph](int link) { return graph.links[at(link)].rows; };
  std::stable_sort(links.begin(), links.end(), [&rows](int a, int b) { return rows(a) > rows(b); });
  return links;
}

void check_graph(const ConstraintGraph& graph) {
  for (const ConstraintGraph::Link& link : graph.links) {
    RIGOR_ASSERT(link.rows >= 1 && link.rows <= 6 && !link.nodes.empty());
    std::vector<int> nodes = link.nodes;
    std::sort(nodes.begin(), nodes.end());
    RIGOR_ASSERT(nodes.front() >= 0 && nodes.back() < graph.node_count);
    RIGOR_ASSERT(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
  }
}

}  // namespace

SpanningForest::SpanningForest(const ConstraintGraph& graph) {
  check_graph(graph);
  const int ground = graph.node_count;
  // A link that joins two trees, or a tree to the ground, belongs to the forest; any other closes a loop.
  std::vector<std::vector<int>> tree_links(at(ground) + 1);
  JoinedNodes joined(ground + 1);
  for (const int link : links_by_rows(graph)) {
    const std::vector<int>& ends = graph.links[at(link)].nodes;
    const int other = ends.size() == 1 ? ground : ends.back();
    if (ends.size() > 2 || !joined.join(ends.front(), other)) {
      loop_links.push_back(link);
      continue;
    }
    tree_links[at(ends.front())].push_back(link);
    tree_links[at(other)].push_back(link);
  }
  std::sort(loop_links.begin(), loop_links.end());

  // Each tree from its root, by breadth.
  places.assign(at(ground), -1);
  const auto add = [this](const Node& node) {
    places[at(node.node)] = static_cast<int>(nodes.size());
    nodes.push_back(node);
  };
  const auto add_children = [&](int node, int place, int link_to_parent) {
    for (const int link : tree_links[at(node)]) {
      if (link == link_to_parent) continue;
      const std::vector<int>& ends = graph.links[at(link)].nodes;
      const bool is_first_end = ends.front() != node;
      add({is_first_end ? ends.front() : ends.back(), place, link, is_first_end});
    }
  };
  std::size_t done = 0;
  const auto add_all_below = [&] {
    for (; done < nodes.size(); ++done)
      add_children(nodes[done].node, static_cast<int>(done), nodes[done].link);
  };
  add_children(ground, -1, -1);
  add_all_below();
  for (int node = 0; node < ground; ++node) {
    if (places[at(node)] >= 0) continue;
    add({node, -1, -1, true});
    add_all_below();
  }
}

std::vector<SpanningForest::PathNode> SpanningForest::path(std::span<const int> graph_nodes) const {
  // All places between these nodes and their roots.
  std::vector<int> reached;
  for (const int node : graph_nodes) {
    for (int place = places[at(node)]; place >= 0; place = nodes[at(place)].parent) reached.push_back(place);
  }
  // Children have higher places than their parents.
  reached = sorted_unique(std::move(reached), std::greater<>());

  // Each with its parent's position in the path itself.
  std::vector<PathNode> path;
  for (const int place : reached) {
    const int parent = nodes[at(place)].parent;
    const auto next = std::lower_bound(reached.begin(), reached.end(), parent, std::greater<>());
    path.push_back({place, parent < 0 ? -1 : static_cast<int>(next - reached.begin())});
  }
  return path;
}

}  // namespace rigor
