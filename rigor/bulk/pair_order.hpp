#pragma once

#include "rigor/bulk/narrow_phase.hpp"

#include <vector>

namespace rigor {

/// Puts pairs in the order (body_A, body_B, shape_A, shape_B), in time in proportion to their number and that
/// of the bodies. The pairs of two bodies are added one after the other, nearly in order.
class PairOrder {
 public:
  void clear(int body_count);
  void add(const std::vector<ShapePair>& pairs);
  /// All that were added (the buffer is cleared first).
  void write(std::vector<ShapePair>& pairs);

 private:
  std::vector<ShapePair> added_, by_second_;
  std::vector<int> begin_A_, begin_B_;  ///< How many pairs have an earlier body A, or B.
};

}  // namespace rigor
