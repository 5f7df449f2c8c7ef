#include "rigor/io/trajectory/trajectory_writer.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/csv_writer.hpp"
#include "rigor/io/trajectory/hdf5_writer.hpp"
#include "rigor/io/trajectory/json_writer.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace rigor {

namespace {

using MakeWriter = std::unique_ptr<TrajectoryWriter> (*)(const std::filesystem::path&,
                                                         const TrajectoryHeader&);

template <typename Writer>
std::unique_ptr<TrajectoryWriter> make_writer(const std::filesystem::path& path,
                                              const TrajectoryHeader& header) {
  return std::make_unique<Writer>(path, header);
}

/// A new format is one more row of this table (docs/extending.md).
struct Format {
  std::string_view suffix;
  MakeWriter make;
};
constexpr std::array formats = {Format{".csv", make_writer<CsvWriter>},
                                Format{".h5", make_writer<Hdf5Writer>},
                                Format{".json", make_writer<JsonWriter>}};

const Format* find_format(const std::filesystem::path& path) {
  for (const Format& format : formats) {
    if (path.extension() == format.suffix) return &format;
  }
  return nullptr;
}

void append(const Vec3& v, std::vector<double>& values) {
  values.insert(values.end(), v.data(), v.data() + 3);
}

}  // namespace

TrajectorySample make_sample(const Model& model, const State& state, const Energy& energy) {
  TrajectorySample sample{.time = state.t, .energy = energy};
  for (int i = 0; i < model.body_count(); ++i) {
    const Pose X_WB{rotation_matrix(state.orientation(i)), state.position(i)};
    const Pose X_WU = X_WB * model.body(i).X_BU;
    const Quat q_WU = quaternion_of(X_WU.R);
    append(X_WU.p, sample.position);
    sample.orientation.insert(sample.orientation.end(), {q_WU.w(), q_WU.x(), q_WU.y(), q_WU.z()});
    append(linear_velocity(model, state, i), sample.velocity);
    append(angular_velocity(model, state, i), sample.angular_velocity);
  }
  return sample;
}

std::vector<TrajectoryJoint> trajectory_joints(const Model& model) {
  std::vector<TrajectoryJoint> joints;
  for (const Joint& joint : model.joints()) {
    TrajectoryJoint& named = joints.emplace_back(TrajectoryJoint{joint.name, {}});
    for (int k = 0; k < coordinate_count(joint.type); ++k)
      named.units.push_back(is_angle(joint.type, k) ? "rad" : "m");
  }
  return joints;
}

bool has_joint_forces(const Model& model) {
  constexpr std::size_t most_joints = 200;
  return !model.joints().empty() && model.joints().size() <= most_joints;
}

bool has_efforts(const Model& model) {
  if (!has_joint_forces(model)) return false;
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    if (model.has_motor(i)) return true;
  }
  return false;
}

const char* effort_unit(const std::string& coordinate_unit) {
  return coordinate_unit == "rad" ? "N m" : "N";
}

void add_joint_motion(const Model& model, const Method& method, const State& state,
                      TrajectorySample& sample) {
  const bool has_forces = has_joint_forces(model), drives = has_efforts(model);
  for (const JointReaction& joint :
       has_forces ? joint_snapshot(model, method, state) : joint_motions(model, state)) {
    sample.joint_coordinate.insert(sample.joint_coordinate.end(), joint.coordinates.begin(),
                                   joint.coordinates.end());
    sample.joint_rate.insert(sample.joint_rate.end(), joint.rates.begin(), joint.rates.end());
    if (!has_forces) continue;
    append(joint.force_W, sample.joint_force);
    append(joint.torque_W, sample.joint_torque);
    if (drives)
      sample.joint_effort.insert(sample.joint_effort.end(), joint.efforts.begin(), joint.efforts.end());
  }
}

std::string trajectory_suffixes() {
  std::string suffixes;
  for (const Format& format : formats) suffixes += (suffixes.empty() ? "" : " ") + std::string(format.suffix);
  return suffixes;
}

std::string check_output_suffix(const std::filesystem::path& path,
                                std::span<const std::string_view> written_elsewhere) {
  const std::string suffix = path.extension().string(), name = quoted_text(path.string());
  const bool is_elsewhere =
      std::find(written_elsewhere.begin(), written_elsewhere.end(), suffix) != written_elsewhere.end();
  if (find_format(path) || is_elsewhere) return {};
  std::string available = " " + trajectory_suffixes();
  for (const std::string_view other : written_elsewhere) available += fmt::format(" {}", other);
  if (suffix.empty()) return fmt::format("output {}: the name has no suffix; available:{}", name, available);
  return fmt::format("output {}: {} is no format that Rigor writes; available:{}", name, suffix, available);
}

std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::filesystem::path& path,
                                                         const TrajectoryHeader& header) {
  const Format* const format = find_format(path);
  RIGOR_ASSERT(format != nullptr);
  return format->make(path, header);
}

TrajectoryHeader trajectory_header(const Scene& scene) {
  TrajectoryHeader header{.scene = scene.name, .method = scene.method, .run = scene.run};
  for (const Body& body : scene.model->bodies()) header.bodies.push_back(body.name);
  header.joints = trajectory_joints(*scene.model);
  header.has_joint_forces = has_joint_forces(*scene.model);
  header.has_efforts = has_efforts(*scene.model);
  return header;
}

const char* event_kind_name(MotionEvent::Kind kind) {
  switch (kind) {
    case MotionEvent::Kind::impact:
      return "impact";
    case MotionEvent::Kind::rest:
      return "rest";
    case MotionEvent::Kind::separation:
      return "separation";
    case MotionEvent::Kind::slip_to_stick:
      return "slip_to_stick";
  }
  return "";
}

}  // namespace rigor
