#pragma once

namespace rigor {

/// What the program returns to its caller; docs/errors.md says the same.
enum ExitCode : int {
  exit_done = 0,
  exit_audit_violated = 1,  ///< Finished, but something broke its tolerance.
  exit_usage = 2,
  exit_bad_input = 3,      ///< Scene, mesh or checkpoint.
  exit_stopped = 4,        ///< The simulation could not go on.
  exit_file_error = 5,     ///< A file that cannot be written, or the system's fault.
  exit_interrupted = 130,  ///< By SIGINT or SIGTERM; all files are closed.
};

}  // namespace rigor
