#include "rigor/study/kinds/factor_strategy.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/sampling/even_points.hpp"

#include <cmath>
#include <span>
#include <utility>

namespace rigor {

namespace {

/// Sobol's indices: the share of the variance of an outcome that a parameter explains alone (first order) and
/// with all others (total). Of two independent samples A and B the runs are f(A), f(B) and, for each
/// parameter, f(A with that parameter from B).
///
/// Source: Saltelli et al., Variance based sensitivity analysis of model output, Comput. Phys. Commun. 181,
/// 2010: first order by its equation (b) of table 2, total by Jansen's (f).
class Sensitivity : public FactorStrategy {
 public:
  explicit Sensitivity(const StudyPlan& plan) : FactorStrategy(plan, 2) {}

  std::vector<double> point(std::uint64_t run) const override {
    const std::uint64_t base = run / stride(), which = run % stride();
    const int dimensions = plan().coordinate_count();
    // One Sobol sequence of twice the dimensions gives A and B.
    const std::vector<double> both = shifted_sobol_point(base, 2 * dimensions, plan().seed, 0);
    std::vector<double> a(both.begin(), both.begin() + dimensions), b(both.begin() + dimensions, both.end());
    std::vector<double>& point = which == 1 ? b : a;
    if (which >= 2) {
      const Factor& factor = factors()[which - 2];
      for (std::size_t k = factor.first; k < factor.first + factor.count; ++k) a[k] = b[k];
    }
    Grid(plan()).place(0, point);
    return point;
  }

 private:
  /// First-order indices, then total ones, of these base points; values: of the runs of all of them.
  std::vector<double> indices(const std::vector<double>& values,
                              std::span<const std::uint64_t> chosen) const {
    const double n = static_cast<double>(chosen.size());
    double sum = 0, squares = 0;
    for (const std::uint64_t i : chosen) {
      sum += values[i * stride()] + values[i * stride() + 1];
    }
    const double mean = sum / (2 * n);
    for (const std::uint64_t i : chosen) {
      for (std::uint64_t k = 0; k < 2; ++k) squares += std::pow(values[i * stride() + k] - mean, 2);
    }
    const double variance = squares / (2 * n);
    std::vector<double> first, total;
    for (std::size_t factor = 0; factor < factors().size(); ++factor) {
      double alone = 0, with_others = 0;
      for (const std::uint64_t i : chosen) {
        const double* const of_base = &values[i * stride()];
        const double f_A = of_base[0], f_B = of_base[1], f_AB = of_base[2 + factor];
        // Values about the mean have the same indices and less rounding and scatter.
        alone += (f_B - mean) * (f_AB - f_A);
        with_others += (f_A - f_AB) * (f_A - f_AB);
      }
      first.push_back(variance > 0 ? alone / n / variance : 0);
      total.push_back(variance > 0 ? with_others / (2 * n) / variance : 0);
    }
    first.insert(first.end(), total.begin(), total.end());
    return first;
  }

  void add_outcome(const RowTable& known, std::size_t outcome, StudyAnswer& answer) const override {
    const std::vector<std::uint64_t> bases = complete_groups(known, outcome);
    if (bases.size() < 2) return;
    // Resampling goes to and fro among them: they are held.
    std::vector<double> values;
    for (const std::uint64_t base : bases) {
      for (std::uint64_t k = 0; k < stride(); ++k)
        values.push_back(known.value(base * stride() + k, outcome));
    }
    const std::vector<Estimate> estimates = bootstrap(
        bases.size(), [&](std::span<const std::uint64_t> chosen) { return indices(values, chosen); },
        {plan().seed, plan().confidence, 200});
    AnswerTable table{
        "Sobol indices of " + column(outcome), {"first", "low", "high", "total", "low", "high"}, {}};
    AnswerFigure figure{
        AnswerFigure::Kind::bars, "total Sobol indices of " + column(outcome), "", "", {}, {}, {}, {}};
    for (std::size_t k = 0; k < factors().size(); ++k) {
      const Estimate &first = estimates[k], &total = estimates[factors().size() + k];
      answer.findings.push_back(
          {column(outcome) + ".first." + factors()[k].name, first.value, first.low, first.high});
      answer.findings.push_back(
          {column(outcome) + ".total." + factors()[k].name, total.value, total.low, total.high});
      table.labels.push_back(factors()[k].name);
      table.rows.push_back({first.value, first.low, first.high, total.value, total.low, total.high});
      figure.labels.push_back(factors()[k].name);
      figure.y.push_back(total.value), figure.low.push_back(total.low), figure.high.push_back(total.high);
    }
    answer.tables.push_back(std::move(table));
    answer.figures.push_back(std::move(figure));
  }
};

}  // namespace

std::unique_ptr<Strategy> make_sensitivity(const StudyPlan& plan) {
  return std::make_unique<Sensitivity>(plan);
}

}  // namespace rigor
