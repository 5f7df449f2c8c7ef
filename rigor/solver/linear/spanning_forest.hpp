#pragma once

#include <span>
#include <vector>

namespace rigor {

/// What joins what: nodes of six velocities each, and links, each some linear equations on the velocities of
/// its nodes. A node may appear once in a link; a link with one node holds it to the ground.
struct ConstraintGraph {
  struct Link {
    int rows = 0;            ///< 1 to 6.
    std::vector<int> nodes;  ///< One or more.
  };
  int node_count = 0;
  std::vector<Link> links;
};

/// Trees of the links of one or two nodes that reach every node, with as many rows as possible. The ground is
/// the root of the trees that are tied to it; of each other tree its first node is the root.
struct SpanningForest {
  struct Node {
    int node = 0;
    int parent = -1;  ///< Place of the parent in `nodes`; -1: the ground, or none.
    int link = -1;    ///< The link to the parent or to the ground; -1 for the root of a floating tree.
    bool is_first_end = true;  ///< Whether it is the first of the link's nodes.
  };
  std::vector<Node> nodes;      ///< Parents before children, roots in the order of their nodes.
  std::vector<int> places;      ///< Of each node of the graph in `nodes`.
  std::vector<int> loop_links;  ///< All links that are in no tree: those that close loops or have more nodes.

  explicit SpanningForest(const ConstraintGraph& graph);

  /// One place of the ways from some nodes to their roots.
  struct PathNode {
    int place = 0;
    int next = -1;  ///< Of the parent, in the path; -1 at a root.
  };
  /// All places on the ways to the roots, children before parents, each once.
  std::vector<PathNode> path(std::span<const int> graph_nodes) const;
};

}  // namespace rigor
