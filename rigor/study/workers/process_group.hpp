#pragma once

#include "rigor/study/workers/worker_pool.hpp"

#include <functional>
#include <memory>

namespace rigor {

/// The processes of one study under mpirun. Alone, without MPI, or built without it, the size is 1 and
/// nothing of MPI is touched. One object a program.
class ProcessGroup {
 public:
  ProcessGroup();
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ~ProcessGroup();

  int size() const { return size_; }
  /// Whether this process works for the first one.
  bool is_worker() const { return rank_ > 0; }
  /// Of the first process: all processes as a pool; it works itself, beside giving out the tasks.
  std::unique_ptr<WorkerPool> make_pool(const MakeExecutor& make) const;
  /// Of the others: carries out tasks until the first process has none.
  void work(const MakeExecutor& make, const std::function<bool()>& interrupt) const;

 private:
  int size_ = 1, rank_ = 0;
  [[maybe_unused]] bool is_initialised_ = false;  ///< Without MPI nothing is.
};

}  // namespace rigor
