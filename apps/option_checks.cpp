#include "apps/option_checks.hpp"

#include "apps/compare_output.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/study/answer/study_output.hpp"
#include "rigor/view/3d/picture_writer.hpp"
#include "rigor/view/page/page_writer.hpp"

#include <array>
#include <filesystem>
#include <string_view>

namespace rigor {

namespace {

bool is_same_file(const std::string& a, const std::string& b) {
  // The path is made absolute first: otherwise a leading "./" would remain of a relative path to nothing.
  const auto whole = [](const std::string& path) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  return whole(a) == whole(b);
}

/// Suffixes of the outputs that the view layer draws, in addition to the trajectories.
constexpr std::array<std::string_view, 3> drawn_suffixes = {page_suffixes[0], picture_suffixes[0],
                                                            picture_suffixes[1]};

/// Refuses outputs that would overwrite the scene or each other.
void check_written(const std::string& scene, const std::vector<std::string>& written) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (is_same_file(written[i], scene)) {
      throw UsageError("output " + quoted_text(written[i]) + " is the scene file; give it another name");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (is_same_file(written[i], written[k]))
        throw UsageError("output " + quoted_text(written[i]) + " is given twice");
    }
  }
}

}  // namespace

void check_run(const RunOptions& run) {
  for (const std::string& output : run.outputs) {
    const std::string message = check_output_suffix(output, drawn_suffixes);
    if (!message.empty()) throw UsageError(message);
  }
  std::vector<std::string> written = run.outputs;
  if (!run.json.empty() && run.json != "-") written.push_back(run.json);
  if (!run.checkpoint.empty()) written.push_back(run.checkpoint);
  check_written(run.scene, written);
  if (run.checkpoint_every && run.checkpoint.empty()) {
    throw UsageError("--checkpoint-every needs --checkpoint FILE");
  }
  if (run.separate && !run.resume.empty()) {
    throw UsageError("--separate does not go with --resume: the bodies are where the checkpoint has them");
  }
}

void check_compare(const CompareOptions& compare) {
  for (const std::string& output : compare.outputs) {
    const std::string message = check_compare_output(output);
    if (!message.empty()) throw UsageError(message);
  }
  std::vector<std::string> written = compare.outputs;
  if (!compare.json.empty() && compare.json != "-") written.push_back(compare.json);
  check_written(compare.scene, written);
}

void check_convert(ConvertOptions& convert) {
  const std::string suffix = std::filesystem::path(convert.output).extension().string();
  if (suffix != ".yaml" && suffix != ".obj") {
    throw UsageError("output " + quoted_text(convert.output) +
                     " is of an unknown kind; available: .yaml (convex pieces) and .obj (mesh)");
  }
  convert.is_mesh_output = suffix == ".obj";
  if (convert.is_exact && convert.tolerance) {
    throw UsageError("--exact does not go with --tolerance: exact pieces do not protrude");
  }
  if (convert.is_mesh_output && (convert.is_exact || convert.tolerance || !convert.json.empty())) {
    throw UsageError("--exact, --tolerance and --json are for pieces, which need an output .yaml");
  }
  std::vector<std::string> written = {convert.output};
  if (!convert.json.empty() && convert.json != "-") written.push_back(convert.json);
  check_written(convert.input, written);
}

void check_study(const StudyOptions& study) {
  if (study.run) {
    if (study.keeps_runs || study.is_viewed || study.is_dry)
      throw UsageError("--run carries out one run; --keep, --view and --dry-run are for the whole study");
    RunOptions run;
    run.scene = study.file;
    run.outputs = study.outputs;
    run.json = study.json;
    return check_run(run);
  }
  const bool has_page = std::any_of(study.outputs.begin(), study.outputs.end(),
                                    [](const std::string& output) { return output.ends_with(".html"); });
  if (study.keeps_runs && !has_page)
    throw UsageError("--keep needs -o PAGE.html, the page that leads to the runs");
  if (!study.is_viewed && (study.port != 0 || study.opens_browser))
    throw UsageError("--port and --open go with --view");
  for (const std::string& output : study.outputs) {
    const std::string message = check_study_output(output);
    if (!message.empty()) throw UsageError(message);
  }
  std::vector<std::string> written = study.outputs;
  if (!study.json.empty() && study.json != "-") written.push_back(study.json);
  if (!study.journal.empty()) written.push_back(study.journal);
  check_written(study.file, written);
}

}  // namespace rigor
