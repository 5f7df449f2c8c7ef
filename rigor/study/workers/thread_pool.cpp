#include "rigor/study/workers/worker_pool.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace rigor {

namespace {

class ThreadPool : public WorkerPool {
 public:
  ThreadPool(const MakeExecutor& make, int threads) {
    for (int i = 0; i < std::max(1, threads); ++i) executors_.push_back(make());
  }

  int size() const override { return static_cast<int>(executors_.size()); }

  void carry_out(const TaskSource& source, const std::function<bool()>& interrupt) override {
    has_stopped_ = false;
    error_ = nullptr;
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < executors_.size(); ++i)
      others.emplace_back([&, i] { work(*executors_[i], source, interrupt); });
    work(*executors_[0], source, interrupt);
    for (std::thread& thread : others) thread.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void work(RunExecutor& executor, const TaskSource& source, const std::function<bool()>& interrupt) {
    const std::function<bool()> asks = [&] { return has_stopped_ || (interrupt && interrupt()); };
    try {
      while (!asks()) {
        const std::optional<RunTask> task = next_of(source);
        if (!task) return;
        const std::optional<RunRow> row = executor.run(*task, asks);
        if (!row) return;
        const std::scoped_lock lock(mutex_);
        source.deliver(*row);
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!error_) error_ = std::current_exception();
      has_stopped_ = true;
    }
  }

  std::optional<RunTask> next_of(const TaskSource& source) {
    const std::scoped_lock lock(mutex_);
    return source.next();
  }

  std::vector<std::unique_ptr<RunExecutor>> executors_;
  std::mutex mutex_;
  std::atomic<bool> has_stopped_ = false;
  std::exception_ptr error_;
};

}  // namespace

std::unique_ptr<WorkerPool> make_thread_pool(const MakeExecutor& make, int threads) {
  return std::make_unique<ThreadPool>(make, threads);
}

}  // namespace rigor
