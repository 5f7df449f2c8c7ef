#include "rigor/study/kinds/statistics.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/study/sampling/counter_random.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
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

}  // namespace

Estimate mean_estimate(std::span<const double> values, double confidence) {
  const double n = static_cast<double>(values.size());
  if (values.empty()) return {std::nan(""), -kInfinity, kInfinity};
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  const bool is_share = std::all_of(values.begin(), values.end(), [](double v) { return v == 0 || v == 1; });
  if (is_share) return share_estimate(mean, n, confidence);
  if (values.size() < 2) return {mean, -kInfinity, kInfinity};
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double t = student_quantile(0.5 + 0.5 * confidence, n - 1);
  const double half = t * std::sqrt(squares / (n - 1) / n);
  return {mean, mean - half, mean + half};
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
