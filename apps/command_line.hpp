#pragma once

#include "apps/exit_codes.hpp"
#include "apps/options.hpp"

#include <optional>

namespace rigor {

/// A command to execute, or none: then help or the version was printed, and the exit code says how that was
/// requested.
struct ParsedCommandLine {
  std::optional<Command> command;
  ExitCode exit_code = exit_done;
};

/// Throws UsageError, with the nearest name for an unknown command or option.
ParsedCommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace rigor
