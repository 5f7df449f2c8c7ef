#include "apps/run_start.hpp"

#include "apps/overlap_text.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

/// A warning with the distance that bodies were pushed; none if nothing moved.
std::vector<std::string> separation_warning(const State& before, const State& after) {
  int moved = 0;
  double farthest = 0;
  for (int i = 0; i < after.body_count(); ++i) {
    const double distance = (after.position(i) - before.position(i)).norm();
    if (distance > 0) ++moved;
    farthest = std::max(farthest, distance);
  }
  if (moved == 0) return {};
  return {
      fmt::format("bodies overlapped at t = 0: {} were pushed apart, by {:.3g} m at most", moved, farthest)};
}

}  // namespace

RunStart make_run_start(const std::string& scene_file, const Scene& scene, bool separate) {
  const double tolerance = scene.method.contact_tolerance;
  const Model& model = *scene.model;
  RunStart start{make_initial_state(model), {}};
  std::vector<Overlap> overlaps = find_overlaps(model, start.state, tolerance);
  if (!overlaps.empty() && separate) {
    const State as_described = start.state;
    overlaps = apply_separation(model, tolerance, start.state);
    start.warnings = separation_warning(as_described, start.state);
  }
  if (overlaps.empty()) return start;
  std::vector<std::string> messages = overlap_messages(scene_file, model, overlaps, tolerance);
  if (separate) {
    messages.back() = fmt::format("{}: --separate could not push these bodies apart; move them", scene_file);
  }
  throw InputError(std::move(messages));
}

}  // namespace rigor
