#include "rigor/study/workers/row_table.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/io/files/file_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string_view>

#include <stdlib.h>
#include <unistd.h>

namespace rigor {

namespace {

// Blocks as bytes in the table's own file, which no other program reads.
void put_bytes(const void* from, std::size_t count, std::string& bytes) {
  bytes.append(static_cast<const char*>(from), count);
}
void take_bytes(void* to, std::size_t count, std::string_view& bytes) {
  RIGOR_ASSERT(bytes.size() >= count);
  std::memcpy(to, bytes.data(), count);
  bytes.remove_prefix(count);
}

}  // namespace

RowTable::~RowTable() {
  if (file_ >= 0) ::close(file_);
}

std::unique_ptr<RowTable::Block> RowTable::make_block() const {
  auto block = std::make_unique<Block>();
  block->statuses.fill(-1);
  block->cpu_times.fill(0);
  block->values.assign(block_rows * columns_, std::numeric_limits<double>::quiet_NaN());
  return block;
}

bool RowTable::has(std::uint64_t run) const {
  const std::uint64_t number = run / block_rows;
  if (number >= slots_.size()) return false;
  const Slot& slot = slots_[number];
  return slot.known == block_rows || (slot.known > 0 && slot.block->statuses[run % block_rows] >= 0);
}

bool RowTable::enter(const RunRow& row) {
  if (has(row.run)) return false;
  const std::uint64_t number = row.run / block_rows, place = row.run % block_rows;
  if (number >= slots_.size()) slots_.resize(number + 1);
  Slot& slot = slots_[number];
  if (!slot.block) slot.block = make_block();
  Block& block = *slot.block;
  block.statuses[place] = static_cast<signed char>(row.status);
  block.cpu_times[place] = static_cast<float>(row.cpu_time);
  for (std::size_t k = 0; k < std::min(columns_, row.outcomes.size()); ++k)
    block.values[place * columns_ + k] = row.outcomes[k];
  if (!row.reason.empty()) block.reasons.emplace_back(place, row.reason);
  total_cpu_time_ += row.cpu_time;
  ++count_;
  if (++slot.known == block_rows) keep(number);
  while (has(prefix_)) ++prefix_;
  return true;
}

/// Keeps a whole block in memory, in the place of the one that came first of those that are.
void RowTable::keep(std::uint64_t number) const {
  const double block_bytes = row_bytes(columns_) * static_cast<double>(block_rows);
  const std::size_t most = static_cast<std::size_t>(std::max(2.0, kept_bytes / block_bytes));
  if (kept_.size() < most) return kept_.push_back(number);
  put_away(slots_[kept_[oldest_]]);
  kept_[oldest_] = number;
  oldest_ = (oldest_ + 1) % kept_.size();
}

std::filesystem::path RowTable::folder() const {
  std::error_code error;
  const std::filesystem::path folder =
      folder_.empty() ? std::filesystem::temp_directory_path(error) : folder_;
  return folder.empty() ? "." : folder;
}

void RowTable::open_file() const {
  std::string path = (folder() / "rigor_rows_XXXXXX").string();
  file_ = ::mkstemp(path.data());
  if (file_ < 0) throw write_error(path, errno);
  ::unlink(path.c_str());
}

void RowTable::put_away(Slot& slot) const {
  const Block& block = *slot.block;
  if (slot.place < 0) {
    std::string bytes;
    put_bytes(block.statuses.data(), sizeof(block.statuses), bytes);
    put_bytes(block.cpu_times.data(), sizeof(block.cpu_times), bytes);
    put_bytes(block.values.data(), sizeof(double) * block.values.size(), bytes);
    for (const auto& [place, reason] : block.reasons) {
      const std::uint64_t head[2] = {place, reason.size()};
      put_bytes(head, sizeof(head), bytes);
      put_bytes(reason.data(), reason.size(), bytes);
    }
    const std::uint64_t size = bytes.size();
    bytes.insert(0, reinterpret_cast<const char*>(&size), sizeof(size));
    if (file_ < 0) open_file();
    const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), file_end_);
    if (written != static_cast<ssize_t>(bytes.size()))
      throw write_error("the file of rows", written < 0 ? errno : ENOSPC);
    slot.place = file_end_;
    file_end_ += static_cast<std::int64_t>(bytes.size());
  }
  slot.block.reset();
}

const RowTable::Block& RowTable::loaded(std::uint64_t number) const {
  Slot& slot = slots_[number];
  RIGOR_ASSERT(slot.place >= 0);
  std::uint64_t size = 0;
  std::string bytes;
  bool is_read = ::pread(file_, &size, sizeof(size), slot.place) == static_cast<ssize_t>(sizeof(size));
  if (is_read) {
    bytes.resize(size);
    is_read = ::pread(file_, bytes.data(), size, slot.place + static_cast<std::int64_t>(sizeof(size))) ==
              static_cast<ssize_t>(size);
  }
  if (!is_read) throw FileError("the file of rows cannot be read");
  std::string_view rest = bytes;
  std::unique_ptr<Block> block = make_block();
  take_bytes(block->statuses.data(), sizeof(block->statuses), rest);
  take_bytes(block->cpu_times.data(), sizeof(block->cpu_times), rest);
  take_bytes(block->values.data(), sizeof(double) * block->values.size(), rest);
  while (!rest.empty()) {
    std::uint64_t head[2];
    take_bytes(head, sizeof(head), rest);
    block->reasons.emplace_back(head[0], rest.substr(0, head[1]));
    rest.remove_prefix(head[1]);
  }
  slot.block = std::move(block);
  keep(number);
  return *slot.block;
}

bool RowTable::is_complete(std::uint64_t run) const {
  const RunStatus own = status(run);
  return own == RunStatus::done || own == RunStatus::violated;
}

std::string RowTable::reason(std::uint64_t run) const {
  for (const auto& [place, reason] : block_of(run).reasons) {
    if (place == run % block_rows) return reason;
  }
  return {};
}

}  // namespace rigor
