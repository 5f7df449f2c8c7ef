#pragma once

#include "rigor/bulk/graph/graph_colouring.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// A colouring (colour_graph) that is found anew only when the edges have changed: in what rests they stay
/// for many steps.
class KeptColouring {
 public:
  /// At most so many edges follow.
  void begin(std::size_t most);
  /// The next edge, with the number that it has in blocks; numbers ascend.
  void add(int number, const ConstraintEdge& edge, int kind) {
    const std::uint8_t kind_byte = static_cast<std::uint8_t>(kind);
    is_same_ = is_same_ && size_ < last_size_ && edges_[size_] == edge && kinds_[size_] == kind_byte;
    edges_[size_] = edge;
    kinds_[size_] = kind_byte;
    if (!numbers_.empty() || number != static_cast<int>(size_)) set_number(number);
    ++size_;
  }
  /// Of the edges that were added. body_count: bodies are less than it.
  void finish(int body_count);

  std::size_t size() const { return size_; }
  /// After finish().
  const GraphColouring& now() const { return colouring_; }
  /// How often edges were coloured.
  long run_count() const { return run_count_; }

 private:
  void set_number(int number);

  GraphColouring colouring_;
  std::vector<ConstraintEdge> edges_;
  std::vector<std::uint8_t> kinds_;
  std::vector<std::int32_t> numbers_;  ///< Of the edges; empty if edge i has the number i.
  std::size_t size_ = 0, last_size_ = 0;
  int body_count_ = -1;
  bool is_same_ = false;  ///< So far as the edges before.
  long run_count_ = 0;
};

}  // namespace rigor
