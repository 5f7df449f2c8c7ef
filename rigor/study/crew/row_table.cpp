#include "rigor/study/crew/row_table.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

bool RowTable::enter(const RunRow& row) {
  if (has(row.run)) return false;
  if (row.run >= statuses_.size()) {
    // Twice as many, so that entering costs little; what is not used is never touched.
    const std::uint64_t room = std::max<std::uint64_t>(row.run + 1, 2 * statuses_.size());
    statuses_.resize(room, -1);
    values_.resize(room * columns_, std::numeric_limits<double>::quiet_NaN());
    cpu_times_.resize(room, 0);
  }
  statuses_[row.run] = static_cast<signed char>(row.status);
  cpu_times_[row.run] = static_cast<float>(row.cpu_time);
  total_cpu_time_ += row.cpu_time;
  for (std::size_t k = 0; k < std::min(columns_, row.outcomes.size()); ++k)
    values_[row.run * columns_ + k] = row.outcomes[k];
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
