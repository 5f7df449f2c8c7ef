#pragma once

#include "apps/motion_comparison.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A largest error, with its body and its time.
struct LargestError {
  double value = 0;
  std::string body = {};
  double time = 0;  ///< [s].
};

/// The errors of a run with respect to its known motion, over the times at which that is known.
struct MotionError {
  LargestError position;           ///< Distance of a point of a body from where it should be [m].
  LargestError angle;              ///< Of the rotation between actual and known orientation [rad].
  double good_until = 0;           ///< Last compared time before the distance exceeds the bound [s].
  bool is_good_throughout = true;  ///< It never exceeds the bound.
  double compared_until = 0;       ///< Last compared time [s].
};

/// Largest distance between a point of a body at one pose and the same point at another, of all points of the
/// ball of this radius [m] about the origin of B. With the rotation Q by θ about n that takes the second
/// orientation to the first, (Q - I) s reaches every vector of length 2 sin(θ/2) ρ across n, so
///
///   d = √((|Δ_⊥| + 2 sin(θ/2) ρ)² + Δ_∥²),   Δ = p - p', split across and along n.
double largest_point_distance(const Vec3& p_WB, const Quat& q_WB, const Vec3& p_WB_other,
                              const Quat& q_WB_other, double radius);

/// The radius [m] of the ball that contains the shapes of a body; 0 without shapes.
double point_radius(const Body& body);

/// Error above which a motion counts as a different one: a hundredth of the largest radius of a dynamic body,
/// or of the length of the scene where none has shapes [m].
double default_error_bound(const Model& model);

/// Measures the error of a run as it is computed.
class ErrorMeasure {
 public:
  virtual ~ErrorMeasure() = default;
  /// Takes a state at an output time, with its energy.
  virtual void observe(const State& state, const Energy& energy) = 0;
  /// The error so far; nothing if no time could be compared.
  std::optional<MotionError> error() const;

 protected:
  /// bound [m]: largest error of a good motion.
  explicit ErrorMeasure(double bound) : bound_(bound) {}
  void note_time(double t);
  void note_position(double distance, const std::string& body, double t);
  void note_angle(double angle, const std::string& body, double t);

 private:
  double bound_;
  bool has_time_ = false;
  MotionError error_;
};

/// Error relative to a reference run: over all points of the bodies that are dynamic in both, at all output
/// times that both have, up to the horizon [s].
class ErrorOverTime : public ErrorMeasure {
 public:
  /// The reference must outlive this object.
  ErrorOverTime(std::shared_ptr<const Model> model, const Recording& reference, double bound, double horizon);
  void observe(const State& state, const Energy& energy) override;

 private:
  std::shared_ptr<const Model> model_;
  const Recording& reference_;
  double horizon_;
  std::map<int, int> reference_body_;  ///< For each body that is dynamic in both.
  std::size_t next_ = 0;               ///< First time of the reference that lies ahead.
};

/// Error relative to known places: origins and frames of bodies as the user sees them, at the known times
/// that are output times.
class ErrorAtPlaces : public ErrorMeasure {
 public:
  ErrorAtPlaces(std::shared_ptr<const Model> model, std::vector<ExpectedPlace> places, double bound);
  void observe(const State& state, const Energy& energy) override;

 private:
  std::shared_ptr<const Model> model_;
  std::vector<ExpectedPlace> places_;
};

}  // namespace rigor
