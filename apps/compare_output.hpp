#pragma once

#include "apps/compare_run.hpp"

#include <string>

namespace rigor {

/// The comparison as JSON (docs/compare.md lists the keys), each run with its complete audit if
/// `with_audits`. Numbers have 17 significant digits; unknown quantities are null.
std::string compare_json(const Comparison& comparison, bool with_audits);

/// The same table as CSV: a header row with units, then one row per run; unknown quantities are empty.
std::string compare_csv(const Comparison& comparison);

/// Empty if a comparison can be written to a file of this name, otherwise the reason why not.
std::string check_compare_output(const std::string& path);
/// The data that the runs have to keep for a file of this name.
CompareOutputs outputs_of(const std::string& path);
/// Writes the file in the format of its suffix: .json, .csv, .html (the page), .svg or .png (the plot of the
/// total energies). Throws FileError.
void write_comparison(const Comparison& comparison, const std::string& path);

}  // namespace rigor
