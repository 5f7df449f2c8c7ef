#pragma once

#include "apps/options.hpp"

namespace rigor {

// What options of a command must be beside each other: formats that exist, files that do not overwrite each
// other, options that go together. Throw UsageError.

void check_run(const RunOptions& run);
void check_compare(const CompareOptions& compare);
/// Sets also whether the output is a mesh.
void check_convert(ConvertOptions& convert);
void check_study(const StudyOptions& study);

}  // namespace rigor
