#pragma once

#include "rigor/math/pose.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// What of the relative motion of two bodies a joint leaves free:
///   fixed nothing, ball all turning, hinge turning about z, slider sliding along z, universal turning about
///   z of A and x of B, cylindrical sliding along and turning about z, planar sliding along x and y and
///   turning about z, distance everything but the distance of two points, screw turning about z with sliding
///   in proportion. A gear ties the coordinates of two other joints.
enum class JointType { fixed, ball, hinge, slider, universal, cylindrical, planar, distance, screw, gear };

/// A motor holds the rate of a coordinate, as far as its force goes.
struct JointMotor {
  double velocity = 0;                                         ///< [rad/s] or [m/s].
  double max_force = std::numeric_limits<double>::infinity();  ///< [N m] or [N], ≥ 0.
};

/// What acts along one coordinate of a joint. The coordinate is an angle [rad], from -π to π, or a
/// displacement [m] of B against A, 0 at t = 0; that of a distance joint is the distance.
struct JointAxis {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double restitution = 0;  ///< e of impacts at the limits, in [0, 1].
  std::optional<JointMotor> motor;
  double stiffness = 0;  ///< k [N m/rad] or [N/m], ≥ 0: force -k (coordinate - rest).
  double rest = 0;       ///< [rad] or [m].
  double damping = 0;    ///< c [N m s/rad] or [N s/m], ≥ 0: force -c (rate).
  double friction = 0;   ///< Dry friction: largest force against the rate [N m] or [N], ≥ 0.

  bool is_limited() const {
    return lower > -std::numeric_limits<double>::infinity() ||
           upper < std::numeric_limits<double>::infinity();
  }
};

/// A joint between two bodies. Its frame J on A and its frame K on B fall together at t = 0; only the origins
/// of a distance joint do not.
struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  /// Indices into the model, or world_body; at least one is dynamic. A gear's are both world_body.
  int body_A = 0, body_B = 0;
  Pose X_AJ, X_BK;                          ///< In the body frames A and B (W for the world).
  double pitch = 0;                         ///< Screw: displacement along +z a turn [m].
  double length = 0;                        ///< Distance: what is kept [m], unless it has limits.
  int first_joint = -1, second_joint = -1;  ///< Gear: the joints that it ties, by index.
  double ratio = 0;             ///< Gear: (change of the second's first coordinate) = ratio (of the first's).
  std::vector<JointAxis> axes;  ///< One a coordinate: see coordinate_count().
};

/// "hinge": the type as it is written in scene files.
const char* joint_type_name(JointType type);
/// How many scalar coordinates a joint of this type has: hinge, slider, ball (the angle of the whole
/// rotation), distance, screw (the angle) 1; cylindrical (displacement, angle) and universal (angle about z
/// of A, angle about x of B) 2; planar (along x, along y, angle) 3; fixed and gear none.
int coordinate_count(JointType type);
/// Whether the k-th coordinate is an angle [rad], else it is a length [m].
bool is_angle(JointType type, int k);

}  // namespace rigor
