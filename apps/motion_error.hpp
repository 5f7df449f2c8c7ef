#pragma once

#include "apps/motion_comparison.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A largest error, whose it is and when.
struct LargestError {
  double value = 0;
  std::string body = {};
  double time = 0;  ///< [s].
};

/// How far a run is from what is known of its motion, over the times at which it is known.
struct MotionError {
  LargestError position;           ///< Distance of a point of a body from where it should be [m].
  LargestError angle;              ///< Of the rotation that a body is off [rad].
  double good_until = 0;           ///< Last compared time before the distance exceeds the bound [s].
  bool is_good_throughout = true;  ///< It never does.
  double compared_until = 0;       ///< Last compared time [s].
};

/// Largest distance between a point of a body at one pose and the same point at another, of all points of the
/// ball of this radius [m] about the origin of B. With the rotation Q by θ about n that turns the second
/// orientation into the first, (Q - I) s reaches every vector of length 2 sin(θ/2) ρ across n, so
///
///   d = √((|Δ_⊥| + 2 sin(θ/2) ρ)² + Δ_∥²),   Δ = p - p', split across and along n.
double largest_point_distance(const Vec3& p_WB, const Quat& q_WB, const Vec3& p_WB_other,
                              const Quat& q_WB_other, double radius);

/// The radius [m] within which the points of a body are: that of its shapes; 0 without shapes.
double point_radius(const Body& body);

/// Error above which a motion counts as another one: a hundredth of the largest radius of a dynamic body, or
/// of the scene's length where none has shapes [m].
double default_error_bound(const Model& model);

/// Measures the error of a run while it goes on.
class ErrorMeasure {
 public:
  virtual ~ErrorMeasure() = default;
  /// A state at an output time, with its energy there.
  virtual void observe(const State& state, const Energy& energy) = 0;
  /// The error so far; nothing if no time could be compared.
  std::optional<MotionError> error() const;

 protected:
  /// bound [m]: of a motion that is good.
  explicit ErrorMeasure(double bound) : bound_(bound) {}
  void note_time(double t);
  void note_position(double distance, const std::string& body, double t);
  void note_angle(double angle, const std::string& body, double t);

 private:
  double bound_;
  bool has_time_ = false;
  MotionError error_;
};

/// Against a reference run: all points of the bodies that are dynamic in both, at all output times that both
/// have, up to the horizon [s].
class ErrorOverTime : public ErrorMeasure {
 public:
  /// The reference outlives this.
  ErrorOverTime(std::shared_ptr<const Model> model, const Recording& reference, double bound, double horizon);
  void observe(const State& state, const Energy& energy) override;

 private:
  std::shared_ptr<const Model> model_;
  const Recording& reference_;
  double horizon_;
  std::map<int, int> reference_body_;  ///< Of each body that is dynamic in both.
  std::size_t next_ = 0;               ///< The first time of the reference that is not yet passed.
};

/// Against known places: origins and frames of bodies as the user sees them, at the times that are known, of
/// those that are output times.
class ErrorAtPlaces : public ErrorMeasure {
 public:
  ErrorAtPlaces(std::shared_ptr<const Model> model, std::vector<ExpectedPlace> places, double bound);
  void observe(const State& state, const Energy& energy) override;

 private:
  std::shared_ptr<const Model> model_;
  std::vector<ExpectedPlace> places_;
};

}  // namespace rigor
