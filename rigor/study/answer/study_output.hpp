#pragma once

#include "rigor/study/study.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// The runs as a table: run, status, parameters, outcomes, reason; numbers with 17 significant digits.
std::string study_csv(const Study& study);
/// The answer and what was asked; the runs are in the other files.
std::string study_json(const Study& study);
/// The runs as an HDF5 file: data sets parameters (runs by columns), outcomes, status, the study's seed and,
/// where it varies, that of each run, with the names of the columns, and the reasons of runs that failed.
/// Throws FileError.
void write_study_hdf5(const Study& study, const std::filesystem::path& path);
/// Empty if a study can be written to a file of this suffix, or why not.
std::string check_study_output(const std::filesystem::path& path);
/// Bytes that such a file of so many runs may take; 0 where that does not grow with them.
double study_file_bytes(const StudyPlan& plan, std::uint64_t runs, const std::filesystem::path& path);
/// Writes the study in the format of the suffix: .csv .json .h5 .html .svg .png. Throws FileError.
void write_study(const Study& study, const std::filesystem::path& path);

}  // namespace rigor
