#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/simulation.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigor::test {

/// A run of one of the scenes that the project ships, with all that happened.
struct SceneRun {
  Scene scene;
  RunResult result;
  std::vector<MotionEvent> events;
  std::vector<State> states;  ///< At the output times.

  const Audit& audit() const { return result.audit; }
  /// End of the named body (a broken test if there is none).
  const Audit::BodyEnd& end_of(const std::string& name) const {
    for (const Audit::BodyEnd& body : result.audit.bodies) {
      if (body.name == name) return body;
    }
    throw std::out_of_range(name);
  }
  int body(const std::string& name) const { return scene.model->find_body(name).value(); }
  /// The state at an output time (a broken test if there is none).
  const State& state_at(double t) const {
    for (const State& state : states) {
      if (std::abs(state.t - t) <= 1e-9 * (1 + t)) return state;
    }
    throw std::out_of_range("no output at " + std::to_string(t));
  }
};

inline SceneRun run_scene(const std::string& file, const std::vector<std::string>& overrides = {}) {
  SceneRun run;
  run.scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/" + file, overrides);
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor&) {
    run.events.insert(run.events.end(), since.events.begin(), since.events.end());
    run.states.push_back(state);
    return true;
  };
  run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt, observer);
  return run;
}

}  // namespace rigor::test
