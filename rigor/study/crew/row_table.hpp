#pragma once

#include "rigor/study/run/run_row.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rigor {

/// The rows of a study that are known, in any order of arrival: 8 bytes a number, and a reason only where a
/// run did not end well.
class RowTable {
 public:
  explicit RowTable(std::size_t columns) : columns_(columns) {}

  /// Enters a row; whether it was not there yet.
  bool enter(const RunRow& row);
  bool has(std::uint64_t run) const { return run < statuses_.size() && statuses_[run] >= 0; }
  std::uint64_t count() const { return count_; }
  /// All runs below this number are known, and it is not.
  std::uint64_t prefix() const { return prefix_; }
  std::size_t columns() const { return columns_; }

  // Of a run that is known:
  RunStatus status(std::uint64_t run) const { return static_cast<RunStatus>(statuses_[run]); }
  bool is_complete(std::uint64_t run) const;
  double value(std::uint64_t run, std::size_t column) const { return values_[run * columns_ + column]; }
  double cpu_time(std::uint64_t run) const { return cpu_times_[run]; }
  std::string reason(std::uint64_t run) const;
  /// Processor time of all known runs [s].
  double total_cpu_time() const { return total_cpu_time_; }

 private:
  std::size_t columns_;
  std::uint64_t count_ = 0, prefix_ = 0;
  double total_cpu_time_ = 0;
  std::vector<signed char> statuses_;  ///< -1: not known.
  std::vector<double> values_;
  std::vector<float> cpu_times_;
  std::map<std::uint64_t, std::string> reasons_;
};

}  // namespace rigor
