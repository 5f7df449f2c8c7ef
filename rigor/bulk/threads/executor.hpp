#pragma once

#include <functional>
#include <memory>

namespace rigor {

/// Runs the iterations of a loop on one or more threads. Loops must be such that their result does not depend
/// on which thread runs which iteration: nothing is added up across iterations, and no iteration writes what
/// another reads. All threads take subnormal numbers as the one that calls does (subnormals.hpp).
class Executor {
 public:
  /// threads >= 1. One means the caller's own thread: no other is started. There are never more threads than
  /// the machine has processors.
  explicit Executor(int threads);
  ~Executor();
  Executor(Executor&& other) noexcept;
  Executor& operator=(Executor&& other) noexcept;

  int threads() const { return threads_; }
  /// Calls body(begin, end) for ranges that make up [0, count); ranges of fewer than `grain` iterations are
  /// not split off. With one thread, or less than two grains, there is one range. Returns when all are done;
  /// what a body throws is thrown from here.
  void for_ranges(int count, int grain, const std::function<void(int, int)>& body) const;

  /// Runs both functions, of which neither may touch what the other writes: at once, if there is another
  /// thread. Loops inside them may be run by one thread alone.
  void run_both(const std::function<void()>& one, const std::function<void()>& other) const;

  /// As long as a Team lives, the other threads wait for loops and do nothing else, so that short loops are
  /// worth sharing: a thread that has to be woken arrives after some 10 µs, one that waits after less than
  /// one. There is one Team at a time, on the thread that calls for_ranges(),
  /// which takes subnormal numbers in the same way as long as it lives.
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
  std::unique_ptr<Pool> pool_;  ///< Null for one thread.
};

}  // namespace rigor
