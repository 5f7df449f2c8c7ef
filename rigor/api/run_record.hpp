#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/audit/audit.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rigor {

/// A run in memory: T output times, n bodies, C coordinates of joints. Arrays are flat, time by time.
struct RunRecord {
  std::vector<double> time;              ///< T [s].
  std::vector<double> position;          ///< T n 3: origins of the user's frames [m].
  std::vector<double> orientation;       ///< T n 4: of these frames, w x y z.
  std::vector<double> velocity;          ///< T n 3: of the centres of mass [m/s].
  std::vector<double> angular_velocity;  ///< T n 3: in W [rad/s].
  std::vector<double> kinetic;           ///< T: energy [J]; likewise the next two.
  /// Of gravity and steady forces, at each output [J].
  std::vector<double> potential;
  /// In springs, at each output [J].
  std::vector<double> elastic;
  std::vector<double> penetration;       ///< T: deepest overlap since the last output time [m].
  std::vector<double> joint_coordinate;  ///< T C: joint by joint [rad] or [m].
  std::vector<double> joint_rate;        ///< T C [rad/s] or [m/s].
  std::vector<MotionEvent> events;       ///< In their order.
  /// Of the whole run.
  Audit audit;
  /// Whether the interrupt has ended it.
  bool was_interrupted = false;
};

/// How a scene is run by record_run().
struct RecordOptions {
  bool separate = false;  ///< Bodies that overlap at t = 0 are pushed apart.
  /// Asked at every event or step: true ends the run at the last output time.
  std::function<bool()> interrupt;
  /// Called at every output time with the time [s].
  std::function<void(double t)> progress;
  /// Files that are written besides: .csv, .h5, .json, .html, .png (docs/output.md).
  std::vector<std::filesystem::path> files;
  std::string scene_text;              ///< The scene as a text, which goes into these files.
  std::string scene_file;              ///< The name of its file, which they give.
  std::vector<std::string> overrides;  ///< What was set in it, as of `--set`.
};

/// Runs a scene from t = 0 to `run.duration`, as the program does, with the same bits. Throws InputError as
/// Simulation does, or for a suffix that no writer has; FileError. A run that stops early says why in
/// audit.report.
RunRecord record_run(const Scene& scene, const RecordOptions& options = {});

}  // namespace rigor
