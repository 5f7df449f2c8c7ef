#pragma once

#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/view/recording/recording.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace rigor {

/// The largest difference of a quantity among the bodies, and whose it is; nobody's if there is none.
struct LargestDifference {
  double value = 0;
  std::string body = {};
};

/// How far two runs are apart at one instant: over the bodies that are dynamic in both (found by their
/// names).
struct MotionDifference {
  double time = 0;             ///< [s].
  LargestDifference position;  ///< Of the user's frame's origin [m].
  LargestDifference rotation;  ///< Angle that turns one orientation into the other, from 0 to π [rad].
  LargestDifference velocity;  ///< Of the centre of mass [m/s].
  LargestDifference spin;      ///< Of the angular velocity [rad/s].
};

/// Angle of the rotation from one unit quaternion to another, from 0 to π [rad]; exact for small ones.
double rotation_angle(const Quat& from, const Quat& to);

/// Whether two output times are the same. Each is a multiple of an interval that was read from decimals: two
/// roundings each.
bool is_same_output_time(double a, double b);

/// Of each body that is dynamic in both models, found by its name, the index in the reference.
std::map<int, int> common_dynamic_bodies(const Model& model, const Model& reference);

/// Compares runs with the first of them, at the last output time that both have. Only the first run's motion
/// is kept, and of that at most so many bytes: then every second output time is left out, as often as needed,
/// but never the last one. Of the others the newest comparable moment is kept.
class MotionComparison {
 public:
  static constexpr std::size_t usual_most_bytes = std::size_t{256} << 20;
  explicit MotionComparison(std::size_t most_bytes = usual_most_bytes) : most_bytes_(most_bytes) {}

  /// The next run begins.
  void begin(const Scene& scene);
  /// The state at an output time of this run, with its energy there.
  void observe(const State& state, const Energy& energy);
  /// How far this run is from the first one; nothing for the first one itself, and if no body is in both.
  std::optional<MotionDifference> finish();

 private:
  MotionDifference difference_at(std::size_t frame);
  bool is_first() const { return run_count_ == 1; }

  std::size_t most_bytes_;
  std::size_t run_count_ = 0;
  std::optional<MotionKeeper> reference_;
  std::shared_ptr<const Model> model_;  ///< Of this run.
  std::map<int, int> reference_body_;   ///< Of each body of this run that is dynamic in both.
  std::size_t next_ = 0;                ///< The first output time of the reference that is not yet passed.
  std::optional<std::size_t> common_;   ///< The last one that this run has too,
  TrajectorySample sample_;             ///< and this run there.
};

}  // namespace rigor
