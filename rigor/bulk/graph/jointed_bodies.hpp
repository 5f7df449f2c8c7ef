#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// Which dynamic bodies joints hold, and which of them they connect.
class JointedBodies {
 public:
  /// After joints or bodies of the Model have changed.
  void find(const Model& model);

  /// Whether a joint holds the body, which is dynamic, to another or to the world.
  bool contains(int body) const { return is_jointed_[at(body)] != 0; }
  const std::vector<char>& all() const { return is_jointed_; }
  /// The lowest of the dynamic bodies that joints connect with each body; its own number without joints.
  const std::vector<int>& groups() const { return groups_; }

 private:
  std::vector<char> is_jointed_;
  std::vector<int> groups_;
};

}  // namespace rigor
