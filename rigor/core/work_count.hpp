#pragma once

#include <cstdint>

namespace rigor {

/// Enters elementary operations of this thread: a measure of cost that is the same on every machine, where a
/// clock would not be. One is about a tenth of a microsecond of processor time, such as what a contact costs
/// in one evaluation of its law, or the product of two 6 × 6 blocks. Kernels whose cost the input decides
/// enter what they do; results never depend on it, but for who carries on a run (decision 23).
void count_work(std::uint64_t operations);

/// What this thread has counted since it began.
std::uint64_t work_counted();

}  // namespace rigor
