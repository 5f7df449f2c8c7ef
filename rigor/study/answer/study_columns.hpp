#pragma once

#include "rigor/study/study.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

/// Numbers of runs of a study, column by column, for figures and pages.
struct StudyColumns {
  std::vector<std::uint64_t> runs;
  std::vector<std::string> names;
  std::vector<bool> are_parameters;  ///< One a column.
  std::vector<std::vector<double>> values;

  /// Removes the columns that are the same in all runs: they have nothing to show.
  void drop_constant();
};

/// The columns of a study: parameters, then outcomes. Of more than `most` runs as many, evenly.
StudyColumns study_columns(const Study& study, std::uint64_t most);

/// The column that a study is about: its main outcome; of chaos without one the horizon.
std::string main_column(const StudyPlan& plan);
/// Where a name is among these; their number if it is not.
std::size_t place_of_column(const std::vector<std::string>& names, const std::string& name);

/// Whether a run that ended so is whole: its outcomes count.
bool is_complete(RunStatus status);

}  // namespace rigor
