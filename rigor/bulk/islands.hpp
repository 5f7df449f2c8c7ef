#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace rigor {

/// Dynamic bodies that hang together: by contacts, joints and springs, one by one; bodies that are not
/// dynamic do not join what they touch.
class BulkIslands {
 public:
  explicit BulkIslands(const Model& model);

  /// Of a list of contacts that tells their body_A(i) and body_B(i).
  template <class Contacts>
  void build(const Contacts& contacts) {
    begin();
    for (std::size_t i = 0; i < contacts.size(); ++i) join(contacts.body_A(i), contacts.body_B(i));
    finish();
  }
  void build(const std::vector<ManifoldMemory>& contacts);
  /// The lowest body of the island; -1 for bodies that are not dynamic.
  int island_of(int body) const { return islands_[static_cast<std::size_t>(body)]; }

 private:
  void begin();
  void join(int a, int b);
  void finish();
  int root_of(int body);

  std::vector<bool> is_dynamic_;
  std::vector<std::pair<int, int>> lasting_;  ///< Pairs that joints and springs hold together.
  std::vector<int> islands_;                  ///< While they are built, a body nearer to the root.
};

}  // namespace rigor
