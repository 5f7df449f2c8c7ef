#include "rigor/bulk/joints/joint_forest.hpp"

#include "rigor/bulk/joints/joint_loops.hpp"

#include "rigor/core/index.hpp"
#include "rigor/model/force.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace rigor {

namespace {

/// Whether a law acts along the coordinate.
bool acts(const JointAxis& axis) {
  return axis.is_limited() || axis.motor || axis.stiffness > 0 || axis.damping > 0 || axis.friction > 0;
}

/// What keeps its distance has no coordinate for a spring to act on.
bool keeps_distance(const Joint& joint) {
  return joint_traits(joint.type).relation == JointRelation::distance &&
         (joint.axes.empty() || !joint.axes[0].is_limited());
}

/// Of each joint, whether its coordinates count.
std::vector<bool> coordinate_users(const Model& model) {
  std::vector<bool> users;
  for (const Joint& joint : model.joints()) {
    users.push_back(!keeps_distance(joint) && std::any_of(joint.axes.begin(), joint.axes.end(), acts));
  }
  // A gear needs the first coordinates of its wheels, even if no law acts along them.
  for (const Joint& joint : model.joints()) {
    if (joint.type != JointType::gear) continue;
    for (const int wheel : {joint.first_joint, joint.second_joint}) {
      if (!keeps_distance(model.joint(wheel))) users[at(wheel)] = true;
    }
  }
  return users;
}

/// Sets of bodies that are held together.
class BodySets {
 public:
  explicit BodySets(int count) : above_(at(count)) { std::iota(above_.begin(), above_.end(), 0); }
  int top(int body) {
    int& above = above_[at(body)];
    // Paths are halved on the way, so that later ways are short.
    while (above != above_[at(above)]) above = above_[at(above)];
    return above;
  }
  void join(int a, int b) { above_[at(top(a))] = top(b); }

 private:
  std::vector<int> above_;
};

/// The joints of the trees by body, and the others.
struct Branches {
  std::vector<std::vector<int>> joints;  ///< Of each body those to other bodies.
  std::vector<int> holds;                ///< Of each body the joint that holds it to the ground; -1.
  std::vector<int> closing;
};

/// Takes joints into trees in their order: those between two dynamic bodies that are not yet held together,
/// and the first that holds a tree to the ground.
Branches choose_branches(const Model& model) {
  const std::size_t count = at(model.body_count());
  Branches branches{std::vector<std::vector<int>>(count), std::vector<int>(count, -1), {}};
  BodySets sets(model.body_count());
  std::vector<bool> is_held(count);
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    const Joint& joint = model.joint(j);
    const bool is_gear = joint.type == JointType::gear;
    const bool moves_A = !is_gear && moves_freely(model, joint.body_A);
    const bool moves_B = !is_gear && moves_freely(model, joint.body_B);

    // Between two trees of which at most one is held to the ground.
    if (moves_A && moves_B) {
      const std::size_t a = at(sets.top(joint.body_A));
      const std::size_t b = at(sets.top(joint.body_B));
      if (a != b && !(is_held[a] && is_held[b])) {
        is_held[b] = is_held[a] || is_held[b];
        sets.join(joint.body_A, joint.body_B);
        branches.joints[at(joint.body_A)].push_back(j);
        branches.joints[at(joint.body_B)].push_back(j);
        continue;
      }
    } else if (moves_A || moves_B) {
      // To the ground, for a tree that floats.
      const int body = moves_A ? joint.body_A : joint.body_B;
      const std::size_t set = at(sets.top(body));
      if (!is_held[set]) {
        is_held[set] = true;
        branches.holds[at(body)] = j;
        continue;
      }
    }
    branches.closing.push_back(j);
  }
  return branches;
}

/// One tree: in the order of its links.
struct Tree {
  std::vector<int> bodies, joints, parents;  ///< Parents: their place in `bodies`; -1: none.
};

