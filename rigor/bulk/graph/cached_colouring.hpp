#pragma once

#include "rigor/bulk/graph/graph_colouring.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// A colouring (colour_graph) that is only found again when the edges have changed: while bodies rest they
/// stay the same for many steps.
class CachedColouring {
 public:
  /// Begins a list of at most this many edges.
  void begin(std::size_t most);
  /// Adds the next edge, with the number that it has in blocks; numbers ascend.
  void add(int number, const ConstraintEdge& edge, int kind) {
    const std::uint8_t kind_byte = static_cast<std::uint8_t>(kind);
    is_same_ = is_same_ && size_ < last_size_ && edges_[size_] == edge && kinds_[size_] == kind_byte;
    edges_[size_] = edge;
    kinds_[size_] = kind_byte;
    if (!numbers_.empty() || number != static_cast<int>(size_)) set_number(number);
    ++size_;
  }
  /// Colours the edges that were added. Bodies are less than body_count.
  void finish(int body_count);

  std::size_t size() const { return size_; }
  /// The colouring, after finish().
  const GraphColouring& now() const { return colouring_; }
  /// How often edges were coloured.
  long run_count() const { return run_count_; }

 private:
  void set_number(int number);

  GraphColouring colouring_;
  std::vector<ConstraintEdge> edges_;
  std::vector<std::uint8_t> kinds_;
  std::vector<std::int32_t> numbers_;  ///< Numbers of the edges; empty if edge i has the number i.
  std::size_t size_ = 0, last_size_ = 0;
  int body_count_ = -1;
  bool is_same_ = false;  ///< Whether the edges are those of the last list so far.
  long run_count_ = 0;
};

}  // namespace rigor
