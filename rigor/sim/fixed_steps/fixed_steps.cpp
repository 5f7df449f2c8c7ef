#include "rigor/sim/fixed_steps/fixed_steps.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

FixedSteps::FixedSteps(double t, double t_end, double target_step) : begin_(t), end_(t_end) {
  RIGOR_ASSERT(t_end > t && target_step > 0);
  count_ = std::max(1L, static_cast<long>(std::ceil((t_end - t) / target_step - rounding)));
}

double FixedSteps::end(long k) const {
  if (k + 1 == count_) return end_;
  return begin_ + (end_ - begin_) * (static_cast<double>(k + 1) / static_cast<double>(count_));
}

}  // namespace rigor
