#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

#include <cstdint>
#include <vector>

namespace rigor {

/// Model::may_collide for pairs of bodies with shapes of which one is dynamic, fast enough to be asked of
/// each pair in each step.
class PairFilter {
 public:
  explicit PairFilter(const Model& model);

  bool may_collide(int a, int b) const {
    const Entry &A = entries_[at(a)], &B = entries_[at(b)];
    if ((A.group & B.mask) == 0 || (B.group & A.mask) == 0) return false;
    return A.excluded_begin == A.excluded_end || B.excluded_begin == B.excluded_end || !is_excluded(a, b);
  }

 private:
  struct Entry {
    std::uint32_t group, mask;
    int excluded_begin, excluded_end;  ///< Section of the list of excluded bodies, ascending.
  };
  bool is_excluded(int a, int b) const;

  std::vector<Entry> entries_;
  std::vector<int> excluded_;
};

}  // namespace rigor
