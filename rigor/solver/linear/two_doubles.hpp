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

/// |a| of both.
inline TwoDoubles size_of(TwoDoubles two) {
  using TwoWords = long long __attribute__((vector_size(16)));
  constexpr long long all_but_sign = 0x7fffffffffffffffLL;
  return reinterpret_cast<TwoDoubles>(reinterpret_cast<TwoWords>(two) & TwoWords{all_but_sign, all_but_sign});
}

}  // namespace rigor
