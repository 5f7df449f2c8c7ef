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

/// Enters operations, as above, of what follows bodies between their contact problems: queries of shapes and
/// searches along their ways. Counted apart, and read by schemes that follow bodies on one thread: time
/// stepping shares queries among threads and remembers pairs, so that what one thread does is not the
/// scene's.
void count_following(std::uint64_t operations);
std::uint64_t following_counted();

/// While one lives, what its thread enters by count_following() is forgotten afterwards: for what is done
/// once in a process and kept, which a resumed run does again.
class UncountedFollowing {
 public:
  UncountedFollowing() : before_(following_counted()) {}
  ~UncountedFollowing();
  UncountedFollowing(const UncountedFollowing&) = delete;
  UncountedFollowing& operator=(const UncountedFollowing&) = delete;

 private:
  std::uint64_t before_;
};

}  // namespace rigor
