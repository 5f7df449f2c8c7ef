#include "rigor/study/run/divergence.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

void Divergence::note(const State& state) {
  first_.push_back(state.x);
}

void Divergence::compare(const State& state) {
  if (next_ >= first_.size()) return;
  const std::vector<double>& x = first_[next_++];
  double largest = 0;
  for (std::size_t i = 0; i + 2 < x.size(); i += 3)
    largest = std::max(largest,
                       std::hypot(state.x[i] - x[i], state.x[i + 1] - x[i + 1], state.x[i + 2] - x[i + 2]));
  last_ = largest;
  if (largest > bound_) horizon_ = std::min(horizon_, state.t);
  // Beyond the bound the distance is that of strangers, whose growth ends at the size of the scene.
  if (largest > 0 && !(horizon_ <= state.t)) {
    times_.push_back(state.t);
    logarithms_.push_back(std::log(largest));
  }
}

double Divergence::exponent() const {
  const double n = static_cast<double>(times_.size());
  if (n < 3) return std::numeric_limits<double>::quiet_NaN();
  double mean_t = 0, mean_log = 0, tt = 0, tl = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) mean_t += times_[i] / n, mean_log += logarithms_[i] / n;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    tt += (times_[i] - mean_t) * (times_[i] - mean_t);
    tl += (times_[i] - mean_t) * (logarithms_[i] - mean_log);
  }
  return tl / tt;
}

}  // namespace rigor
