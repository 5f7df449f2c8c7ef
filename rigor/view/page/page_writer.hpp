#pragma once

#include "rigor/view/page/page_run.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Suffixes of the files that PageWriter writes.
inline constexpr std::array<std::string_view, 1> page_suffixes = {".html"};

/// The viewer: one script (viewer/dist/viewer.js) that finds the data blocks of the page that contains it.
std::string_view viewer_script();
/// Its SHA-256 in hexadecimal digits.
std::string_view viewer_script_sha256();

/// Content-Security-Policy of a page of its own whose one script has this SHA-256 (hexadecimal digits): it
/// may run that script and reach nothing outside.
std::string script_policy(std::string_view sha256);

/// Writes a page that shows these runs (initially the second one as the ghost of the first): the viewer, then
/// the blocks of each run. It needs no network and no other file. Throws FileError.
void write_page(const std::filesystem::path& path, std::string_view title,
                const std::vector<std::vector<PageBlock>>& runs);

/// Parts of a page that differ from a file of its own; where they are empty, they do not differ.
struct ServedPage {
  std::string policy;  ///< Content-Security-Policy.
  std::string script;  ///< Address of the viewer.
  std::string mark;    ///< Content of <meta name="rigor-live">; none if empty.
};
/// The same page as text.
std::string page_text(std::string_view title, const std::vector<std::vector<PageBlock>>& runs,
                      const ServedPage& served);

/// Watches a run and writes it as a page of its own when the run ends.
class PageWriter {
 public:
  /// Throws FileError if the file cannot be written.
  PageWriter(std::filesystem::path path, const Scene& scene);
  void write(const State& state, const AdvanceReport& since, const Energy& energy);
  /// Writes the page with what has been recorded. Throws FileError.
  void close(const Audit& audit);

 private:
  std::filesystem::path path_;
  const Scene& scene_;
  std::optional<PageRun> run_;  ///< Exists from the first output time on.
};

}  // namespace rigor
