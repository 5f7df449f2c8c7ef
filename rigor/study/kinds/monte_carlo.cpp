#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/kinds/strategy.hpp"
#include "rigor/study/run/run_executor.hpp"
#include "rigor/study/sampling/even_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Even points come in this many independent replicates: their means say how well the mean is known, which
/// points that are not independent cannot.
constexpr std::uint64_t replicates = 16;

class MonteCarlo : public Strategy {
 public:
  explicit MonteCarlo(const StudyPlan& plan) : plan_(plan), columns_(row_columns(plan)), most_(plan.runs) {
    if (plan.sampling != Sampling::random) most_ = (most_ + replicates - 1) / replicates * replicates;
  }

  std::uint64_t most() const override { return most_; }

  std::uint64_t wanted(const RowTable& known) override {
    if (!plan_.half_width) return most_;
    // The rule is asked at fixed numbers of runs, so that its answer is the same for any pool.
    while (checked_ < most_ && known.prefix() >= checked_ && !is_met_) {
      is_met_ =
          checked_ > 0 && estimate(known, plan_.main_outcome(), checked_).half_width() <= *plan_.half_width;
      if (!is_met_) checked_ = std::min(most_, next_check());
    }
    return checked_;
  }

  std::vector<double> point(std::uint64_t run) const override {
    if (plan_.sampling == Sampling::random) return random_point(plan_, run);
    const int dimensions = plan_.coordinate_count();
    const std::uint64_t replicate = run % replicates, index = run / replicates;
    std::vector<double> point =
        plan_.sampling == Sampling::sobol
            ? shifted_sobol_point(index, dimensions, plan_.seed, replicate)
            : hypercube_point(index, dimensions, {most_ / replicates, plan_.seed, replicate});
    Grid(plan_).place(0, point);
    return point;
  }

  StudyAnswer answer(const RowTable& known) const override {
    StudyAnswer answer;
    AnswerTable table{
        "distributions", {"mean", "low", "high", "deviation", "smallest", "median", "largest", "runs"}, {}};
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Sample sample = outcome_sample(known, k, 0, used(known));
      const Estimate mean = estimate(known, k, used(known));
      answer.findings.push_back({columns_[k], mean.value, mean.low, mean.high});
      const SampleSummary summary = sample_summary(sample);
      if (summary.count == 0) continue;
      table.labels.push_back(columns_[k]);
      table.rows.push_back({mean.value, mean.low, mean.high, summary.deviation, summary.smallest,
                            summary.median, summary.largest, static_cast<double>(summary.count)});
      if (summary.is_finite) answer.figures.push_back(histogram(columns_[k], sample, summary));
    }
    answer.tables.push_back(std::move(table));
    if (plan_.half_width && !is_met_ && known.prefix() >= most_)
      answer.warnings.push_back(
          fmt::format("the interval of {} is wider than half_width after the {} runs allowed",
                      columns_[plan_.main_outcome()], most_));
    add_warnings(known, answer);
    return answer;
  }

  std::string brief(const RowTable& known) const override {
    const Estimate mean = estimate(known, plan_.main_outcome(), used(known));
    return fmt::format("{} = {:.5g} ± {:.2g}", columns_[plan_.main_outcome()], mean.value, mean.half_width());
  }

 private:
  std::uint64_t used(const RowTable& known) const {
    return std::min(known.prefix(), plan_.half_width ? checked_ : most_);
  }

  /// A fifth more than at the last check.
  std::uint64_t next_check() const {
    constexpr std::uint64_t first = 64;
    return checked_ == 0 ? first : (checked_ + checked_ / 5 + replicates) / replicates * replicates;
  }

  Estimate estimate(const RowTable& known, std::size_t outcome, std::uint64_t runs) const {
    if (plan_.sampling == Sampling::random)
      return mean_estimate(outcome_sample(known, outcome, 0, runs), plan_.confidence);
    std::vector<double> sums(replicates, 0), counts(replicates, 0), means;
    for (std::uint64_t run = 0; run < runs; ++run) {
      if (!known.is_complete(run) || std::isnan(known.value(run, outcome))) continue;
      sums[run % replicates] += known.value(run, outcome);
      counts[run % replicates] += 1;
    }
    for (std::uint64_t r = 0; r < replicates; ++r) {
      if (counts[r] > 0) means.push_back(sums[r] / counts[r]);
    }
    // Means of replicates are 0 or 1 by chance only, so they are no shares of their own.
    if (std::all_of(means.begin(), means.end(), [](double m) { return m == 0 || m == 1; }))
      return mean_estimate(outcome_sample(known, outcome, 0, runs), plan_.confidence);
    return mean_estimate(means, plan_.confidence);
  }

  const StudyPlan& plan_;
  std::vector<std::string> columns_;
  std::uint64_t most_, checked_ = 0;
  bool is_met_ = false;
};

}  // namespace

std::unique_ptr<Strategy> make_monte_carlo(const StudyPlan& plan) {
  return std::make_unique<MonteCarlo>(plan);
}

}  // namespace rigor
