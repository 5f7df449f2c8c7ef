#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/study/answer/study_plot.hpp"
#include "rigor/view/3d/png_file.hpp"
#include "rigor/view/plot/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace rigor {

namespace {

PlotSeries wanted_series(const Recording& recording, const std::string& key) {
  if (std::optional<PlotSeries> series = find_series(recording, key)) return *std::move(series);
  if (const std::optional<std::string> body = body_of_key(key)) {
    throw UsageError(fmt::format("the run has no body {}{}", quoted_text(*body),
                                 suggestion(*body, recording.motion.bodies)));
  }
  const std::vector<std::string>& joints = recording.motion.joints;
  const std::optional<std::string> joint = joint_of_key(key);
  if (joint && !joints.empty() && std::find(joints.begin(), joints.end(), *joint) == joints.end()) {
    throw UsageError(
        fmt::format("the run has no joint {}{}", quoted_text(*joint), suggestion(*joint, joints)));
  }
  throw UsageError(fmt::format("unknown key {}{}", quoted_text(key), suggestion(key, plot_keys(recording))));
}

Drawing trajectory_plot(const PlotOptions& options) {
  const Recording recording = read_recording(options.input);
  for (const std::string& text : {recording.motion.cut_off, recording.motion.ended_early}) {
    if (!text.empty()) print_warning(text);
  }
  if (options.keys.empty())
    throw UsageError(
        "say what to plot of a trajectory, for example energy.total; 'rigor plot --help' lists the keys");
  std::vector<PlotSeries> series;
  for (const std::string& key : options.keys) series.push_back(wanted_series(recording, key));
  return make_plot(recording.motion.time, series);
}

}  // namespace

ExitCode execute(const PlotOptions& options) {
  constexpr double pixels_a_unit = 2;
  const std::string suffix = std::filesystem::path(options.output).extension().string();
  if (suffix != ".svg" && suffix != ".png") {
    throw UsageError(
        fmt::format("output {}: its name must end in .svg or .png", quoted_text(options.output)));
  }
  const Drawing plot = is_study_file(options.input)
                           ? study_plot(read_study_columns(options.input), options.keys)
                           : trajectory_plot(options);
  if (suffix == ".svg") {
    write_atomically(options.output, svg_text(plot));
  } else {
    write_png(options.output, rasterised(plot, pixels_a_unit));
  }
  return exit_done;
}

}  // namespace rigor
