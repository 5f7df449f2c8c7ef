#include "rigor/solver/linear/joint_ties.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <set>

namespace rigor {

using Eigen::Index;

namespace {

/// The rows of each link that count.
std::vector<std::vector<int>> counting_rows(const ConstrainedMass& joints) {
  std::vector<std::vector<int>> result(joints.graph().links.size());
  const ConstrainedMass::RowChoice& left_out = joints.choice();
  for (int link = 0; link < static_cast<int>(result.size()); ++link)
    for (int row = 0; row < joints.graph().links[at(link)].rows; ++row)
      if (!std::binary_search(left_out.begin(), left_out.end(), joints.first_row(link) + row))
        result[at(link)].push_back(row);
  return result;
}

}  // namespace

JointTies joint_ties(const ContactRows& rows) {
  JointTies result;
  if (!rows.joints) return result;
  const ConstrainedMass& joints = *rows.joints;
  const ConstraintGraph& graph = joints.graph();
  const std::vector<std::vector<int>> counting = counting_rows(joints);
  const auto node_of = [&rows](int joint_node) { return rows.joint_nodes[at(joint_node)]; };

  // Links of trees.
  for (const SpanningForest::Node& node : joints.forest().nodes) {
    if (node.link < 0 || counting[at(node.link)].empty()) continue;
    JointTies::Tie tie;
    const std::vector<int>& nodes = graph.links[at(node.link)].nodes;
    tie.rows = static_cast<int>(counting[at(node.link)].size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      tie.nodes.push_back(node_of(nodes[k]));
      Mat6& wrenches = tie.wrenches.emplace_back(Mat6::Zero());
      Index column = 0;
      for (const int row : counting[at(node.link)])
        wrenches.col(column++) = joints.block(node.link, k).row(row).transpose();
    }
    result.ties.push_back(std::move(tie));
  }

  // Rows of the others.
  for (const int link : joints.forest().loop_links) {
    const std::vector<int>& nodes = graph.links[at(link)].nodes;
    for (const int row : counting[at(link)]) {
      JointTies::LoopRow& loop_row = result.loop_rows.emplace_back();
      for (std::size_t k = 0; k < nodes.size(); ++k)
        loop_row.emplace_back(node_of(nodes[k]), joints.block(link, k).row(row).transpose());
    }
  }
  return result;
}

std::vector<int> places_of_tied_nodes(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs,
                                      const std::vector<JointTies::Tie>& ties) {
  // Neighbours, and ties that are left.
  std::vector<std::set<int>> neighbours(nodes);
  for (const auto& [a, b] : pairs) {
    neighbours[at(a)].insert(b);
    neighbours[at(b)].insert(a);
  }
  std::vector<std::vector<std::size_t>> ties_of(nodes);
  for (std::size_t k = 0; k < ties.size(); ++k)
    for (const int node : ties[k].nodes) ties_of[at(node)].push_back(k);
  std::vector<int> open(nodes);
  for (std::size_t k = 0; k < nodes; ++k) open[k] = static_cast<int>(ties_of[k].size());

  // Those that may be next, by their number of neighbours.
  std::set<std::pair<std::size_t, int>> next;
  const auto entry = [&](int node) { return std::pair(neighbours[at(node)].size(), node); };
  for (int node = 0; node < static_cast<int>(nodes); ++node)
    if (open[at(node)] <= 1) next.insert(entry(node));
  std::vector<int> places(nodes, -1);
  std::vector<bool> is_cut(ties.size(), false);
  for (int place = 0; place < static_cast<int>(nodes); ++place) {
    RIGOR_ASSERT(!next.empty());
    const int node = next.begin()->second;
    next.erase(next.begin());
    places[at(node)] = place;

    // What it couples, and the tie that it takes with it.
    const std::set<int> around = std::move(neighbours[at(node)]);
    for (const int other : around) {
      next.erase(entry(other));
      neighbours[at(other)].erase(node);
      for (const int third : around)
        if (third != other) neighbours[at(other)].insert(third);
    }
    for (const std::size_t tie : ties_of[at(node)]) {
      if (is_cut[tie]) continue;
      is_cut[tie] = true;
      for (const int end : ties[tie].nodes) --open[at(end)];
    }
    for (const int other : around)
      if (open[at(other)] <= 1) next.insert(entry(other));
  }
  return places;
}

}  // namespace rigor
