#include "rigor/view/recording/recording.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/trajectory/trajectory_check.hpp"
#include "rigor/math/rotation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Folder of the files of a scene: that of the scene, or that of the trajectory if the path was not stored,
/// or the scene was moved together with it.
std::filesystem::path scene_folder(const StoredTrajectory& motion, const std::filesystem::path& trajectory) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(motion.scene_file).parent_path();
  return !folder.empty() && std::filesystem::is_directory(folder, ignored) ? folder
                                                                           : trajectory.parent_path();
}

/// The scene that the trajectory carries. Throws InputError.
Scene stored_scene(const StoredTrajectory& motion, const std::filesystem::path& path,
                   const std::string& scene_file) {
  try {
    return parse_scene(motion.scene_text, fmt::format("{}: {}", path.string(), scene_file),
                       scene_folder(motion, path), motion.overrides);
  } catch (const InputError& error) {
    if (std::filesystem::path(motion.scene_file).has_parent_path()) throw;
    std::vector<std::string> messages = error.messages();
    messages.push_back(
        fmt::format("{}: files of the scene are looked for beside it; put it beside the scene, "
                    "or run the scene with --keep-path",
                    path.string()));
    throw InputError(std::move(messages));
  }
}

void check_bodies(const Recording& recording, const std::string& path) {
  std::vector<std::string> names;
  for (const Body& body : recording.model->bodies()) names.push_back(body.name);
  if (names != recording.motion.bodies)
    throw InputError(fmt::format("cannot show {}: its motion is not that of its scene's bodies", path));
}

/// Files of Rigor 0.1.0 and motions kept in memory hold no joints.
void check_joints(const Recording& recording, const std::string& path) {
  const StoredTrajectory& motion = recording.motion;
  if (motion.joints.empty()) return;
  std::vector<std::string> names;
  std::vector<int> owners;
  for (const Joint& joint : recording.model->joints()) {
    owners.insert(owners.end(), joint.axes.size(), static_cast<int>(names.size()));
    names.push_back(joint.name);
  }
  if (names != motion.joints || owners != motion.coordinate_joint)
    throw InputError(fmt::format("cannot show {}: its motion is not that of its scene's joints", path));
}

/// Drops every second row of `width` values.
template <typename Value>
void drop_odd_rows(std::size_t width, std::vector<Value>& values) {
  const std::size_t rows = width > 0 ? values.size() / width : 0;
  for (std::size_t row = 2; row < rows; row += 2) {
    std::copy_n(values.begin() + static_cast<long>(row * width), width,
                values.begin() + static_cast<long>(row / 2 * width));
  }
  values.resize((rows + 1) / 2 * width);
}

void append(const std::vector<double>& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  Recording recording;
  recording.motion = read_hdf5_trajectory(path);
  const std::string name = quoted_text(path.string());
  if (const std::string error = trajectory_error(recording.motion); !error.empty())
    throw InputError(fmt::format("cannot show {}: {}", name, error));
  if (recording.motion.time.empty())
    throw InputError(fmt::format("cannot show {}: it holds no output time", name));
  const std::string scene_file = std::filesystem::path(recording.motion.scene_file).filename().string();
  const Scene scene = stored_scene(recording.motion, path, scene_file);
  recording.model = scene.model;
  recording.name = scene.name;
  recording.contact_tolerance = scene.method.contact_tolerance;
  check_bodies(recording, name);
  check_joints(recording, name);
  return recording;
}

std::vector<Pose> poses_at(const Recording& recording, std::size_t frame) {
  const std::size_t n = recording.motion.bodies.size();
  std::vector<Pose> poses;
  for (std::size_t i = frame * n; i < (frame + 1) * n; ++i) {
    const double* const q = &recording.motion.orientation[4 * i];
    poses.push_back(
        {rotation_matrix(Quat(q[0], q[1], q[2], q[3])), Vec3::Map(&recording.motion.position[3 * i])});
  }
  return poses;
}

std::size_t nearest_frame(const Recording& recording, double t) {
  const std::vector<double>& time = recording.motion.time;
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  if (after == time.begin()) return 0;
  if (after == time.end()) return time.size() - 1;
  const std::size_t at = static_cast<std::size_t>(after - time.begin());
  return t - time[at - 1] < time[at] - t ? at - 1 : at;
}

MotionRecorder::MotionRecorder(const Scene& scene, std::size_t most_bytes)
    : recording_{scene.model, scene.name, scene.method.contact_tolerance, {}}, most_bytes_(most_bytes) {
  for (const Body& body : scene.model->bodies()) recording_.motion.bodies.push_back(body.name);
}

void MotionRecorder::write(const TrajectorySample& sample, std::span<const MotionEvent> events) {
  StoredTrajectory& motion = recording_.motion;
  for (const MotionEvent& event : events) {
    motion.event_time.push_back(event.time);
    motion.event_kind.push_back(static_cast<int>(event.kind));
    motion.event_bodies.insert(motion.event_bodies.end(), {event.body_A, event.body_B});
    motion.event_point.insert(motion.event_point.end(), event.p_W.begin(), event.p_W.end());
    motion.event_impulse.insert(motion.event_impulse.end(), event.j_W.begin(), event.j_W.end());
  }
  last_is_kept_ = count_++ % stride_ == 0;
  if (last_is_kept_) {
    keep(sample);
  } else {
    last_ = sample;
  }
  const std::size_t row = 13 * motion.bodies.size() + 5;
  if (motion.time.size() > 2 && motion.time.size() * row * sizeof(double) > most_bytes_) thin_out();
}

void MotionRecorder::keep(const TrajectorySample& sample) {
  StoredTrajectory& motion = recording_.motion;
  motion.time.push_back(sample.time);
  append(sample.position, motion.position);
  append(sample.orientation, motion.orientation);
  append(sample.velocity, motion.velocity);
  append(sample.angular_velocity, motion.angular_velocity);
  append({sample.energy.kinetic, sample.energy.potential, sample.energy.elastic}, motion.energy);
  motion.penetration.push_back(sample.penetration);
}

void MotionRecorder::thin_out() {
  StoredTrajectory& motion = recording_.motion;
  const std::size_t n = motion.bodies.size();
  drop_odd_rows(3 * n, motion.position);
  drop_odd_rows(4 * n, motion.orientation);
  drop_odd_rows(3 * n, motion.velocity);
  drop_odd_rows(3 * n, motion.angular_velocity);
  drop_odd_rows(3, motion.energy);
  drop_odd_rows(1, motion.penetration);
  drop_odd_rows(1, motion.time);
  stride_ *= 2;
}

const Recording& MotionRecorder::recording() {
  if (!last_is_kept_) keep(last_);
  last_is_kept_ = true;
  return recording_;
}

}  // namespace rigor
