#include "rigor/study/workers/process_group.hpp"

#include "rigor/study/workers/journal.hpp"

#ifdef RIGOR_WITH_MPI

#include <mpi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace rigor {

namespace {

/// A worker sends the row that it has done (empty: none), and thereby asks for a task; the answer is a task,
/// or empty for the end.
enum Tag : int { row_tag = 1, task_tag = 2 };

bool is_under_mpirun() {
  constexpr std::array names = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  return std::any_of(names.begin(), names.end(),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

void send(const std::string& bytes, int to, Tag tag) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD);
}

/// The next message, if there is one, and who sent it.
bool receive(int from, Tag tag, std::string& bytes, int& sender) {
  int is_there = 0, count = 0;
  MPI_Status status;
  MPI_Iprobe(from, tag, MPI_COMM_WORLD, &is_there, &status);
  if (!is_there) return false;
  MPI_Get_count(&status, MPI_BYTE, &count);
  bytes.resize(static_cast<std::size_t>(count));
  sender = status.MPI_SOURCE;
  MPI_Recv(bytes.data(), count, MPI_BYTE, sender, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return true;
}

/// Waits without keeping a processor busy, which belongs to the runs: MPI's own waiting would.
void nap() {
  std::this_thread::sleep_for(std::chrono::microseconds(500));
}

/// Rows one after the other, each with its length.
void pack(const RunRow& row, std::string& bytes) {
  const std::string one = row_bytes(row);
  const std::uint32_t length = static_cast<std::uint32_t>(one.size());
  std::array<char, sizeof(length)> raw;
  std::memcpy(raw.data(), &length, sizeof(length));
  bytes.append(raw.data(), raw.size()).append(one);
}
std::vector<RunRow> unpacked(std::string_view bytes) {
  std::vector<RunRow> rows;
  std::uint32_t length = 0;
  while (bytes.size() >= sizeof(length)) {
    std::memcpy(&length, bytes.data(), sizeof(length));
    rows.push_back(row_of_bytes(bytes.substr(sizeof(length), length)));
    bytes.remove_prefix(sizeof(length) + length);
  }
  return rows;
}

// A task travels as a row whose outcomes are its point.
RunRow as_row(const RunTask& task) {
  return {task.run, RunStatus::done, 0, task.point, {}};
}

/// How many short runs go in one message: as many as take about this long, so that messages cost little and
/// nobody waits long for the last ones.
class MessageSize {
 public:
  void note(const RunRow& row) {
    time_ += row.cpu_time;
    ++count_;
  }
  int tasks() const {
    constexpr double message_time = 50e-3, shortest_run = 2e-5;
    if (count_ == 0) return 1;
    return static_cast<int>(std::max(1.0, message_time / std::max(shortest_run, time_ / count_)));
  }

 private:
  double time_ = 0, count_ = 0;
};

/// The first process: the thread that called gives out tasks, and only it speaks to MPI; another one works.
class ProcessPool : public WorkerPool {
 public:
  ProcessPool(const MakeExecutor& make, int size)
      : executor_(make()), workers_(static_cast<std::size_t>(size), Worker::unheard) {}

  ~ProcessPool() override {
    for (int rank = 1; rank < size(); ++rank) {
      std::string bytes;
      int sender = 0;
      while (worker(rank) != Worker::waiting) {
        if (receive(rank, row_tag, bytes, sender))
          worker(rank) = Worker::waiting;
        else
          nap();
      }
      send({}, rank, task_tag);
    }
  }

  int size() const override { return static_cast<int>(workers_.size()); }

  void carry_out(const TaskSource& source, const std::function<bool()>& interrupt) override {
    has_stopped_ = is_local_done_ = false;
    error_ = nullptr;
    std::thread local([&] { work_here(source, interrupt); });
    try {
      serve(source, interrupt);
    } catch (...) {
      note_error();
    }
    local.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  enum class Worker { unheard, busy, waiting };
  Worker& worker(int rank) { return workers_[static_cast<std::size_t>(rank)]; }

  void note_error() {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::current_exception();
    has_stopped_ = true;
  }

  void work_here(const TaskSource& source, const std::function<bool()>& interrupt) {
    const std::function<bool()> asks = [&] { return has_stopped_ || (interrupt && interrupt()); };
    try {
      while (!asks()) {
        const std::optional<RunTask> task = next_of(source);
        if (!task) break;
        const std::optional<RunRow> row = executor_->run(*task, asks);
        if (!row) break;
        const std::scoped_lock lock(mutex_);
        source.deliver(*row);
      }
    } catch (...) {
      note_error();
    }
    is_local_done_ = true;
  }

  std::optional<RunTask> next_of(const TaskSource& source) {
    const std::scoped_lock lock(mutex_);
    return source.next();
  }

  /// Tasks for one message; empty if there are none.
  std::string next_tasks(const TaskSource& source) {
    std::string bytes;
    // One lock for all of them: the thread that works here takes it all the time.
    const std::scoped_lock lock(mutex_);
    for (int left = message_.tasks(); left > 0; --left) {
      const std::optional<RunTask> task = source.next();
      if (!task) break;
      pack(as_row(*task), bytes);
    }
    return bytes;
  }

  /// Gives tasks to those who wait and takes rows, until there are no tasks and nobody is busy.
  void serve(const TaskSource& source, const std::function<bool()>& interrupt) {
    bool has_tasks = true;
    while (true) {
      if (has_stopped_ || (interrupt && interrupt())) has_tasks = false;
      bool is_idle = take_rows(source);
      for (int rank = 1; rank < size() && has_tasks; ++rank) {
        if (worker(rank) != Worker::waiting) continue;
        const std::string tasks = next_tasks(source);
        if (!(has_tasks = !tasks.empty())) break;
        send(tasks, rank, task_tag);
        worker(rank) = Worker::busy;
        is_idle = false;
      }
      // A worker that has not been heard yet asks for its first task while others work, or for the end.
      const bool is_anybody_busy =
          std::find(workers_.begin(), workers_.end(), Worker::busy) != workers_.end();
      if (is_local_done_ && !is_anybody_busy) return;
      if (is_idle) nap();
    }
  }

  /// Takes the rows that have come; whether there were none.
  bool take_rows(const TaskSource& source) {
    std::string bytes;
    int sender = 0;
    bool is_idle = true;
    while (receive(MPI_ANY_SOURCE, row_tag, bytes, sender)) {
      is_idle = false;
      worker(sender) = Worker::waiting;
      const std::scoped_lock lock(mutex_);
      for (const RunRow& row : unpacked(bytes)) {
        message_.note(row);
        source.deliver(row);
      }
    }
    return is_idle;
  }

  std::unique_ptr<RunExecutor> executor_;
  std::vector<Worker> workers_;  ///< By rank; the first one is this process.
  MessageSize message_;          ///< Of the thread that speaks to MPI.
  std::mutex mutex_;
  std::atomic<bool> has_stopped_ = false, is_local_done_ = false;
  std::exception_ptr error_;
};

}  // namespace

ProcessGroup::ProcessGroup() {
  if (!is_under_mpirun()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  is_initialised_ = true;
}

ProcessGroup::~ProcessGroup() {
  if (!is_initialised_) return;
  // After an error the others would wait for ever.
  if (std::uncaught_exceptions() > 0 && size_ > 1) MPI_Abort(MPI_COMM_WORLD, 3);
  MPI_Finalize();
}

std::unique_ptr<WorkerPool> ProcessGroup::make_pool(const MakeExecutor& make) const {
  return std::make_unique<ProcessPool>(make, size_);
}

void ProcessGroup::work(const MakeExecutor& make, const std::function<bool()>& interrupt) const {
  const std::unique_ptr<RunExecutor> executor = make();
  send({}, 0, row_tag);
  std::string bytes;
  int sender = 0;
  while (true) {
    while (!receive(0, task_tag, bytes, sender)) nap();
    if (bytes.empty()) return;
    std::string done;
    for (const RunRow& task : unpacked(bytes)) {
      const std::optional<RunRow> row = executor->run({task.run, task.outcomes}, interrupt);
      if (!row) break;
      pack(*row, done);
    }
    send(done, 0, row_tag);
  }
}

}  // namespace rigor

#else  // Built without MPI: there is one process.

namespace rigor {

ProcessGroup::ProcessGroup() = default;
ProcessGroup::~ProcessGroup() = default;

std::unique_ptr<WorkerPool> ProcessGroup::make_pool(const MakeExecutor& make) const {
  return make_thread_pool(make, 1);
}

void ProcessGroup::work(const MakeExecutor&, const std::function<bool()>&) const {}

}  // namespace rigor

#endif
