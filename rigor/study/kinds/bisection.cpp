#include "rigor/core/index.hpp"
#include "rigor/study/formula/formula.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/strategy.hpp"
#include "rigor/study/plan/parameter_values.hpp"
#include "rigor/study/run/run_executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// The threshold along one parameter in each cell of the grid of the others. A round has one point a cell
/// (two in the first: the ends), `repeats` times; the majority decides on which side the point lies.
class Bisection : public Strategy {
 public:
  explicit Bisection(const StudyPlan& plan)
      : plan_(plan), grid_(plan), condition_(plan.condition), values_(plan) {
    std::size_t coordinate = 0;
    for (const Parameter& parameter : plan.parameters) {
      if (parameter.name == plan.search) searched_ = coordinate, parameter_ = &parameter;
      coordinate += static_cast<std::size_t>(parameter.coordinates());
    }
    names_ = plan.columns();
    for (const std::string& name : row_columns(plan)) names_.push_back(name);
    columns_ = columns_of(condition_, names_);
  }

  /// Rounds until the bracket is narrow: half of it a round. Of a logarithmic range the widest one is at its
  /// end.
  std::uint64_t most() const override {
    const double width = parameter_->is_logarithmic
                             ? std::log(parameter_->high / parameter_->low) * parameter_->high
                             : parameter_->high - parameter_->low;
    const double rounds = std::clamp(std::ceil(std::log2(width / plan_.tolerance) + 1e-9), 0.0, 1100.0);
    return grid_.cells() * plan_.repeats * static_cast<std::uint64_t>(2 + rounds);
  }

  std::uint64_t wanted(const RowTable& known) override {
    // Not before: how many runs there may be is checked when the strategy is made.
    brackets_.resize(grid_.cells());
    while (known.prefix() >= asked_count() * plan_.repeats) {
      const std::uint64_t before = asked_count();
      for (; judged_ < before; ++judged_) judge(known, judged_);
      for (std::uint64_t cell = 0; cell < grid_.cells(); ++cell) {
        const Bracket& bracket = brackets_[cell];
        if (bracket.has_threshold() && !is_narrow(bracket)) ask(cell, 0.5 * (bracket.low + bracket.high));
      }
      if (asked_count() == before) break;
    }
    return asked_count() * plan_.repeats;
  }

  std::vector<double> point(std::uint64_t run) const override {
    const Asked asked = asked_at(run / plan_.repeats);
    std::vector<double> point = random_point(plan_, run);
    grid_.place(asked.cell, point);
    point[searched_] = asked.u;
    return point;
  }

  StudyAnswer answer(const RowTable& known) const override {
    StudyAnswer answer;
    AnswerTable table{"thresholds of " + plan_.search, grid_.names(), {}};
    for (const char* const column : {"threshold", "low", "high", "holds above"})
      table.columns.emplace_back(column);
    AnswerFigure figure{AnswerFigure::Kind::points,
                        "threshold of " + plan_.search,
                        grid_.names().empty() ? "" : grid_.names()[0],
                        plan_.search,
                        {},
                        {},
                        {},
                        {}};
    for (std::uint64_t cell = 0; cell < brackets_.size(); ++cell) {
      const Bracket& bracket = brackets_[cell];
      std::vector<double> row = grid_.values(cell);
      const bool is_there = bracket.has_threshold();
      const double low = searched_value(bracket.low), high = searched_value(bracket.high);
      const double middle = is_there ? 0.5 * (low + high) : std::nan("");
      const std::string name = grid_.cells() == 1 ? "threshold" : fmt::format("threshold[{}]", cell);
      answer.findings.push_back({name, middle, low, high});
      if (!is_there && judged_ > 1)
        answer.warnings.push_back(fmt::format("{}: the condition {} at both ends of the range", name,
                                              bracket.side_low > 0 ? "holds" : "does not hold"));
      row.insert(row.end(), {middle, low, high, bracket.side_high > 0 ? 1.0 : 0.0});
      if (!grid_.names().empty() && is_there) {
        figure.x.push_back(row[0]), figure.y.push_back(middle), figure.low.push_back(low),
            figure.high.push_back(high);
      }
      table.rows.push_back(std::move(row));
    }
    if (!figure.x.empty()) answer.figures.push_back(std::move(figure));
    answer.tables.push_back(std::move(table));
    add_warnings(known, answer);
    return answer;
  }

  std::string brief(const RowTable&) const override {
    if (brackets_.empty()) return {};
    const Bracket& bracket = brackets_[0];
    return fmt::format("{} between {:.8g} and {:.8g}", plan_.search, searched_value(bracket.low),
                       searched_value(bracket.high));
  }

 private:
  struct Asked {
    std::uint64_t cell;
    double u;  ///< Coordinate of the searched parameter.
  };
  struct Bracket {
    double low = 0, high = 1;           ///< Coordinates.
    int side_low = -1, side_high = -1;  ///< Whether the condition holds there; -1: not known.
    bool has_threshold() const { return side_low >= 0 && side_high >= 0 && side_low != side_high; }
  };

  void ask(std::uint64_t cell, double u) { asked_.push_back({cell, u}); }
  /// In the first round both ends of each cell, then those of asked_.
  std::uint64_t asked_count() const { return 2 * grid_.cells() + asked_.size(); }
  Asked asked_at(std::uint64_t index) const {
    const std::uint64_t ends = 2 * grid_.cells();
    return index < ends ? Asked{index / 2, static_cast<double>(index % 2)} : asked_[index - ends];
  }

  /// Value of the searched parameter alone, of whose coordinate it is a function.
  double searched_value(double u) const { return parameter_->value_between(u); }

  bool is_narrow(const Bracket& bracket) const {
    const double middle = 0.5 * (bracket.low + bracket.high);
    return searched_value(bracket.high) - searched_value(bracket.low) <= plan_.tolerance ||
           middle <= bracket.low || middle >= bracket.high;
  }

  /// Whether the condition holds in a run; a run that failed counts as one where it does not.
  bool holds(const RowTable& known, std::uint64_t run) const {
    if (!known.is_complete(run)) return false;
    std::vector<double> all = values_.at(point(run)), arguments;
    for (std::size_t k = 0; k < known.columns(); ++k) all.push_back(known.value(run, k));
    for (const std::size_t column : columns_) arguments.push_back(all[column]);
    return condition_.value(arguments) > 0;
  }

  void judge(const RowTable& known, std::uint64_t index) {
    const Asked asked = asked_at(index);
    std::uint64_t holding = 0;
    for (std::uint64_t k = 0; k < plan_.repeats; ++k)
      holding += holds(known, index * plan_.repeats + k) ? 1 : 0;
    const int side = 2 * holding > plan_.repeats ? 1 : 0;
    Bracket& bracket = brackets_[asked.cell];
    if (asked.u <= 0) {
      bracket.side_low = side;
    } else if (asked.u >= 1) {
      bracket.side_high = side;
    } else {
      (side == bracket.side_low ? bracket.low : bracket.high) = asked.u;
    }
  }

  const StudyPlan& plan_;
  Grid grid_;
  Formula condition_;
  ParameterValues values_;
  const Parameter* parameter_ = nullptr;
  std::size_t searched_ = 0;
  std::uint64_t judged_ = 0;
  std::vector<std::string> names_;
  std::vector<std::size_t> columns_;
  std::vector<Asked> asked_;       ///< After the first round.
  std::vector<Bracket> brackets_;  ///< By cell; none before the first round.
};

}  // namespace

std::unique_ptr<Strategy> make_bisection(const StudyPlan& plan) {
  return std::make_unique<Bisection>(plan);
}

}  // namespace rigor
