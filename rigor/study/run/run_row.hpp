#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

/// How a run of a study ended.
enum class RunStatus : std::uint32_t {
  done,         ///< It came to its end, and its audit passed.
  violated,     ///< It came to its end, but its audit violated a tolerance.
  stopped,      ///< The simulation could not continue.
  refused,      ///< There is no such scene: a value is outside its limits, bodies overlap.
  out_of_time,  ///< It took more processor time than the study allows.
};
inline constexpr std::array all_run_statuses = {RunStatus::done, RunStatus::violated, RunStatus::stopped,
                                                RunStatus::refused, RunStatus::out_of_time};
/// "done", "violated", "stopped", "refused", "out of time".
const char* run_status_name(RunStatus status);

/// What a run was given.
struct RunTask {
  std::uint64_t run = 0;
  std::vector<double> point;  ///< Coordinates of its parameters (ParameterValues).
};

/// What a run gave.
struct RunRow {
  std::uint64_t run = 0;
  RunStatus status = RunStatus::done;
  double cpu_time = 0;           ///< [s]; not the same if the run is repeated.
  std::vector<double> outcomes;  ///< In the order of the plan; NaN if not known.
  std::string reason;            ///< Of a status other than done.

  /// Whether its outcomes are those of a whole run.
  bool is_complete() const { return status == RunStatus::done || status == RunStatus::violated; }
};

}  // namespace rigor
