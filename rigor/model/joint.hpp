#pragma once

#include "rigor/math/pose.hpp"
#include "rigor/model/joint_traits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A motor holds the rate of a coordinate, as far as its force goes.
struct JointMotor {
  double velocity = 0;                                         ///< [rad/s] or [m/s].
  double max_force = std::numeric_limits<double>::infinity();  ///< [N m] or [N], ≥ 0.
};

/// The laws that act along one coordinate of a joint. The coordinate is an angle [rad], from -π to π, or a
/// displacement [m] of B against A, 0 at t = 0; that of a distance joint is the distance.
struct JointAxis {
  /// Lowest coordinate.
  double lower = -std::numeric_limits<double>::infinity();
  /// Highest coordinate.
  double upper = std::numeric_limits<double>::infinity();
  double restitution = 0;  ///< e of impacts at the limits, in [0, 1].
  /// What drives the coordinate.
  std::optional<JointMotor> motor;
  double stiffness = 0;  ///< k [N m/rad] or [N/m], ≥ 0: force -k (coordinate - rest).
  double rest = 0;       ///< [rad] or [m].
  double damping = 0;    ///< c [N m s/rad] or [N s/m], ≥ 0: force -c (rate).
  double friction = 0;   ///< Dry friction: largest force against the rate [N m] or [N], ≥ 0.

  /// Whether the coordinate has a stop.
  bool is_limited() const {
    return lower > -std::numeric_limits<double>::infinity() ||
           upper < std::numeric_limits<double>::infinity();
  }
};

/// A joint between two bodies. Its frame F on A and its frame K on B coincide at t = 0, except for the
/// origins of a distance joint.
struct Joint {
  /// Unique among the joints.
  std::string name;
  /// Which motions it leaves.
  JointType type = JointType::fixed;
  /// Index into the model, or world_body; at least one body is dynamic. A gear's are both world_body.
  int body_A = 0;
  int body_B = 0;  ///< Likewise.
  Pose X_AF;       ///< The joint's frame on A (W for the world).
  Pose X_BK;       ///< The joint's frame on B (W for the world).
  /// The number of its relation (JointTraits::parameter). Of a screw: the pitch, displacement along +z per
  /// turn [m]. Of a gear: the ratio, (change of the second's first coordinate) = ratio (of the first's).
  double parameter = 0;
  double length = 0;  ///< Distance: the distance that is kept [m], unless it has limits.
  /// Of a gear.
  int first_joint = -1, second_joint = -1;  ///< Gear: the joints that it ties, by index.
  std::vector<JointAxis> axes;              ///< One per coordinate of its type.

  /// Whether one of its coordinates has a motor.
  bool has_motor() const {
    return std::any_of(axes.begin(), axes.end(),
                       [](const JointAxis& axis) { return axis.motor.has_value(); });
  }
  /// Whether one of these takes whatever force its speed asks for.
  bool has_unbounded_motor() const {
    return std::any_of(axes.begin(), axes.end(),
                       [](const JointAxis& axis) { return axis.motor && std::isinf(axis.motor->max_force); });
  }
};

}  // namespace rigor
