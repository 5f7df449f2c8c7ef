#pragma once

#include "rigor/core/index.hpp"

#include <algorithm>
#include <vector>

namespace rigor {

// Disjoint sets of numbers, as a list in which each number has one that is nearer to the root of its set, the
// lowest of it: union by the lower number, so that sets do not depend on the order of unions, with path
// halving (Tarjan and van Leeuwen, Worst-Case Analysis of Set Union Algorithms, J. ACM 31(2), 1984).

/// The root of the set of a number.
inline int find_root(std::vector<int>& sets, int number) {
  while (sets[at(number)] != number) number = sets[at(number)] = sets[at(sets[at(number)])];
  return number;
}

/// Makes one set of those of two numbers.
inline void join_sets(std::vector<int>& sets, int first, int second) {
  const int a = find_root(sets, first), b = find_root(sets, second);
  sets[at(std::max(a, b))] = std::min(a, b);
}

}  // namespace rigor
