#pragma once

#include "rigor/model/state.hpp"

#include <limits>
#include <vector>

namespace rigor {

/// Follows how far two motions that began as neighbours are apart.
class Divergence {
 public:
  /// bound: the largest distance of motions that agree [m].
  explicit Divergence(double bound) : bound_(bound) {}

  /// Notes the positions of the bodies at an output of the first motion.
  void note(const State& state);
  /// Compares the next output of the second motion with the same one of the first.
  void compare(const State& state);

  /// Rate at which the distance grows as exp(λ t) [1/s]: the slope of the least-squares line through ln d
  /// while d is below the bound; NaN with fewer than three points.
  double exponent() const;
  /// The first output at which the distance exceeds the bound [s]; infinite if none does.
  double horizon() const { return horizon_; }
  double last_distance() const { return last_; }  ///< [m].

 private:
  double bound_;
  std::vector<std::vector<double>> first_;
  std::size_t next_ = 0;
  std::vector<double> times_, logarithms_;
  double horizon_ = std::numeric_limits<double>::infinity(), last_ = 0;
};

}  // namespace rigor
