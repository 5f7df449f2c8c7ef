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

  /// After a body of the Model has changed: its group and mask.
  void set_body(const Model& model, int body);
  /// After the excluded pairs of the Model have changed.
  void set_excluded(const Model& model);

  bool may_collide(int a, int b) const {
    const Entry &A = entries_[at(a)], &B = entries_[at(b)];
    if ((A.group & B.mask) == 0 || (B.group & A.mask) == 0) return false;
    return A.excluded_begin == A.excluded_end || B.excluded_begin == B.excluded_end || !is_excluded(a, b);
  }

 private:
  struct Entry {
    std::uint32_t group = 0, mask = 0;
    int excluded_begin = 0, excluded_end = 0;  ///< Section of the list of excluded bodies, ascending.
  };
  bool is_excluded(int a, int b) const;

  std::vector<Entry> entries_;
  std::vector<int> excluded_;
};

}  // namespace rigor
