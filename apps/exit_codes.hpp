#pragma once

namespace rigor {

/// The exit codes of the program, as documented in docs/errors.md.
enum ExitCode : int {
  exit_done = 0,
  exit_audit_violated = 1,  ///< Finished, but a tolerance of the audit was violated.
  exit_usage = 2,
  exit_bad_input = 3,      ///< Scene, mesh or checkpoint.
  exit_stopped = 4,        ///< The simulation could not continue.
  exit_file_error = 5,     ///< A file that cannot be written, or another error of the system.
  exit_interrupted = 130,  ///< By SIGINT or SIGTERM; all files are closed.
};

}  // namespace rigor
