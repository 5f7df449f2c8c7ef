#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rigor {

/// An estimate with its confidence interval.
struct Estimate {
  double value = 0, low = 0, high = 0;

  double half_width() const { return 0.5 * (high - low); }
};

/// Values that can be gone through again and again in one order, without being held.
using Sample = std::function<void(const std::function<void(double)>& visit)>;

/// Values in memory, which must outlive it.
Sample sample_of(std::span<const double> values);

/// Mean of independent values with Student's interval; of values that are all 0 or 1 a share with Wilson's
/// interval. With fewer than two values the interval is infinite.
///
/// Source: Wilson, Probable inference, the law of succession, and statistical inference, JASA 22, 1927.
Estimate mean_estimate(const Sample& sample, double confidence);
/// The same of values in memory.
Estimate mean_estimate(std::span<const double> values, double confidence);

/// What else is told of a sample; none of it is NaN.
struct SampleSummary {
  std::uint64_t count = 0;
  double smallest = 0, median = 0, largest = 0, deviation = 0;
  bool is_finite = true;  ///< All values are.
};
/// Goes through the sample eight times at most: the order statistics of the median are found by the leading
/// bits of the values, 16 at a time, in memory that does not depend on their number.
SampleSummary sample_summary(const Sample& sample);

/// The number below which one of Student's distribution lies with this probability.
double student_quantile(double share, double degrees_of_freedom);

/// Value of a sample below which the share lies: linear between the order statistics. In order, not empty.
double quantile(std::span<const double> sorted, double share);

/// Interval of a statistic of `count` items by the percentiles of its values over resampled items: the
/// function is given the indices of a resample. Deterministic by the seed.
///
/// Source: Efron, Bootstrap methods: another look at the jackknife, Ann. Statist. 7, 1979.
struct BootstrapSettings {
  std::uint64_t seed;
  double confidence;
  int resamples = 500;
};
/// Intervals of several statistics at once.
std::vector<Estimate> bootstrap(
    std::uint64_t count, const std::function<std::vector<double>(std::span<const std::uint64_t>)>& statistic,
    const BootstrapSettings& settings);

}  // namespace rigor
