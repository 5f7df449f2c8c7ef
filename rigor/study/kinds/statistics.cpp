#include "rigor/study/kinds/statistics.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/study/sampling/counter_random.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace rigor {

namespace {

/// Share of ones among n values.
Estimate share_estimate(double share, double n, double confidence) {
  const double z = boost::math::quantile(boost::math::normal(), 0.5 + 0.5 * confidence);
  const double z2 = z * z / n, middle = (share + 0.5 * z2) / (1 + z2);
  const double half = z / (1 + z2) * std::sqrt(share * (1 - share) / n + 0.25 * z2 / n);
  return {share, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

double sum_of_squares(const Sample& sample, double mean) {
  double squares = 0;
  sample([&](double value) { squares += (value - mean) * (value - mean); });
  return squares;
}

/// The bits of a number as one that has the same order.
std::uint64_t ordered_bits(double value) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value), sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}
double value_of_ordered_bits(std::uint64_t bits) {
  const std::uint64_t sign = std::uint64_t{1} << 63;
  return std::bit_cast<double>((bits & sign) != 0 ? bits & ~sign : ~bits);
}

/// The value before which `rank` others come: its bits from the first to the last, a digit of 16 of them at a
/// time, by how many values share the digits that are known and have each next one.
double order_statistic(const Sample& sample, std::uint64_t rank) {
  constexpr int digit_bits = 16;
  std::vector<std::uint64_t> counts(std::size_t{1} << digit_bits);
  std::uint64_t known = 0;
  for (int shift = 64 - digit_bits; shift >= 0; shift -= digit_bits) {
    std::fill(counts.begin(), counts.end(), 0);
    sample([&](double value) {
      const std::uint64_t digits = ordered_bits(value) >> shift;
      if (digits >> digit_bits == known) ++counts[digits % counts.size()];
    });
    std::uint64_t digit = 0;
    for (; rank >= counts[digit]; ++digit) rank -= counts[digit];
    known = known << digit_bits | digit;
  }
  return value_of_ordered_bits(known);
}

}  // namespace

Sample sample_of(std::span<const double> values) {
  return [values](const std::function<void(double)>& visit) {
    for (const double value : values) visit(value);
  };
}

Estimate mean_estimate(std::span<const double> values, double confidence) {
  return mean_estimate(sample_of(values), confidence);
}

Estimate mean_estimate(const Sample& sample, double confidence) {
  double n = 0, sum = 0;
  bool is_share = true;
  sample([&](double value) {
    n += 1;
    sum += value;
    is_share = is_share && (value == 0 || value == 1);
  });
  if (n == 0) return {std::nan(""), -kInfinity, kInfinity};
  const double mean = sum / n;
  if (is_share) return share_estimate(mean, n, confidence);
  if (n < 2) return {mean, -kInfinity, kInfinity};
  const double t = student_quantile(0.5 + 0.5 * confidence, n - 1);
  const double half = t * std::sqrt(sum_of_squares(sample, mean) / (n - 1) / n);
  return {mean, mean - half, mean + half};
}

SampleSummary sample_summary(const Sample& sample) {
  SampleSummary summary{.smallest = kInfinity, .largest = -kInfinity};
  double sum = 0;
  sample([&](double value) {
    ++summary.count;
    sum += value;
    summary.smallest = std::fmin(summary.smallest, value);
    summary.largest = std::fmax(summary.largest, value);
    summary.is_finite = summary.is_finite && std::isfinite(value);
  });
  if (summary.count == 0) return summary;
  const double n = static_cast<double>(summary.count);
  summary.deviation = std::sqrt(sum_of_squares(sample, sum / n) / std::max(1.0, n - 1));
  const double below = order_statistic(sample, (summary.count - 1) / 2);
  const double above = summary.count % 2 == 1 ? below : order_statistic(sample, summary.count / 2);
  const std::array<double, 2> middle = {below, above};
  summary.median = quantile(middle, 0.5);
  return summary;
}

double student_quantile(double share, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), share);
}

double quantile(std::span<const double> sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place), above = std::min(below + 1, sorted.size() - 1);
  // Infinite ones have no difference.
  if (sorted[below] == sorted[above]) return sorted[below];
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::vector<Estimate> bootstrap(
    std::uint64_t count, const std::function<std::vector<double>(std::span<const std::uint64_t>)>& statistic,
    const BootstrapSettings& settings) {
  std::vector<std::uint64_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::uint64_t{0});
  const std::vector<double> values = statistic(indices);
  std::vector<std::vector<double>> resampled(values.size());
  for (int resample = 0; resample < settings.resamples; ++resample) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const double u =
          random_uniform(settings.seed, RandomStream::bootstrap, {i, static_cast<std::uint32_t>(resample)});
      indices[i] = std::min(count - 1, static_cast<std::uint64_t>(u * static_cast<double>(count)));
    }
    const std::vector<double> again = statistic(indices);
    for (std::size_t k = 0; k < again.size(); ++k) resampled[k].push_back(again[k]);
  }
  std::vector<Estimate> estimates;
  const double tail = 0.5 * (1 - settings.confidence);
  for (std::vector<double>& sample : resampled) std::sort(sample.begin(), sample.end());
  for (std::size_t k = 0; k < values.size(); ++k)
    estimates.push_back({values[k], quantile(resampled[k], tail), quantile(resampled[k], 1 - tail)});
  return estimates;
}

}  // namespace rigor
