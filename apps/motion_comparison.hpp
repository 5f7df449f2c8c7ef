#pragma once

#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/view/recording/recording.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace rigor {

/// The largest difference of a quantity among the bodies, and the body that has it; empty if there is none.
struct LargestDifference {
  double value = 0;
  std::string body = {};
};

/// The differences of two runs at one instant, over the bodies that are dynamic in both (matched by name).
struct MotionDifference {
  double time = 0;             ///< [s].
  LargestDifference position;  ///< Of the origin of the user frame [m].
  LargestDifference rotation;  ///< Angle of the rotation between the orientations, from 0 to π [rad].
  LargestDifference velocity;  ///< Of the centre of mass [m/s].
  LargestDifference spin;      ///< Of the angular velocity [rad/s].
};

/// Angle of the rotation from one unit quaternion to another, from 0 to π [rad]; exact for small ones.
double rotation_angle(const Quat& from, const Quat& to);

/// Whether two output times are the same. Each is a multiple of an interval that was read as a decimal, which
/// makes two roundings each.
bool is_same_output_time(double a, double b);

/// For each body that is dynamic in both models, matched by name, its index in the reference.
std::map<int, int> common_dynamic_bodies(const Model& model, const Model& reference);

/// Compares runs with the first of them at the last output time that both have. Only the motion of the first
/// run is kept, and at most this many bytes of it: beyond that, every second output time is dropped, as often
/// as needed, but never the last one. Of the others, the latest comparable moment is kept.
class MotionComparison {
 public:
  static constexpr std::size_t usual_most_bytes = std::size_t{256} << 20;
  explicit MotionComparison(std::size_t most_bytes = usual_most_bytes) : most_bytes_(most_bytes) {}

  /// Begins the next run.
  void begin(const Scene& scene);
  /// Takes the state at an output time of this run, with its energy.
  void observe(const State& state, const Energy& energy);
  /// The difference of this run from the first one; nothing for the first one itself, and if no body is in
  /// both.
  std::optional<MotionDifference> finish();

 private:
  MotionDifference difference_at(std::size_t frame);
  bool is_first() const { return run_count_ == 1; }

  std::size_t most_bytes_;
  std::size_t run_count_ = 0;
  std::optional<MotionRecorder> reference_;
  std::shared_ptr<const Model> model_;  ///< Model of this run.
  std::map<int, int> reference_body_;   ///< For each body of this run that is dynamic in both.
  std::size_t next_ = 0;                ///< First output time of the reference that lies ahead.
  std::optional<std::size_t> common_;   ///< The last one that this run has too,
  TrajectorySample sample_;             ///< and this run there.
};

}  // namespace rigor
