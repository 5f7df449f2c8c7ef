#include "rigor/core/index.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/kinds/strategy.hpp"
#include "rigor/study/run/run_executor.hpp"
#include "rigor/study/sampling/counter_random.hpp"
#include "rigor/study/sampling/even_points.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// A parameter with coordinates, which vary together.
struct Factor {
  std::string name;
  std::size_t first, count;
};
std::vector<Factor> factors_of(const StudyPlan& plan) {
  std::vector<Factor> factors;
  std::size_t first = 0;
  for (const Parameter& parameter : plan.parameters) {
    const std::size_t count = static_cast<std::size_t>(parameter.coordinates());
    if (count > 0 && !parameter.is_list()) factors.push_back({parameter.name, first, count});
    first += count;
  }
  return factors;
}

/// Sobol's indices: the share of the variance of an outcome that a parameter explains alone (first order) and
/// with all others (total). Of two independent samples A and B the runs are f(A), f(B) and, for each
/// parameter, f(A with that parameter from B).
///
/// Source: Saltelli et al., Variance based sensitivity analysis of model output, Comput. Phys. Commun. 181,
/// 2010: first order by its equation (b) of table 2, total by Jansen's (f).
class Sensitivity : public Strategy {
 public:
  explicit Sensitivity(const StudyPlan& plan)
      : plan_(plan), factors_(factors_of(plan)), columns_(row_columns(plan)) {}

  std::uint64_t most() const override { return plan_.runs * stride(); }
  std::uint64_t wanted(const RowTable&) override { return most(); }

  std::vector<double> point(std::uint64_t run) const override {
    const std::uint64_t base = run / stride(), which = run % stride();
    const int dimensions = plan_.coordinate_count();
    // One Sobol sequence of twice the dimensions gives A and B.
    const std::vector<double> both = shifted_sobol_point(base, 2 * dimensions, plan_.seed, 0);
    std::vector<double> a(both.begin(), both.begin() + dimensions), b(both.begin() + dimensions, both.end());
    std::vector<double>& point = which == 1 ? b : a;
    if (which >= 2) {
      const Factor& factor = factors_[which - 2];
      for (std::size_t k = factor.first; k < factor.first + factor.count; ++k) a[k] = b[k];
    }
    Grid(plan_).place(0, point);
    return point;
  }

  StudyAnswer answer(const RowTable& known) const override {
    StudyAnswer answer;
    for (std::size_t outcome = 0; outcome < columns_.size(); ++outcome) add_outcome(known, outcome, answer);
    add_warnings(known, answer);
    return answer;
  }

 private:
  std::uint64_t stride() const { return factors_.size() + 2; }

  /// Base points all of whose runs are complete.
  std::vector<std::uint64_t> complete_bases(const RowTable& known, std::size_t outcome) const {
    std::vector<std::uint64_t> bases;
    for (std::uint64_t base = 0; base < known.prefix() / stride(); ++base) {
      if (outcome_values(known, outcome, base * stride(), (base + 1) * stride()).size() == stride())
        bases.push_back(base);
    }
    return bases;
  }

