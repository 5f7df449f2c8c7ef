#pragma once

#include "rigor/study/run/run_row.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rigor {

/// The rows of a study that are known, in any order of arrival: 8 bytes a number and 5 a run, and a reason
/// only where a run did not end well. It grows block by block, so that nothing is copied or held twice.
class RowTable {
 public:
  explicit RowTable(std::size_t columns) : columns_(columns) {}
  /// Bytes of a row in it.
  static double row_bytes(std::size_t columns) { return 8.0 * static_cast<double>(columns) + 5; }

  /// Enters a row; whether it was not there yet.
  bool enter(const RunRow& row);
  bool has(std::uint64_t run) const {
    const std::uint64_t block = run / block_rows;
    return block < blocks_.size() && blocks_[block] && blocks_[block]->statuses[run % block_rows] >= 0;
  }
  std::uint64_t count() const { return count_; }
  /// All runs below this number are known, and it is not.
  std::uint64_t prefix() const { return prefix_; }
  std::size_t columns() const { return columns_; }

  // Of a run that is known:
  RunStatus status(std::uint64_t run) const {
    return static_cast<RunStatus>(block_of(run).statuses[run % block_rows]);
  }
  bool is_complete(std::uint64_t run) const;
  double value(std::uint64_t run, std::size_t column) const {
    return block_of(run).values[run % block_rows * columns_ + column];
  }
  double cpu_time(std::uint64_t run) const { return block_of(run).cpu_times[run % block_rows]; }
  std::string reason(std::uint64_t run) const;
  /// Processor time of all known runs [s].
  double total_cpu_time() const { return total_cpu_time_; }

 private:
  static constexpr std::uint64_t block_rows = 1024;
  struct Block {
    std::array<signed char, block_rows> statuses;  ///< -1: not known.
    std::array<float, block_rows> cpu_times;
    std::vector<double> values;  ///< A row after the other.
  };
  const Block& block_of(std::uint64_t run) const { return *blocks_[run / block_rows]; }

  std::size_t columns_;
  std::uint64_t count_ = 0, prefix_ = 0;
  double total_cpu_time_ = 0;
  std::vector<std::unique_ptr<Block>> blocks_;  ///< Null where no row is known.
  std::map<std::uint64_t, std::string> reasons_;
};

}  // namespace rigor
