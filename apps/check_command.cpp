#include "apps/commands.hpp"
#include "apps/cost_estimate.hpp"
#include "apps/interrupt.hpp"
#include "apps/overlap_text.hpp"
#include "apps/singular_warning.hpp"
#include "apps/slow_warning.hpp"
#include "apps/terminal.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

/// Throws InputError if the scene cannot be run.
Scene read_and_check(const std::string& path) {
  Scene scene = read_scene(path);
  const double tolerance = scene.method.contact_tolerance;
  const std::vector<Overlap> overlaps =
      find_overlaps(*scene.model, make_initial_state(*scene.model), tolerance);
  if (!overlaps.empty()) throw InputError(overlap_messages(path, *scene.model, overlaps, tolerance));
  return scene;
}

/// A line about the study in the scene, which is checked with it; empty if there is none.
std::string study_line(const std::string& path) {
  if (!is_scene_with_study(path)) return "";
  const Study study(read_study(path));
  return fmt::format("  study: {}\n", study_kind_names()[static_cast<std::size_t>(study.plan().kind)]);
}

std::string summary(const Scene& scene) {
  const std::vector<Body>& bodies = scene.model->bodies();
  const auto count = [&](MotionType motion) {
    return std::count_if(bodies.begin(), bodies.end(),
                         [motion](const Body& body) { return body.motion == motion; });
  };
  std::size_t shapes = 0;
  for (const Body& body : bodies) shapes += body.shapes.size();
  return fmt::format(
      "{} {} ({} dynamic, {} kinematic, {} static), {} shapes, {} joints, {} forces; {:g} s in {}",
      bodies.size(), bodies.size() == 1 ? "body" : "bodies", count(MotionType::dynamic),
      count(MotionType::kinematic), count(MotionType::fixed), shapes, scene.model->joints().size(),
      scene.model->forces().size() + scene.model->drives().forces.size(), scene.run.duration,
      method_choice(resolve_scheme(*scene.model, scene.method).method, "scheme"));
}

/// A line with the scheme that `auto` chooses and the reason; empty if the scene names a scheme.
std::string choice_line(const Scene& scene) {
  const std::string reason = resolve_scheme(*scene.model, scene.method).scheme_reason;
  return reason.empty() ? "" : fmt::format("  scheme auto: {}\n", reason);
}

/// Prints what the run of a scene would cost. Returns whether it was not interrupted.
bool print_estimate(const std::string& path) {
  const InterruptWatch watch;
  const bool is_shown = is_terminal(stderr);
  const CostEstimate estimate = estimate_costs(
      path,
      [is_shown](const std::string& what) {
        if (is_shown) fmt::print(stderr, "\r  measuring: {}\x1b[K", what);
      },
      [&watch] { return watch.is_requested(); });
  if (is_shown) fmt::print(stderr, "\r\x1b[K");
  fmt::print("{}", estimate_text(estimate));
  return !watch.is_requested();
}

}  // namespace

ExitCode execute(const CheckOptions& options) {
  ExitCode code = exit_done;
  for (const std::string& path : options.scenes) {
    try {
      const Scene scene = read_and_check(path);
      const std::string study = study_line(path);
      for (const std::string& warning : scene.warnings) print_warning(warning);
      const State start = make_initial_state(*scene.model);
      for (const std::string& warning : {singular_warning(scene, start), slow_warning(scene, start)})
        if (!warning.empty()) print_warning(warning);
      fmt::print("{}: {}: {}\n{}{}", path, toned("ok", Tone::good, stdout), summary(scene),
                 choice_line(scene), study);
      if (options.has_estimate && !print_estimate(path)) return exit_interrupted;
    } catch (const InputError& error) {
      for (const std::string& message : error.messages()) print_error(message);
      code = exit_bad_input;
    }
  }
  return code;
}

}  // namespace rigor
