#pragma once

#include "rigor/dynamics/motion.hpp"

#include <variant>
#include <vector>

namespace rigor {

/// A body on its way from one pose to another in equal measure: what is known of a step with fixed length.
struct StraightPath {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< p_WB [m].
  Quat q = Quat::Identity();                    ///< q_WB at the beginning.
  Vec3 rotation_W = Vec3::Zero();               ///< Rotation vector to the end, of any number of turns [rad].
  bool keeps_axis = true;                       ///< Whether it is known to turn about this axis all the way.
};

/// Where a body was over a span of time.
class PathPiece {
 public:
  /// A part of a motion, which is copied.
  PathPiece(double begin, double end, const Motion& motion);
  PathPiece(double begin, double end, const StraightPath& path);

  double begin() const { return begin_; }
  double end() const { return end_; }
  Pose pose(double t) const;
  Vec3 position(double t) const;  ///< Of the centre of mass [m].
  /// Whether the centre of mass goes straight, at one speed.
  bool is_straight() const { return std::holds_alternative<StraightPath>(path_); }
  /// Box that holds the centre of mass over [ta, tb].
  Aabb centre_box(double ta, double tb) const;
  /// Upper bound of |ω| [rad/s].
  double angular_speed() const { return angular_speed_; }
  /// Whether the orientation on the way is known, and not only at its ends.
  bool knows_orientation() const;

 private:
  double begin_, end_, angular_speed_;
  std::variant<Motion, StraightPath> path_;
};

/// The pieces of one body, one after the other.
using BodyPath = std::vector<PathPiece>;

/// Where a body is at an end of its path, and how it rotates there.
struct PathEnd {
  Vec3 x;  ///< [m].
  Quat q;
  Vec3 w;  ///< [rad/s].
};
/// The straight path between two ends, h apart [s], in about as many turns as the angular velocities make.
StraightPath straight_path(const PathEnd& from, const PathEnd& to, double h);

}  // namespace rigor