/// The tree of a root: breadth first from there, then reversed, so that children come before their parents.
Tree grow(const Model& model, const Branches& branches, int root) {
  Tree tree{{root}, {branches.holds[at(root)]}, {-1}};
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    for (const int j : branches.joints[at(tree.bodies[i])]) {
      if (j == tree.joints[i]) continue;
      const Joint& joint = model.joint(j);
      tree.bodies.push_back(joint.body_A == tree.bodies[i] ? joint.body_B : joint.body_A);
      tree.joints.push_back(j);
      tree.parents.push_back(static_cast<int>(i));
    }
  }
  // The reversal turns the places of parents round as well.
  std::reverse(tree.bodies.begin(), tree.bodies.end());
  std::reverse(tree.joints.begin(), tree.joints.end());
  std::reverse(tree.parents.begin(), tree.parents.end());
  for (int& parent : tree.parents) {
    if (parent >= 0) parent = static_cast<int>(tree.bodies.size()) - 1 - parent;
  }
  return tree;
}

/// The trees of all branches, in the order of their roots: the body that is held to the ground, else the
/// lowest one.
std::vector<Tree> find_trees(const Model& model, const Branches& branches) {
  BodySets sets(model.body_count());
  std::vector<int> roots(at(model.body_count()), -1);
  // The bodies of each tree are one set.
  for (std::size_t b = 0; b < branches.joints.size(); ++b) {
    for (const int j : branches.joints[b]) sets.join(model.joint(j).body_A, model.joint(j).body_B);
  }
  for (int b = 0; b < model.body_count(); ++b) {
    int& root = roots[at(sets.top(b))];
    const bool is_held = branches.holds[at(b)] >= 0;
    if (is_held || (root < 0 && !branches.joints[at(b)].empty())) root = b;
  }
  // Trees in ascending order of their roots, so that the order of work depends on the model only.
  std::vector<Tree> trees;
  for (int b = 0; b < model.body_count(); ++b) {
    const int root = roots[at(sets.top(b))];
    if (root == b) trees.push_back(grow(model, branches, root));
  }
  return trees;
}

/// Trees with equal signatures share lanes: the same parents, types of joints, sides and coordinates.
std::vector<int> signature(const Model& model, const std::vector<bool>& has_coordinates, const Tree& tree) {
  std::vector<int> signs;
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    signs.push_back(tree.parents[i]);
    if (tree.joints[i] < 0) {
      signs.push_back(-1);
      continue;
    }
    const Joint& joint = model.joint(tree.joints[i]);
    signs.push_back(static_cast<int>(joint.type));
    signs.push_back(joint.body_B == tree.bodies[i] ? 1 : 0);
    signs.push_back(has_coordinates[at(tree.joints[i])] ? 1 : 0);
  }
  return signs;
}

/// Eight empty lanes of trees that are like this one.
JointSystems begin_trees(const Model& model, const std::vector<bool>& has_coordinates, const Tree& tree) {
  JointSystems trees;
  std::array<int, 8> none;
  none.fill(-1);
  trees.bodies.assign(tree.bodies.size(), none);
  trees.moved = tree.bodies.size();
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    JointLink link;
    link.joints = none;
    link.child = static_cast<int>(i);
    link.has_joint = tree.joints[i] >= 0;
    if (link.has_joint) {
      const Joint& joint = model.joint(tree.joints[i]);
      link.type = joint.type;
      link.child_is_B = joint.body_B == tree.bodies[i];
      link.has_laws = has_coordinates[at(tree.joints[i])];
      link.parent_is_free = tree.parents[i] >= 0;
      link.parent = tree.parents[i];
      if (!link.parent_is_free) {
        // A parent that joints do not move has a slot of its own behind the others.
        link.parent = static_cast<int>(trees.bodies.size());
        trees.bodies.push_back(none);
      }
    }
    trees.links.push_back(link);
  }
  return trees;
}

void add_lane(const Model& model, const Tree& tree, std::size_t lane, JointSystems& trees) {
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    JointLink& link = trees.links[i];
    trees.bodies[i][lane] = tree.bodies[i];
    link.joints[lane] = tree.joints[i];
    if (!link.has_joint || link.parent_is_free) continue;
    const Joint& joint = model.joint(tree.joints[i]);
    trees.bodies[at(link.parent)][lane] = link.child_is_B ? joint.body_A : joint.body_B;
  }
}

