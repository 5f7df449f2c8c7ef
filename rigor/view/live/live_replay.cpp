#include "rigor/view/live/live_replay.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/hdf5_reader.hpp"
#include "rigor/io/trajectory/trajectory_check.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/view/page/page_run.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace rigor {

namespace {

Vec3 vector_at(const std::vector<double>& numbers, std::size_t i) {
  return Vec3::Map(&numbers[3 * i]);
}

/// The State of a stored row: body frames follow from the user frames, momenta from the velocities.
State state_at(const StoredTrajectory& stored, std::size_t row, const Model& model) {
  State state = make_initial_state(model);
  state.t = stored.time[row];
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    const std::size_t at = row * stored.bodies.size() + static_cast<std::size_t>(i);
    const double* const q = &stored.orientation[4 * at];
    const Mat3 R_WU = rotation_matrix(Quat(q[0], q[1], q[2], q[3]));
    const Mat3 R_WB = R_WU * body.X_BU.R.transpose();
    const Vec3 p_WB = vector_at(stored.position, at) - R_WB * body.X_BU.p;
    const Vec3 w_WB = vector_at(stored.angular_velocity, at);
    const Vec3 L_W = R_WB * body.moments.cwiseProduct(R_WB.transpose() * w_WB);
    state.set_body(i, p_WB, quaternion_of(R_WB), body.mass * vector_at(stored.velocity, at), L_W);
  }
  return state;
}

/// The stored events from `next` up to a time; moves `next` to the first one that is later.
AdvanceReport events_until(const StoredTrajectory& stored, double time, std::size_t& next) {
  AdvanceReport report;
  for (; next < stored.event_time.size() && stored.event_time[next] <= time; ++next) {
    const MotionEvent event{.kind = static_cast<MotionEvent::Kind>(stored.event_kind[next]),
                            .time = stored.event_time[next],
                            .body_A = stored.event_bodies[2 * next],
                            .body_B = stored.event_bodies[2 * next + 1],
                            .p_W = vector_at(stored.event_point, next),
                            .j_W = vector_at(stored.event_impulse, next)};
    report.impacts += event.kind == MotionEvent::Kind::impact;
    report.events.push_back(event);
  }
  return report;
}

void check(const StoredTrajectory& stored, const Model& model, const std::string& path) {
  if (const std::string error = trajectory_error(stored); !error.empty())
    throw InputError(fmt::format("{}: {}", path, error));
  if (stored.time.empty()) throw InputError(path + ": the trajectory holds no output time");
  bool is_same = static_cast<std::size_t>(model.body_count()) == stored.bodies.size();
  for (int i = 0; is_same && i < model.body_count(); ++i)
    is_same = model.body(i).name == stored.bodies[static_cast<std::size_t>(i)];
  if (!is_same) throw InputError(path + ": the motion is not that of its scene's bodies");
}

}  // namespace

LiveReplay read_live_replay(const std::filesystem::path& path) {
  const StoredTrajectory stored = read_hdf5_trajectory(path);
  const Scene scene =
      parse_scene(stored.scene_text, path.string() + ": scene", path.parent_path(), stored.overrides);
  const Model& model = *scene.model;
  check(stored, model, path.string());

  // Replay the rows as if they came from a simulation; events after the last row belong to it.
  State state = state_at(stored, 0, model);
  PageRun run(scene, state);
  Audit audit{.scene = stored.scene, .method = scene.method};
  std::size_t next_event = 0;
  for (std::size_t row = 0; row < stored.time.size(); ++row) {
    state = state_at(stored, row, model);
    const bool is_last = row + 1 == stored.time.size();
    const AdvanceReport since = events_until(
        stored, is_last ? std::numeric_limits<double>::infinity() : stored.time[row], next_event);
    const Energy energy{.kinetic = stored.energy[3 * row],
                        .potential = stored.energy[3 * row + 1],
                        .elastic = stored.energy[3 * row + 2]};
    if (row == 0) audit.initial = energy;
    audit.final = energy;
    audit.report.impacts += since.impacts;
    run.add(state, since, energy);
  }
  audit.sim_time = stored.time.back() - stored.time.front();
  audit.warnings = {"made from a trajectory, which holds no audit"};
  std::vector<std::string> warnings;
  for (const std::string& text : {stored.cut_off, stored.ended_early}) {
    if (text.empty()) continue;
    warnings.push_back(text);
    audit.warnings.push_back(text);
  }
  return {scene.name, run.finish(audit), std::move(warnings)};
}

}  // namespace rigor
