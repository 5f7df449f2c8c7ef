#pragma once

#include "rigor/study/kinds/answer.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/plan/study_plan.hpp"
#include "rigor/study/workers/row_table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

/// The grid of all lists of a plan: a cell is one value of each, the last list changing fastest.
class Grid {
 public:
  /// plan must outlive this object.
  explicit Grid(const StudyPlan& plan);

  std::uint64_t cells() const { return cells_; }
  /// Columns of the lists of more than one value, and their values in a cell.
  const std::vector<std::string>& names() const { return names_; }
  std::vector<double> values(std::uint64_t cell) const;
  /// Sets the coordinates of all lists in a point of the plan.
  void place(std::uint64_t cell, std::vector<double>& point) const;

 private:
  struct Axis {
    std::size_t coordinate;
    const Parameter* list;
  };
  std::vector<Axis> axes_;
  std::vector<std::string> names_;
  std::uint64_t cells_ = 1;
};

/// A point of the plan drawn for a run: the coordinates of lists are 0.
std::vector<double> random_point(const StudyPlan& plan, std::uint64_t run);

/// The values of an outcome in the complete runs from `first` to `last`, that one excluded.
std::vector<double> outcome_values(const RowTable& known, std::size_t outcome, std::uint64_t first,
                                   std::uint64_t last);

/// The same without holding them; known must outlive it.
Sample outcome_sample(const RowTable& known, std::size_t outcome, std::uint64_t first, std::uint64_t last);

/// Warns of runs that failed or whose audit was violated.
void add_warnings(const RowTable& known, StudyAnswer& answer);

/// A histogram of the values; they are not empty and finite.
AnswerFigure histogram(const std::string& name, const Sample& sample, const SampleSummary& summary);

}  // namespace rigor
