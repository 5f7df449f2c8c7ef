#pragma once

#include "rigor/study/run/run_row.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// The rows of a study that are known, in any order of arrival. It grows block by block; of the blocks whose
/// rows are all known the latest ones stay in memory, the others go to a file without a name that ends with
/// the process, so that memory stays flat. Used by one thread at a time.
class RowTable {
 public:
  explicit RowTable(std::size_t columns) : columns_(columns) {}
  RowTable(const RowTable&) = delete;
  RowTable& operator=(const RowTable&) = delete;
  ~RowTable();

  /// Bytes of a row, without its reason.
  static double row_bytes(std::size_t columns) { return 8.0 * static_cast<double>(columns) + 5; }
  /// Bytes of blocks that stay in memory, about.
  static constexpr double kept_bytes = 4e6;
  /// Where the file may be made; before that it is the system's folder for temporary files.
  void set_folder(std::filesystem::path folder) { folder_ = std::move(folder); }
  std::filesystem::path folder() const;

  /// Enters a row; whether it was not there yet. Throws FileError.
  bool enter(const RunRow& row);
  bool has(std::uint64_t run) const;
  std::uint64_t count() const { return count_; }
  /// All runs below this number are known, and it is not.
  std::uint64_t prefix() const { return prefix_; }
  std::size_t columns() const { return columns_; }

  // Of a run that is known; they may throw FileError:
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
    std::vector<std::pair<std::uint64_t, std::string>>
        reasons;  ///< By place in the block; of runs that have one.
  };
  /// Where a block is.
  struct Slot {
    std::unique_ptr<Block> block;  ///< Null: in the file, or no row is known.
    std::uint64_t known = 0;
    std::int64_t place = -1;  ///< In the file; -1: it was never there.
  };
  const Block& block_of(std::uint64_t run) const {
    const Slot& slot = slots_[run / block_rows];
    return slot.block ? *slot.block : loaded(run / block_rows);
  }
  std::unique_ptr<Block> make_block() const;
  const Block& loaded(std::uint64_t number) const;
  void keep(std::uint64_t number) const;
  void put_away(Slot& slot) const;
  void open_file() const;

  std::size_t columns_;
  std::uint64_t count_ = 0, prefix_ = 0;
  double total_cpu_time_ = 0;
  std::filesystem::path folder_;
  // Reading brings blocks back into memory.
  mutable std::vector<Slot> slots_;
  mutable std::vector<std::uint64_t> kept_;  ///< Whole blocks in memory, in a ring.
  mutable std::size_t oldest_ = 0;
  mutable std::int64_t file_end_ = 0;
  mutable int file_ = -1;
};

}  // namespace rigor