/// Of each joint the system that it belongs to: the lowest joint of it.
std::vector<int> systems_of(const Model& model) {
  const int count = static_cast<int>(model.joints().size());
  BodySets sets(count + model.body_count());  // Joints, then bodies.
  for (int j = 0; j < count; ++j) {
    const Joint& joint = model.joint(j);
    for (const int body : {joint.body_A, joint.body_B}) {
      if (moves_freely(model, body)) sets.join(j, count + body);
    }
    if (joint.type != JointType::gear) continue;
    sets.join(j, joint.first_joint);
    sets.join(j, joint.second_joint);
  }

  // The joints of a set are met in ascending order.
  std::vector<int> lowest(at(count + model.body_count()), -1), systems;
  for (int j = 0; j < count; ++j) {
    int& first = lowest[at(sets.top(j))];
    if (first < 0) first = j;
    systems.push_back(first);
  }
  return systems;
}

/// The joints of each system with loops, ascending.
std::vector<std::vector<int>> find_loops(const std::vector<int>& closing, const std::vector<int>& systems) {
  std::map<int, std::vector<int>> loops;
  for (const int joint : closing) loops[systems[at(joint)]];
  for (std::size_t j = 0; j < systems.size(); ++j) {
    const auto found = loops.find(systems[j]);
    if (found != loops.end()) found->second.push_back(static_cast<int>(j));
  }
  std::vector<std::vector<int>> joints;
  joints.reserve(loops.size());
  for (auto& [first, members] : loops) joints.push_back(std::move(members));
  return joints;
}

/// Puts systems that are alike into lanes: begin() makes the first of eight, add(lane, systems) the others.
class LaneFiller {
 public:
  explicit LaneFiller(std::vector<JointSystems>& systems) : systems_(systems) {}

  template <class Begin, class Add>
  void put(const std::vector<int>& signature, const Begin& begin, const Add& add) {
    const auto [place, is_new] = places_.try_emplace(signature, 0, 8);
    auto& [block, lane] = place->second;
    if (lane == 8) {
      block = systems_.size();
      lane = 0;
      systems_.push_back(begin());
    }
    add(lane++, systems_[block]);
  }

 private:
  std::vector<JointSystems>& systems_;
  /// Where the next system of a signature goes: which eight, which lane.
  std::map<std::vector<int>, std::pair<std::size_t, std::size_t>> places_;
};

}  // namespace

std::vector<int> joint_counts(const JointSystems& systems) {
  std::vector<int> counts(systems.bodies.size(), 0);
  for (const JointLink& link : systems.links) {
    if (link.has_joint) ++counts[at(link.child)], ++counts[at(link.parent)];
  }
  return counts;
}

JointForest make_joint_forest(const Model& model) {
  // Systems with a joint that closes a loop, or with a gear, are no trees as a whole.
  const Branches branches = choose_branches(model);
  const std::vector<std::vector<int>> loops = find_loops(branches.closing, systems_of(model));
  std::vector<bool> is_in_loops(model.joints().size());
  for (const std::vector<int>& joints : loops) {
    for (const int j : joints) is_in_loops[at(j)] = true;
  }

  // Trees.
  JointForest forest;
  forest.has_coordinates = coordinate_users(model);
  LaneFiller trees(forest.systems);
  for (const Tree& tree : find_trees(model, branches)) {
    const int any_joint = *std::max_element(tree.joints.begin(), tree.joints.end());
    if (is_in_loops[at(any_joint)]) continue;
    trees.put(
        signature(model, forest.has_coordinates, tree),
        [&] { return begin_trees(model, forest.has_coordinates, tree); },
        [&](std::size_t lane, JointSystems& systems) { add_lane(model, tree, lane, systems); });
  }

  // Systems with loops or gears.
  LaneFiller others(forest.systems);
  for (const std::vector<int>& joints : loops) {
    const JointLoops system(model, forest.has_coordinates, joints);
    others.put(
        system.signature(), [&] { return system.begin(); },
        [&](std::size_t lane, JointSystems& systems) { system.add_lane(lane, systems); });
  }
  return forest;
}

}  // namespace rigor
