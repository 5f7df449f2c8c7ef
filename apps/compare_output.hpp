#pragma once

#include "apps/compare_run.hpp"

#include <string>

namespace rigor {

/// The comparison as JSON (docs/compare.md lists the keys), each run with its whole audit if `with_audits`.
/// Numbers have 17 significant digits; what is not known is null.
std::string compare_json(const Comparison& comparison, bool with_audits);

/// The same table as CSV: a header row with units, then a row a run; what is not known is empty.
std::string compare_csv(const Comparison& comparison);

/// Empty if a comparison can be written to a file of this name, or why not.
std::string check_compare_output(const std::string& path);
/// What the runs have to keep for a file of this name.
CompareWishes wishes_of(const std::string& path);
/// Writes the file that its suffix asks for: .json, .csv, .html (the page), .svg or .png (the plot of the
/// total energies). Throws FileError.
void write_comparison(const Comparison& comparison, const std::string& path);

}  // namespace rigor
