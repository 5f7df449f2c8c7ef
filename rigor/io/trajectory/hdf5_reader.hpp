#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A trajectory read back from an HDF5 file: T output times of n bodies, N events; arrays are stored by rows.
struct StoredTrajectory {
  std::string rigor, scene,
      scene_text;                      ///< Version of the program that wrote it, name and text of the scene.
  std::string scene_file;              ///< Name or path of the scene; empty in files of Rigor 0.1.0.
  std::vector<std::string> overrides;  ///< "key=value", as of --set.
  std::vector<std::string> bodies;     ///< n names.
  std::vector<double> time;            ///< T [s].
  std::vector<double> position;        ///< T × n × 3 [m].
  std::vector<double> orientation;     ///< T × n × 4, w x y z.
  std::vector<double> velocity;        ///< T × n × 3 [m/s].
  std::vector<double> angular_velocity;  ///< T × n × 3 [rad/s].
  std::vector<std::string> joints;       ///< J names; empty if there are none, and in files of Rigor 0.1.0.
  std::vector<int> coordinate_joint;     ///< C: the joint of each coordinate.
  std::vector<double> joint_coordinate;  ///< T × C [rad] or [m].
  std::vector<double> joint_rate;        ///< T × C [rad/s] or [m/s].
  std::vector<double> joint_force;       ///< T × J × 3 [N]; empty if the file holds no forces.
  std::vector<double> joint_torque;      ///< T × J × 3 [N m]; likewise.
  std::vector<double> joint_effort;      ///< T × C [N m] or [N]; empty if the file holds none.
  std::vector<double> energy;            ///< T × 3: kinetic, potential, elastic [J].
  std::vector<double> penetration;       ///< T [m]: deepest overlap since the row before; empty as above.
  std::vector<double> event_time;        ///< N [s].
  std::vector<int> event_kind;           ///< N, values of MotionEvent::Kind.
  std::vector<int> event_bodies;         ///< N × 2.
  std::vector<double> event_point;       ///< N × 3 [m].
  std::vector<double> event_impulse;     ///< N × 3 [N s].
  /// Empty, or what is left of a truncated file: "'run.h5': it is cut off, ...".
  std::string cut_off;
  /// Empty, or how far a run has come that was killed or stopped: "'run.h5': the run ended at t = 1 s of 2
  /// s".
  std::string ended_early;
};

/// Reads a file that Hdf5Writer has written, is writing, or was writing when it was killed: the T output
/// times that are complete in the file. The same holds for a truncated file. Throws InputError if it is not
/// such a file, or has lost all output times.
StoredTrajectory read_hdf5_trajectory(const std::filesystem::path& path);

}  // namespace rigor
