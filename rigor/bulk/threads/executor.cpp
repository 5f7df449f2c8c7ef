#include "rigor/bulk/threads/executor.hpp"

#include "rigor/bulk/threads/shared_loop.hpp"
#include "rigor/bulk/threads/subnormals.hpp"
#include "rigor/core/assert.hpp"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <cstdint>

namespace rigor {

struct Executor::Pool {
  explicit Pool(int threads)
      : arena(std::min({threads, tbb::info::default_concurrency(), SharedLoop::most_members})) {
    loop.set_members(arena.max_concurrency());
  }

  tbb::task_arena arena;
  SharedLoop loop;
  bool has_team = false;
};

struct Executor::Team::Helpers {
  explicit Helpers(Pool& owner) : pool(owner) {
    pool.loop.open();
    pool.has_team = true;
    const Subnormals subnormals = subnormals_now();
    pool.arena.execute([&] {
      for (int member = 1; member < pool.arena.max_concurrency(); ++member) {
        group.run([this, subnormals, member] {
          const SubnormalScope scope(subnormals);
          pool.loop.help(member);
        });
      }
    });
  }
  ~Helpers() {
    pool.has_team = false;
    pool.loop.close();
    pool.arena.execute([this] { group.wait(); });
  }

  Pool& pool;
  tbb::task_group group;
};

Executor::Team::Team(const Executor& executor) {
  if (executor.pool_) helpers_ = std::make_unique<Helpers>(*executor.pool_);
}
Executor::Team::~Team() = default;

Executor::Executor(int threads) : threads_(threads) {
  RIGOR_ASSERT(threads >= 1);
  if (threads > 1) pool_ = std::make_unique<Pool>(threads);
}

Executor::~Executor() = default;
Executor::Executor(Executor&& other) noexcept = default;
Executor& Executor::operator=(Executor&& other) noexcept = default;

void Executor::for_ranges(int count, int grain, const std::function<void(int, int)>& body) const {
  // There are more ranges than threads, so that a thread that the operating system suspends for a while
  // delays only a part of its share.
  constexpr int ranges_of_a_thread = 4;
  if (count <= 0) return;
  const int ranges =
      std::min({count / std::max(grain, 1), ranges_of_a_thread * threads_, SharedLoop::most_ranges});
  // A loop inside a loop runs alone: the threads are taken.
  if (!pool_ || ranges <= 1 || pool_->loop.is_running()) return body(0, count);
  // A team waits for loops already; otherwise threads are woken.
  if (pool_->has_team) return pool_->loop.run(count, ranges, body);
  const auto begin_of = [&](int k) {
    return static_cast<int>(static_cast<std::int64_t>(count) * k / ranges);
  };
  const Subnormals subnormals = subnormals_now();
  const auto run_range = [&](int k) {
    const SubnormalScope scope(subnormals);
    body(begin_of(k), begin_of(k + 1));
  };
  pool_->arena.execute([&] { tbb::parallel_for(0, ranges, run_range, tbb::simple_partitioner()); });
}

void Executor::run_both(const std::function<void()>& one, const std::function<void()>& other) const {
  for_ranges(2, 1, [&](int begin, int end) {
    if (begin == 0) one();
    if (end == 2) other();
  });
}

}  // namespace rigor
