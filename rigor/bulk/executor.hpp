#pragma once

#include <functional>

namespace rigor {

/// Runs the rounds of a loop, on one or more threads. Loops are such that their answer does not depend on who
/// runs which round: nothing is added up across rounds, no round writes what another reads.
class Executor {
 public:
  /// threads >= 1.
  explicit Executor(int threads) : threads_(threads) {}

  int threads() const { return threads_; }
  /// body(begin, end) over ranges that make up [0, count); ranges of less than `grain` rounds are not split
  /// off.
  void for_ranges(int count, int grain, const std::function<void(int, int)>& body) const;

 private:
  int threads_;
};

}  // namespace rigor
