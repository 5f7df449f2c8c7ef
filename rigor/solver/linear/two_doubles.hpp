#pragma once

#include <cstring>

namespace rigor {

/// Arithmetic on two doubles at a time, as every 64-bit processor has it: rows of six are three of them.
using TwoDoubles = double __attribute__((vector_size(16)));

inline TwoDoubles two_of(const double* from) {
  TwoDoubles two;
  std::memcpy(&two, from, sizeof(two));
  return two;
}
inline void put_two(TwoDoubles two, double* to) {
  std::memcpy(to, &two, sizeof(two));
}

}  // namespace rigor
