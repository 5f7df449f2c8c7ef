#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/changed_bodies.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace rigor {

/// Islands: dynamic bodies that are connected by contacts, joints and springs. Bodies that are not dynamic do
/// not connect what they touch. Islands are kept from one list of contacts to the next: new contacts join
/// islands, and only islands that have lost a contact are found again. The result depends on the last list
/// alone.
class BulkIslands {
 public:
  explicit BulkIslands(const Model& model);

  /// After the Model has changed. The last list of contacts is forgotten.
  void change(const Model& model, const ChangedBodies& changed);

  /// Finds the islands of a list of contacts that has body_A(i) and body_B(i).
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
  void tie(const Model& model);
  void forget();
  void add(int a, int b);
  void update();
  void dissolve_those_that_lost();
  void join(const Pair& pair);

  std::vector<bool> is_dynamic_;
  std::vector<Pair> lasting_;       ///< Pairs of dynamic bodies that joints and springs hold together.
  std::vector<Pair> pairs_, next_;  ///< Pairs of the previous and the current contacts; ascending, each once.
  std::vector<Pair> lost_;          ///< Previous pairs that are no longer there.
  std::vector<char> has_lost_;      ///< Whether a previous island lost a pair, by its lowest body.
  std::vector<int> islands_;  ///< The lowest body of each body's island; while islands are built, a body
                              ///< nearer to the root.
};

}  // namespace rigor
