#pragma once

#include "rigor/io/trajectory/trajectory_writer.hpp"

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <string>

/// Trajectories and folders for tests of writers.
namespace rigor {

/// An empty folder that goes with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rigor_test_XXXXXX").string();
    if (!::mkdtemp(name.data())) std::abort();
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline TrajectoryHeader sample_header(std::vector<std::string> bodies) {
  return {.scene = "test",
          .scene_text = "rigor: 1\n",
          .overrides = {"run.duration=2"},
          .bodies = std::move(bodies)};
}

/// With joints of two coordinates each, a displacement and an angle.
inline TrajectoryHeader jointed_header(std::vector<std::string> bodies,
                                       const std::vector<std::string>& joints) {
  TrajectoryHeader header = sample_header(std::move(bodies));
  for (const std::string& joint : joints) header.joints.push_back({joint, {"m", "rad"}});
  header.has_joint_forces = true;
  return header;
}

/// Row k of a made-up trajectory: every number tells its row and place.
inline TrajectorySample sample_row(int k, std::size_t body_count, std::size_t joint_count = 0) {
  TrajectorySample sample;
  const auto fill = [&](std::vector<double>& values, std::size_t count, double base) {
    for (std::size_t i = 0; i < count; ++i) values.push_back(base * k + static_cast<double>(i) / 3);
  };
  sample.time = 0.1 * k;
  fill(sample.position, 3 * body_count, 1);
  fill(sample.orientation, 4 * body_count, 2);
  fill(sample.velocity, 3 * body_count, 3);
  fill(sample.angular_velocity, 3 * body_count, 4);
  fill(sample.joint_coordinate, 2 * joint_count, 8);
  fill(sample.joint_rate, 2 * joint_count, 9);
  fill(sample.joint_force, 3 * joint_count, 10);
  fill(sample.joint_torque, 3 * joint_count, 11);
  sample.energy = {.kinetic = 5.0 * k, .potential = 6.0 * k, .elastic = 7.0 * k};
  return sample;
}

inline MotionEvent sample_event(int k) {
  return {MotionEvent::Kind::separation, 0.1 * k, k, k + 1, Vec3(k, 0.5, 0.25), Vec3(0.125, k, -1)};
}

}  // namespace rigor
