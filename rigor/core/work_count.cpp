#include "rigor/core/work_count.hpp"

namespace rigor {

namespace {

thread_local std::uint64_t operations_counted = 0;

}  // namespace

void count_work(std::uint64_t operations) {
  operations_counted += operations;
}

std::uint64_t work_counted() {
  return operations_counted;
}

}  // namespace rigor
