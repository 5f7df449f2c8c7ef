#pragma once

#include "rigor/study/study.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace rigor {

/// A run of a study once more, as a page that replays it: the same bits, now with its motion. Of chaos both
/// neighbours are on it. policy, script: of a served page, empty for a file of its own.
struct RunPageForm {
  std::string policy, script;
};
/// Throws InputError if there is no such scene, Interrupted if the interrupt asked for an end.
std::string run_page(const Study& study, const RunTask& task, const RunPageForm& form,
                     const std::function<bool()>& interrupt);

/// Most runs of a study whose pages are kept: each takes as much as the viewer, 0.7 MB, and more.
inline constexpr std::uint64_t most_kept_runs = 1000;

/// Writes a page for each run of a study into a folder, which is made: run_0.html, ...; runs that cannot be
/// have none. On so many threads. Whether it came to its end. Throws FileError.
bool keep_run_pages(Study& study, const std::filesystem::path& folder, int threads,
                    const std::function<bool()>& interrupt);

}  // namespace rigor
