#include "apps/commands.hpp"
#include "apps/impact_figure.hpp"
#include "apps/impact_report.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/view/3d/png_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace rigor {

namespace {

void check_outputs(const ImpactOptions& options) {
  const auto suffix = [](const std::string& path) {
    return std::filesystem::path(path).extension().string();
  };
  if (!options.path.empty() && suffix(options.path) != ".csv")
    throw UsageError(fmt::format("--path {}: its name must end in .csv", quoted_text(options.path)));
  if (!options.output.empty() && suffix(options.output) != ".svg" && suffix(options.output) != ".png") {
    throw UsageError(
        fmt::format("output {}: its name must end in .svg or .png", quoted_text(options.output)));
  }
}

void write_figure(const std::string& path, const ImpactReport& report) {
  constexpr double pixels_a_unit = 2;
  const Drawing figure = impact_figure(report);
  if (std::filesystem::path(path).extension() == ".svg") {
    write_atomically(path, svg_text(figure));
  } else {
    write_png(path, rasterised(figure, pixels_a_unit));
  }
}

}  // namespace

ExitCode execute(const ImpactOptions& options) {
  check_outputs(options);
  const std::vector<ChosenLaw> laws = read_laws(options);
  ImpactReport report{read_given_impact(options), {}};
  report.results = resolve_by_laws(laws, report.problem.collision);
  for (const std::string& warning : impact_warnings(report)) print_warning(warning);
  if (options.json != "-") fmt::print("{}", impact_text(report));
  write_text(options.json, json_text(impact_json(report)).append("\n"));
  if (!options.path.empty()) write_atomically(options.path, impact_table(report));
  if (!options.output.empty()) write_figure(options.output, report);
  return exit_done;
}

}  // namespace rigor
