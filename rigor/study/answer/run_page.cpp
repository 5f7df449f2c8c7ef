#include "rigor/study/answer/run_page.hpp"

#include "rigor/core/broken_promise.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/page/page_writer.hpp"

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace rigor {

namespace {

/// Runs a scene and keeps what a page shows of it.
std::vector<PageBlock> recorded(const Scene& scene, const std::string& label,
                                const std::function<bool()>& interrupt) {
  std::optional<PageRun> page;
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
    if (!page) page.emplace(scene, state, label);
    page->add(state, since, auditor.energy());
    return true;
  };
  bool was_asked = false;
  const RunResult result = run_simulation(scene.model, scene.method, scene.run, std::nullopt, observer, [&] {
    was_asked = was_asked || (interrupt && interrupt());
    return was_asked;
  });
  if (was_asked || !page) throw Interrupted();
  return page->finish(result.audit);
}

}  // namespace

std::string run_page(const Study& study, const RunTask& task, const RunPageForm& form,
                     const std::function<bool()>& interrupt) {
  const std::vector<Scene> scenes = study.make_executor()->scenes_of(task);
  std::vector<std::vector<PageBlock>> runs;
  runs.reserve(scenes.size());
  for (const Scene& scene : scenes)
    runs.push_back(recorded(scene,
                            scenes.size() < 2 ? ""
                            : runs.empty()    ? "run"
                                              : "its neighbour",
                            interrupt));
  return page_text(fmt::format("{}, run {} · Rigor", study.plan().name, task.run), runs,
                   {.policy = form.policy, .script = form.script});
}

namespace {

/// A run that breaks a promise of the program has no page; its row says why.
void write_page_of(const Study& study, std::uint64_t run, const std::filesystem::path& path,
                   const std::function<bool()>& interrupt) {
  try {
    write_atomically(path, run_page(study, study.known_task(run), {}, interrupt));
  } catch (const BrokenPromise&) {
  }
}

}  // namespace

bool keep_run_pages(Study& study, const std::filesystem::path& folder, int threads,
                    const std::function<bool()>& interrupt) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw FileError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  std::atomic<std::uint64_t> next = 0;
  std::atomic<bool> has_stopped = false;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto asks = [&] { return has_stopped || (interrupt && interrupt()); };
  const auto work = [&] {
    try {
      for (std::uint64_t run = next++; run < study.run_count() && !asks(); run = next++) {
        const RunStatus status = study.rows().status(run);
        if (status == RunStatus::refused || status == RunStatus::out_of_time) continue;
        write_page_of(study, run, folder / fmt::format("run_{}.html", run), asks);
      }
    } catch (const Interrupted&) {
      has_stopped = true;
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
      has_stopped = true;
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
  return !has_stopped && !(interrupt && interrupt());
}

}  // namespace rigor
