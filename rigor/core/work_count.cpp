#include "rigor/core/work_count.hpp"

namespace rigor {

namespace {

thread_local std::uint64_t operations_counted = 0;
thread_local std::uint64_t operations_of_following = 0;

}  // namespace

void count_work(std::uint64_t operations) {
  operations_counted += operations;
}

std::uint64_t work_counted() {
  return operations_counted;
}

void count_following(std::uint64_t operations) {
  operations_of_following += operations;
}

std::uint64_t following_counted() {
  return operations_of_following;
}

UncountedFollowing::~UncountedFollowing() {
  operations_of_following = before_;
}

}  // namespace rigor
