#pragma once

#include "rigor/study/answer/study_columns.hpp"
#include "rigor/view/plot/drawing.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// Whether a file has the runs of a study, as `rigor study -o runs.h5` writes them.
bool is_study_file(const std::filesystem::path& path);

/// The runs of such a file whose outcomes count. Throws InputError.
StudyColumns read_study_columns(const std::filesystem::path& path);

/// What may be drawn of them: "NAME" a histogram, "Y:X" one over the other, "matrix", "parallel"; without
/// keys all runs in parallel coordinates, and a histogram of each outcome. One below the other. Throws
/// InputError for a key that names no column.
Drawing study_plot(const StudyColumns& columns, const std::vector<std::string>& keys);

}  // namespace rigor
