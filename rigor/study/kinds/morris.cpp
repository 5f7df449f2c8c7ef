#include "rigor/core/index.hpp"
#include "rigor/study/kinds/factor_strategy.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/sampling/counter_random.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// Morris's ways: each begins at a random point of a grid of p levels and changes one parameter after the
/// other by p / (2 (p - 1)); the mean size of a parameter's effects says how much it matters, their deviation
/// how much that depends on the others.
///
/// Source: Morris, Factorial sampling plans for preliminary computational experiments, Technometrics 33,
/// 1991; mean of the sizes: Campolongo, Cariboni and Saltelli, Environ. Model. Softw. 22, 2007.
class Morris : public FactorStrategy {
 public:
  explicit Morris(const StudyPlan& plan) : FactorStrategy(plan, 1) {}

  std::vector<double> point(std::uint64_t run) const override {
    const std::uint64_t trajectory = run / stride(), moved = run % stride();
    std::vector<double> point(at(plan().coordinate_count()), 0.0);
    for (std::size_t k = 0; k < point.size(); ++k) point[k] = start(trajectory, k);
    // The order of the parameters is drawn by sorting random numbers.
    const std::vector<std::size_t> order = order_of(trajectory);
    for (std::uint64_t step = 0; step < moved; ++step) {
      const Factor& factor = factors()[order[step]];
      for (std::size_t k = factor.first; k < factor.first + factor.count; ++k)
        point[k] += point[k] < 0.5 ? delta() : -delta();
    }
    for (double& u : point) u = std::clamp(u, 0.0, 1.0);
    Grid(plan()).place(0, point);
    return point;
  }

 private:
  double delta() const { return plan().levels / (2.0 * (plan().levels - 1)); }

  double start(std::uint64_t trajectory, std::size_t coordinate) const {
    const double u = random_uniform(plan().seed, RandomStream::trajectories,
                                    {trajectory, static_cast<std::uint32_t>(coordinate)});
    return std::floor(u * plan().levels) / (plan().levels - 1);
  }

  std::vector<std::size_t> order_of(std::uint64_t trajectory) const {
    std::vector<std::pair<std::uint64_t, std::size_t>> keys;
    for (std::size_t k = 0; k < factors().size(); ++k)
      keys.emplace_back(random_bits(plan().seed, RandomStream::trajectories,
                                    {trajectory, 0x80000000u + static_cast<std::uint32_t>(k)}),
                        k);
    std::sort(keys.begin(), keys.end());
    std::vector<std::size_t> order;
    order.reserve(keys.size());
    for (const auto& [key, k] : keys) order.push_back(k);
    return order;
  }

  void add_outcome(const RowTable& known, std::size_t outcome, StudyAnswer& answer) const override {
    std::vector<std::vector<double>> effects(factors().size());
    for (const std::uint64_t trajectory : complete_groups(known, outcome)) {
      const std::vector<std::size_t> order = order_of(trajectory);
      for (std::size_t step = 0; step < order.size(); ++step) {
        const std::uint64_t run = trajectory * stride() + step;
        const std::size_t first = factors()[order[step]].first;
        const double moved = point(run + 1)[first] - point(run)[first];
        effects[order[step]].push_back((known.value(run + 1, outcome) - known.value(run, outcome)) / moved);
      }
    }
    if (effects.empty() || effects[0].size() < 2) return;
    AnswerTable table{
        "Morris's effects on " + column(outcome), {"size", "low", "high", "mean", "deviation"}, {}};
    AnswerFigure figure{
        AnswerFigure::Kind::bars, "size of effects on " + column(outcome), "", "", {}, {}, {}, {}};
    for (std::size_t k = 0; k < factors().size(); ++k)
      add_factor(k, effects[k], column(outcome), answer, table, figure);
    answer.tables.push_back(std::move(table));
    answer.figures.push_back(std::move(figure));
  }

  void add_factor(std::size_t k, const std::vector<double>& effects, const std::string& outcome,
                  StudyAnswer& answer, AnswerTable& table, AnswerFigure& figure) const {
    std::vector<double> sizes;
    sizes.reserve(effects.size());
    for (const double effect : effects) sizes.push_back(std::abs(effect));
    const Estimate size = mean_estimate(sizes, plan().confidence),
                   mean = mean_estimate(effects, plan().confidence);
    double squares = 0;
    for (const double effect : effects) squares += (effect - mean.value) * (effect - mean.value);
    const double deviation = std::sqrt(squares / static_cast<double>(effects.size() - 1));
    answer.findings.push_back({outcome + ".size." + factors()[k].name, size.value, size.low, size.high});
    answer.findings.push_back({outcome + ".deviation." + factors()[k].name, deviation, {}, {}});
    table.labels.push_back(factors()[k].name);
    table.rows.push_back({size.value, size.low, size.high, mean.value, deviation});
    figure.labels.push_back(factors()[k].name);
    figure.y.push_back(size.value), figure.low.push_back(size.low), figure.high.push_back(size.high);
  }
};

}  // namespace

std::unique_ptr<Strategy> make_morris(const StudyPlan& plan) {
  return std::make_unique<Morris>(plan);
}

}  // namespace rigor
