#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace rigor {

/// Dynamic bodies that hang together: by contacts, joints and springs, one by one; bodies that are not
/// dynamic do not join what they touch. Kept from one list of contacts to the next: contacts that are new
/// join islands, and only islands that have lost one are found again. The answer depends on the last list
/// alone.
class BulkIslands {
 public:
  explicit BulkIslands(const Model& model);

  /// Of a list of contacts that tells their body_A(i) and body_B(i).
  template <class Contacts>
  void build(const Contacts& contacts) {
    next_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) add(contacts.body_A(i), contacts.body_B(i));
    update();
  }
  void build(const std::vector<ManifoldMemory>& contacts);
  /// The lowest body of the island; -1 for bodies that are not dynamic.
  int island_of(int body) const { return islands_[at(body)]; }

 private:
  using Pair = std::pair<int, int>;
  void add(int a, int b);
  void update();
  void dissolve_those_that_lost();
  void join(const Pair& pair);
  int root_of(int body);

  std::vector<bool> is_dynamic_;
  std::vector<Pair> lasting_;       ///< Pairs that joints and springs hold together.
  std::vector<Pair> pairs_, next_;  ///< Of the contacts before, and of those now; ascending, each once.
  std::vector<Pair> lost_;          ///< Of the pairs before.
  std::vector<char> has_lost_;      ///< Islands before, by their lowest bodies.
  std::vector<int> islands_;        ///< While they are built, a body nearer to the root.
};

}  // namespace rigor
