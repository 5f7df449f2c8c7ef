#pragma once

#include "rigor/math/types.hpp"

#include <random>

namespace rigor::test {

/// Numbers in [-1, 1) and vectors of them, the same for the same seed.
class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double number() { return uniform_(generator_); }
  double uniform(double lo, double hi) { return lo + 0.5 * (number() + 1) * (hi - lo); }
  Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

}  // namespace rigor::test
