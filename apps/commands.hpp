#pragma once

#include "apps/exit_codes.hpp"
#include "apps/options.hpp"

namespace rigor {

// The commands. Results go to stdout, everything else to stderr. They throw InputError, FileError and
// UsageError.

ExitCode execute(const RunOptions& options);
ExitCode execute(const ViewOptions& options);
ExitCode execute(const CompareOptions& options);
ExitCode execute(const CheckOptions& options);
ExitCode execute(const MassOptions& options);
ExitCode execute(const DistanceOptions& options);
ExitCode execute(const MethodsOptions& options);
ExitCode execute(const RenderOptions& options);
ExitCode execute(const PlotOptions& options);
ExitCode execute(const ImpactOptions& options);
ExitCode execute(const ConvertOptions& options);
ExitCode execute(const StudyOptions& options);

}  // namespace rigor
