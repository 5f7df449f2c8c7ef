#include "apps/compare_reference.hpp"

#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

/// Bounds of method.tolerance.
constexpr double finest_tolerance = 1e-14, coarsest_tolerance = 0.1;

bool is_none(const CompareOptions& options) {
  return options.references.size() == 1 && options.references[0] == "none";
}

/// Choices that the converged run makes by itself.
bool is_replaced(const std::string& text) {
  const std::string key = text.substr(0, text.find('='));
  return key == "method.scheme" || key == "method.integrator" || key == "method.orientation";
}

Scene read_reference_scene(const CompareOptions& options, const std::vector<std::string>& varied) {
  std::vector<std::string> overrides = options.overrides;
  if (options.references.empty()) std::erase_if(overrides, is_replaced);
  overrides.insert(overrides.end(), options.references.begin(), options.references.end());
  overrides.insert(overrides.end(), varied.begin(), varied.end());
  Scene scene = read_scene(options.scene, overrides, varied.size());
  if (options.duration) scene.run.duration = *options.duration;
  return scene;
}

/// Whether the motion is still that of the scene file: only how it is computed, for how long, and what is
/// written is overridden.
bool is_as_expected(const std::vector<std::string>& overrides) {
  return std::all_of(overrides.begin(), overrides.end(), [](const std::string& text) {
    const std::string key = text.substr(0, text.find('='));
    return is_numerical_key(key) || key == "run.duration" || key == "run.output_interval";
  });
}

/// The scene with the best settings of the event-driven scheme.
Scene converged(const Scene& scene) {
  constexpr double finer = 0.01;
  Scene fine = scene;
  fine.method.scheme = Scheme::event_driven;
  fine.method.integrator = IntegratorMethod::exact;
  fine.method.orientation = OrientationForm::quaternion;
  fine.method.tolerance = std::max(finest_tolerance, finer * scene.method.tolerance);
  fine.run.step = 0.5 * scene.run.step;
  return fine;
}

/// The scene with twice the step and a hundred times the tolerance.
Scene roughened(const Scene& scene) {
  constexpr double coarser = 100;
  Scene rough = scene;
  rough.method.tolerance = std::min(coarsest_tolerance, coarser * scene.method.tolerance);
  rough.run.step = 2 * scene.run.step;
  return rough;
}

std::string name_of(const Scene& scene) {
  return fmt::format("{}, integrator {}, step {:g} s, tolerance {:g}", method_choice(scene.method, "scheme"),
                     method_choice(scene.method, "integrator"), scene.run.step, scene.method.tolerance);
}

std::vector<ExpectedPlace> places_within(const Scene& scene) {
  std::vector<ExpectedPlace> places;
  for (const ExpectedPlace& place : scene.expected) {
    if (place.time <= scene.run.duration) places.push_back(place);
  }
  return places;
}

}  // namespace

bool is_numerical_key(std::string_view key) {
  if (key == "run.step") return true;
  return key.starts_with("method.") && key != "method.impact" && key != "method.simultaneous";
}

void check_reference_options(const CompareOptions& options) {
  if (is_none(options)) return;
  for (const std::string& text : options.references) {
    if (text == "none") throw UsageError("--reference none does not go with another --reference");
    if (text.find('=') == std::string::npos)
      throw UsageError(fmt::format("--reference {}: must be KEY=VALUE or none", quoted_text(text)));
  }
}

bool wants_reference(const CompareOptions& options, const std::vector<std::string>& keys) {
  if (is_none(options)) return false;
  return !options.references.empty() || std::any_of(keys.begin(), keys.end(), is_numerical_key);
}

PlannedReference plan_reference(const CompareOptions& options, const std::vector<std::string>& varied) {
  const Scene scene = read_reference_scene(options, varied);
  PlannedReference reference;
  const bool is_chosen = !options.references.empty();
  if (!is_chosen && is_as_expected(options.overrides) && is_as_expected(varied))
    reference.places = places_within(scene);
  if (!reference.places.empty()) {
    reference.name = "the places that the scene expects";
    return reference;
  }
  reference.scene = is_chosen ? scene : converged(scene);
  reference.rougher = roughened(*reference.scene);
  reference.name = name_of(*reference.scene);
  reference.start = make_run_start(options.scene, *reference.scene, options.separate);
  return reference;
}

}  // namespace rigor
