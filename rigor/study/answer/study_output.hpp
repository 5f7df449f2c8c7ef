#pragma once

#include "rigor/study/study.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// The runs as a table: run, status, parameters, outcomes, reason; numbers with 17 significant digits.
std::string study_csv(const Study& study);
/// The answer and what was asked; the runs are in the other files.
std::string study_json(const Study& study);
/// The runs as an HDF5 file: data sets parameters (runs by columns), outcomes, status, seed of the run, with
/// the names of the columns. Throws FileError.
void write_study_hdf5(const Study& study, const std::filesystem::path& path);
/// A page with the answer, its tables and figures, that needs nothing else.
std::string study_page(const Study& study);

/// Empty if a study can be written to a file of this suffix, or why not.
std::string check_study_output(const std::filesystem::path& path);
/// Writes the study in the format of the suffix: .csv .json .h5 .html .svg .png. Throws FileError.
void write_study(const Study& study, const std::filesystem::path& path);

}  // namespace rigor