  /// First-order indices, then total ones, of these base points.
  std::vector<double> indices(const RowTable& known, std::size_t outcome,
                              const std::vector<std::uint64_t>& bases,
                              std::span<const std::uint64_t> chosen) const {
    const double n = static_cast<double>(chosen.size());
    double sum = 0, squares = 0;
    for (const std::uint64_t i : chosen) {
      const double f_A = known.value(bases[i] * stride(), outcome),
                   f_B = known.value(bases[i] * stride() + 1, outcome);
      sum += f_A + f_B;
    }
    const double mean = sum / (2 * n);
    for (const std::uint64_t i : chosen) {
      for (std::uint64_t k = 0; k < 2; ++k)
        squares += std::pow(known.value(bases[i] * stride() + k, outcome) - mean, 2);
    }
    const double variance = squares / (2 * n);
    std::vector<double> first, total;
    for (std::size_t factor = 0; factor < factors_.size(); ++factor) {
      double alone = 0, with_others = 0;
      for (const std::uint64_t i : chosen) {
        const std::uint64_t run = bases[i] * stride();
        const double f_A = known.value(run, outcome), f_B = known.value(run + 1, outcome),
                     f_AB = known.value(run + 2 + factor, outcome);
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

  void add_outcome(const RowTable& known, std::size_t outcome, StudyAnswer& answer) const {
    const std::vector<std::uint64_t> bases = complete_bases(known, outcome);
    if (bases.size() < 2) return;
    const std::vector<Estimate> estimates = bootstrap(
        bases.size(),
        [&](std::span<const std::uint64_t> chosen) { return indices(known, outcome, bases, chosen); },
        {plan_.seed, plan_.confidence, 200});
    AnswerTable table{
        "Sobol indices of " + columns_[outcome], {"first", "low", "high", "total", "low", "high"}, {}};
    AnswerFigure figure{
        AnswerFigure::Kind::bars, "total Sobol indices of " + columns_[outcome], "", "", {}, {}, {}, {}};
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      const Estimate &first = estimates[k], &total = estimates[factors_.size() + k];
      answer.findings.push_back(
          {columns_[outcome] + ".first." + factors_[k].name, first.value, first.low, first.high});
      answer.findings.push_back(
          {columns_[outcome] + ".total." + factors_[k].name, total.value, total.low, total.high});
      table.labels.push_back(factors_[k].name);
      table.rows.push_back({first.value, first.low, first.high, total.value, total.low, total.high});
      figure.labels.push_back(factors_[k].name);
      figure.y.push_back(total.value), figure.low.push_back(total.low), figure.high.push_back(total.high);
    }
    answer.tables.push_back(std::move(table));
    answer.figures.push_back(std::move(figure));
  }

  const StudyPlan& plan_;
  std::vector<Factor> factors_;
  std::vector<std::string> columns_;
};

/// Morris's ways: each begins at a random point of a grid of p levels and changes one parameter after the
/// other by p / (2 (p - 1)); the mean size of a parameter's effects says how much it matters, their deviation
/// how much that depends on the others.
///
/// Source: Morris, Factorial sampling plans for preliminary computational experiments, Technometrics 33,
/// 1991; mean of the sizes: Campolongo, Cariboni and Saltelli, Environ. Model. Softw. 22, 2007.
class Morris : public Strategy {
 public:
  explicit Morris(const StudyPlan& plan)
      : plan_(plan), factors_(factors_of(plan)), columns_(row_columns(plan)) {}

  std::uint64_t most() const override { return plan_.runs * stride(); }
  std::uint64_t wanted(const RowTable&) override { return most(); }

  std::vector<double> point(std::uint64_t run) const override {
    const std::uint64_t way = run / stride(), moved = run % stride();
    std::vector<double> point(at(plan_.coordinate_count()), 0.0);
    for (std::size_t k = 0; k < point.size(); ++k) point[k] = start(way, k);
    // The order of the parameters is drawn by sorting random numbers.
    const std::vector<std::size_t> order = order_of(way);
    for (std::uint64_t step = 0; step < moved; ++step) {
      const Factor& factor = factors_[order[step]];
      for (std::size_t k = factor.first; k < factor.first + factor.count; ++k)
        point[k] += point[k] < 0.5 ? delta() : -delta();
    }
    for (double& u : point) u = std::clamp(u, 0.0, 1.0);
    Grid(plan_).place(0, point);
    return point;
  }

  StudyAnswer answer(const RowTable& known) const override {
    StudyAnswer answer;
    for (std::size_t outcome = 0; outcome < columns_.size(); ++outcome) add_outcome(known, outcome, answer);
    add_warnings(known, answer);
    return answer;
  }

 private:
  std::uint64_t stride() const { return factors_.size() + 1; }
  double delta() const { return plan_.levels / (2.0 * (plan_.levels - 1)); }

  double start(std::uint64_t way, std::size_t coordinate) const {
    const double u =
        random_uniform(plan_.seed, RandomStream::trajectories, {way, static_cast<std::uint32_t>(coordinate)});
    return std::floor(u * plan_.levels) / (plan_.levels - 1);
  }

  std::vector<std::size_t> order_of(std::uint64_t way) const {
    std::vector<std::pair<std::uint64_t, std::size_t>> keys;
    for (std::size_t k = 0; k < factors_.size(); ++k)
      keys.emplace_back(random_bits(plan_.seed, RandomStream::trajectories,
                                    {way, 0x80000000u + static_cast<std::uint32_t>(k)}),
                        k);
    std::sort(keys.begin(), keys.end());
    std::vector<std::size_t> order;
    for (const auto& [key, k] : keys) order.push_back(k);
    return order;
  }

  void add_outcome(const RowTable& known, std::size_t outcome, StudyAnswer& answer) const {
    std::vector<std::vector<double>> effects(factors_.size());
    for (std::uint64_t way = 0; way < known.prefix() / stride(); ++way) {
      if (outcome_values(known, outcome, way * stride(), (way + 1) * stride()).size() != stride()) continue;
      const std::vector<std::size_t> order = order_of(way);
      for (std::size_t step = 0; step < order.size(); ++step) {
        const std::uint64_t run = way * stride() + step;
        const std::size_t first = factors_[order[step]].first;
        const double moved = point(run + 1)[first] - point(run)[first];
        effects[order[step]].push_back((known.value(run + 1, outcome) - known.value(run, outcome)) / moved);
      }
    }
    if (effects.empty() || effects[0].size() < 2) return;
    AnswerTable table{
        "Morris's effects on " + columns_[outcome], {"size", "low", "high", "mean", "deviation"}, {}};
    AnswerFigure figure{
        AnswerFigure::Kind::bars, "size of effects on " + columns_[outcome], "", "", {}, {}, {}, {}};
    for (std::size_t k = 0; k < factors_.size(); ++k)
      add_factor(k, effects[k], columns_[outcome], answer, table, figure);
    answer.tables.push_back(std::move(table));
    answer.figures.push_back(std::move(figure));
  }

  void add_factor(std::size_t k, const std::vector<double>& effects, const std::string& outcome,
                  StudyAnswer& answer, AnswerTable& table, AnswerFigure& figure) const {
    std::vector<double> sizes;
    for (const double effect : effects) sizes.push_back(std::abs(effect));
    const Estimate size = mean_estimate(sizes, plan_.confidence),
                   mean = mean_estimate(effects, plan_.confidence);
    double squares = 0;
    for (const double effect : effects) squares += (effect - mean.value) * (effect - mean.value);
    const double deviation = std::sqrt(squares / static_cast<double>(effects.size() - 1));
    answer.findings.push_back({outcome + ".size." + factors_[k].name, size.value, size.low, size.high});
    answer.findings.push_back({outcome + ".deviation." + factors_[k].name, deviation, {}, {}});
    table.labels.push_back(factors_[k].name);
    table.rows.push_back({size.value, size.low, size.high, mean.value, deviation});
    figure.labels.push_back(factors_[k].name);
    figure.y.push_back(size.value), figure.low.push_back(size.low), figure.high.push_back(size.high);
  }

  const StudyPlan& plan_;
  std::vector<Factor> factors_;
  std::vector<std::string> columns_;
};

}  // namespace

std::unique_ptr<Strategy> make_sensitivity(const StudyPlan& plan) {
  return std::make_unique<Sensitivity>(plan);
}

std::unique_ptr<Strategy> make_morris(const StudyPlan& plan) {
  return std::make_unique<Morris>(plan);
}

}  // namespace rigor
