#include "rigor/study/crew/row_table.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

bool RowTable::enter(const RunRow& row) {
  if (has(row.run)) return false;
  const std::uint64_t number = row.run / block_rows, place = row.run % block_rows;
  if (number >= blocks_.size()) blocks_.resize(number + 1);
  std::unique_ptr<Block>& block = blocks_[number];
  if (!block) {
    block = std::make_unique<Block>();
    block->statuses.fill(-1);
    block->cpu_times.fill(0);
    block->values.assign(block_rows * columns_, std::numeric_limits<double>::quiet_NaN());
  }
  block->statuses[place] = static_cast<signed char>(row.status);
  block->cpu_times[place] = static_cast<float>(row.cpu_time);
  total_cpu_time_ += row.cpu_time;
  for (std::size_t k = 0; k < std::min(columns_, row.outcomes.size()); ++k)
    block->values[place * columns_ + k] = row.outcomes[k];
  if (!row.reason.empty()) reasons_[row.run] = row.reason;
  ++count_;
  while (has(prefix_)) ++prefix_;
  return true;
}

bool RowTable::is_complete(std::uint64_t run) const {
  return status(run) == RunStatus::done || status(run) == RunStatus::violated;
}

std::string RowTable::reason(std::uint64_t run) const {
  const auto found = reasons_.find(run);
  return found == reasons_.end() ? std::string() : found->second;
}

}  // namespace rigor
