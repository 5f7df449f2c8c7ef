#pragma once

#include <functional>
#include <memory>

namespace rigor {

/// Runs the rounds of a loop, on one or more threads. Loops are such that their answer does not depend on who
/// runs which round: nothing is added up across rounds, no round writes what another reads.
class Executor {
 public:
  /// threads >= 1. One means the caller's own thread: nothing else is started. There are never more than the
  /// machine has processors.
  explicit Executor(int threads);
  ~Executor();
  Executor(Executor&& other) noexcept;
  Executor& operator=(Executor&& other) noexcept;

  int threads() const { return threads_; }
  /// body(begin, end) over ranges that make up [0, count); ranges of less than `grain` rounds are not split
  /// off. With one thread, or less than two grains, it is one range. Returns when all are done; what a body
  /// throws comes out here.
  void for_ranges(int count, int grain, const std::function<void(int, int)>& body) const;

  /// Runs both, of which neither may touch what the other writes: at once, if there is another thread. Loops
  /// inside them may be run by one thread alone.
  void run_both(const std::function<void()>& one, const std::function<void()>& other) const;

  /// As long as it lives, the other threads wait for loops and do nothing else, so that short ones are worth
  /// to be shared: a thread that is woken comes after some 10 µs, one that waits after less than one. One at
  /// a time, on the thread that calls for_ranges().
  class Team {
   public:
    explicit Team(const Executor& executor);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

   private:
    struct Helpers;
    std::unique_ptr<Helpers> helpers_;
  };

 private:
  struct Pool;

  int threads_;
  std::unique_ptr<Pool> pool_;  ///< None for one thread.
};

}  // namespace rigor
