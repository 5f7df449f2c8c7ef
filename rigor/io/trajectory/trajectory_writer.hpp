#pragma once

#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/method/run_settings.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

struct Scene;

/// A joint whose motion is stored in a trajectory file.
struct TrajectoryJoint {
  std::string name;
  std::vector<std::string> units;  ///< Units of its coordinates: "rad" or "m".
};

/// The constant data of a trajectory file, written at its start.
struct TrajectoryHeader {
  std::string scene;                   ///< Name.
  std::string scene_text;              ///< The scene file as it was read.
  std::string scene_file;              ///< Its name; its full path if the user wants it to be known.
  std::vector<std::string> overrides;  ///< "key=value", as of --set.
  Method method;
  RunSettings run;
  std::vector<std::string> bodies;      ///< Names in model order, n of them.
  std::vector<TrajectoryJoint> joints;  ///< In model order, J of them with C coordinates in all.
  bool has_joint_forces = false;        ///< See has_joint_forces(model).
  bool has_efforts = false;             ///< See has_efforts(model).
};

/// What the scene itself says of its run; the text, file and overrides are left to the caller.
TrajectoryHeader trajectory_header(const Scene& scene);

/// The motion at one output time, as a user sees it.
struct TrajectorySample {
  double time = 0;                       ///< [s].
  std::vector<double> position;          ///< 3n: origins of the user's frames [m].
  std::vector<double> orientation;       ///< 4n: of the user's frames, w x y z.
  std::vector<double> velocity;          ///< 3n: of the centres of mass [m/s].
  std::vector<double> angular_velocity;  ///< 3n: in W [rad/s].
  Energy energy;                         ///< [J].
  double penetration = 0;                ///< Deepest overlap since the last output time [m].
  std::vector<double> joint_coordinate;  ///< C: joint by joint [rad] or [m].
  std::vector<double> joint_rate;        ///< C [rad/s] or [m/s].
  std::vector<double> joint_force;       ///< 3J: reaction on B [N]; empty if the header has none.
  std::vector<double> joint_torque;      ///< 3J: about the anchor, on B [N m]; likewise.
  std::vector<double> joint_effort;      ///< C: of the motors [N m] or [N]; likewise.
};
/// The motion of the bodies; the motion of the joints is left empty.
TrajectorySample make_sample(const Model& model, const State& state, const Energy& energy);

/// The joints of the model as a header names them.
std::vector<TrajectoryJoint> trajectory_joints(const Model& model);
/// Whether trajectories contain the forces of the joints: not for more than 200 joints, since they would be
/// solved for at every output time.
bool has_joint_forces(const Model& model);
/// Whether trajectories contain the forces of motors: where there are motors, and forces of joints.
bool has_efforts(const Model& model);
/// Unit of the force along a coordinate of this unit: "N m" for "rad", "N" for "m".
const char* effort_unit(const std::string& coordinate_unit);
/// Sets the motion of the joints; forces and torques only if has_joint_forces(model), efforts only if
/// has_efforts(model).
void add_joint_motion(const Model& model, const Method& method, const State& state, TrajectorySample& sample);

/// A file to which a trajectory is written as it is computed. What has been written survives the death of the
/// process, except for the last moment. All functions throw FileError.
class TrajectoryWriter {
 public:
  virtual ~TrajectoryWriter() = default;
  /// Writes one output time, with what happened since the last one.
  virtual void write(const TrajectorySample& sample, std::span<const MotionEvent> events) = 0;
  /// Completes the file.
  virtual void close(const Audit& audit) = 0;
};

/// The suffixes of trajectory files: ".csv .h5 .json".
std::string trajectory_suffixes();

/// Empty if a trajectory can be written to a file with this suffix (one of trajectory_suffixes, or one of
/// those that other layers write), or why not: "output 'run.urdf': .urdf is no format that Rigor writes;
/// available: .csv .h5 .json .html .png .mp4".
std::string check_output_suffix(const std::filesystem::path& path,
                                std::span<const std::string_view> written_elsewhere = {});

/// The writer for the suffix, which must be one of those. Creates the file.
std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::filesystem::path& path,
                                                         const TrajectoryHeader& header);

/// Name of a kind of event as written in files: "impact", "rest", "separation", "slip_to_stick".
const char* event_kind_name(MotionEvent::Kind kind);

}  // namespace rigor
