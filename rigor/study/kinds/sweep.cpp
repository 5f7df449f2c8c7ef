#include "rigor/core/rounding.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/kinds/strategy.hpp"
#include "rigor/study/run/run_executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Every cell of the grid, `repeats` times; chaos without a grid: `runs` draws. What is drawn is drawn for
/// each run.
class Sweep : public Strategy {
 public:
  explicit Sweep(const StudyPlan& plan)
      : plan_(plan),
        grid_(plan),
        columns_(row_columns(plan)),
        repeats_(plan.kind == StudyKind::chaos && grid_.cells() == 1 ? std::max(plan.repeats, plan.runs)
                                                                     : plan.repeats) {}

  std::uint64_t most() const override { return grid_.cells() * repeats_; }
  std::uint64_t wanted(const RowTable&) override { return most(); }

  std::vector<double> point(std::uint64_t run) const override {
    std::vector<double> point = random_point(plan_, run);
    grid_.place(run / repeats_, point);
    return point;
  }

  StudyAnswer answer(const RowTable& known) const override {
    StudyAnswer answer;
    AnswerTable table{"means over the grid", grid_.names(), {}};
    for (const std::string& column : columns_) {
      table.columns.push_back(column);
      if (repeats_ > 1) table.columns.push_back(column + " low"), table.columns.push_back(column + " high");
    }
    const std::uint64_t cells = known.prefix() / repeats_;
    for (std::uint64_t cell = 0; cell < cells; ++cell) table.rows.push_back(row_of(known, cell));
    add_findings(table, answer);
    add_figures(table, answer);
    answer.tables.push_back(std::move(table));
    add_warnings(known, answer);
    return answer;
  }

 private:
  std::vector<double> row_of(const RowTable& known, std::uint64_t cell) const {
    std::vector<double> row = grid_.values(cell);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Estimate mean =
          mean_estimate(outcome_sample(known, k, cell * repeats_, (cell + 1) * repeats_), plan_.confidence);
      row.push_back(mean.value);
      if (repeats_ > 1) row.push_back(mean.low), row.push_back(mean.high);
    }
    return row;
  }

  /// The least and the greatest mean of an outcome over the grid; NaN if one is unknown, so that a run that
  /// failed does not pass for a small number.
  void add_extremes(const AnswerTable& table, std::size_t outcome, std::size_t column,
                    StudyAnswer& answer) const {
    double least = kInfinity, greatest = -kInfinity;
    for (const std::vector<double>& row : table.rows) {
      const double mean = row[column];
      if (std::isnan(mean) || mean < least) least = mean;
      if (std::isnan(mean) || mean > greatest) greatest = mean;
      if (std::isnan(mean)) break;
    }
    answer.findings.push_back({"least " + columns_[outcome], least});
    answer.findings.push_back({"greatest " + columns_[outcome], greatest});
  }

  /// Each outcome's mean in a grid of one cell; else its value in each, by number, and its extremes.
  void add_findings(const AnswerTable& table, StudyAnswer& answer) const {
    const std::size_t step = repeats_ > 1 ? 3 : 1;
    for (std::size_t cell = 0; cell < table.rows.size(); ++cell) {
      const std::vector<double>& row = table.rows[cell];
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const std::size_t column = grid_.names().size() + k * step;
        Finding finding{grid_.cells() == 1 ? columns_[k] : fmt::format("{}[{}]", columns_[k], cell),
                        row[column]};
        if (repeats_ > 1) finding.low = row[column + 1], finding.high = row[column + 2];
        answer.findings.push_back(std::move(finding));
      }
    }
    if (table.rows.size() < 2) return;
    for (std::size_t k = 0; k < columns_.size(); ++k)
      add_extremes(table, k, grid_.names().size() + k * step, answer);
  }

  /// Each outcome over the first axis.
  void add_figures(const AnswerTable& table, StudyAnswer& answer) const {
    if (grid_.names().empty()) return;
    const std::size_t step = repeats_ > 1 ? 3 : 1;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      AnswerFigure figure{AnswerFigure::Kind::points,
                          columns_[k] + " over " + grid_.names()[0],
                          grid_.names()[0],
                          columns_[k],
                          {},
                          {},
                          {},
                          {}};
      const std::size_t column = grid_.names().size() + k * step;
      for (const std::vector<double>& row : table.rows) {
        figure.x.push_back(row[0]);
        figure.y.push_back(row[column]);
        if (repeats_ > 1) figure.low.push_back(row[column + 1]), figure.high.push_back(row[column + 2]);
      }
      answer.figures.push_back(std::move(figure));
    }
  }

  const StudyPlan& plan_;
  Grid grid_;
  std::vector<std::string> columns_;
  std::uint64_t repeats_;
};

}  // namespace

std::unique_ptr<Strategy> make_sweep(const StudyPlan& plan) {
  return std::make_unique<Sweep>(plan);
}

}  // namespace rigor
