#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/hdf5_reader.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/math/pose.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rigor {

/// A scene and its motion: the source of all pictures and plots.
struct Recording {
  std::shared_ptr<const Model> model;
  std::string name;              ///< Name of the scene.
  double contact_tolerance = 0;  ///< [m].
  StoredTrajectory motion;       ///< At least one output time.

  std::size_t frame_count() const { return motion.time.size(); }
};

/// Reads a trajectory (.h5) with the scene that it carries. Throws InputError if the file is no trajectory,
/// holds no output time, or its scene cannot be built any more (for example because a mesh file is gone).
Recording read_recording(const std::filesystem::path& path);

/// Poses of the bodies' user frames at an output time.
std::vector<Pose> poses_at(const Recording& recording, std::size_t frame);
/// The output time nearest to t [s]: pictures show computed states only and never interpolate.
std::size_t nearest_frame(const Recording& recording, double t);

/// Keeps a motion in memory while it is being computed. When it grows larger than most_bytes, every second
/// output time is dropped, and from then on only every second new one is kept.
class MotionRecorder : public TrajectoryWriter {
 public:
  static constexpr std::size_t usual_most_bytes = std::size_t{512} << 20;

  explicit MotionRecorder(const Scene& scene, std::size_t most_bytes = usual_most_bytes);
  void write(const TrajectorySample& sample, std::span<const MotionEvent> events) override;
  void close(const Audit&) override {}
  /// The recording so far, always including the last output time.
  const Recording& recording();

 private:
  void keep(const TrajectorySample& sample);
  void thin_out();

  Recording recording_;
  std::size_t most_bytes_;
  std::size_t stride_ = 1, count_ = 0;  ///< Output times per one that is kept; output times seen so far.
  TrajectorySample last_;
  bool last_is_kept_ = true;
};

}  // namespace rigor
