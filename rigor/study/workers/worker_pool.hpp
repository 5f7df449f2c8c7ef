#pragma once

#include "rigor/study/run/run_executor.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace rigor {

/// Where the tasks of a study come from and where its rows go. Asked by one thread at a time.
struct TaskSource {
  /// The next task; nothing if there is none.
  std::function<std::optional<RunTask>()> next;
  std::function<void(const RunRow&)> deliver;
};

/// Those who carry out the runs of a study: threads of this process, or processes of a cluster. Each takes
/// its next task when it is free, so nobody waits for others but at the end.
class WorkerPool {
 public:
  virtual ~WorkerPool() = default;
  /// Carries out all tasks of the source, or those that are done when the interrupt asks for an end. An
  /// exception of a run or of the source ends it and is thrown here.
  virtual void carry_out(const TaskSource& source, const std::function<bool()>& interrupt) = 0;
  /// How many runs are under way at a time.
  virtual int size() const = 0;
};

/// Makes an executor for each thread.
using MakeExecutor = std::function<std::unique_ptr<RunExecutor>()>;

/// Threads of this process, at least 1.
std::unique_ptr<WorkerPool> make_thread_pool(const MakeExecutor& make, int threads);

}  // namespace rigor
