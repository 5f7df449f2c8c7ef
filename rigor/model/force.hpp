#pragma once

#include "rigor/math/types.hpp"

#include <variant>

namespace rigor {

/// A body index of a force that means the world (fixed, user frame = W).
inline constexpr int world_body = -1;

/// Constant force on a body at a point fixed on it; with frame_is_body the force rotates with the body.
struct ConstantForce {
  /// Index in the model.
  int body;
  Vec3 f;                    ///< [N] in W (in B with frame_is_body).
  Vec3 p_BP = Vec3::Zero();  ///< Point of attack in B [m].
  /// Whether f is given in B.
  bool frame_is_body = false;
};
/// Constant torque on a body.
struct ConstantTorque {
  /// Index in the model.
  int body;
  Vec3 tau;  ///< [N m] in W (in B with frame_is_body).
  /// Whether tau is given in B.
  bool frame_is_body = false;
};
/// Linear spring and damper between points of two bodies, along the line that joins them, of length d:
/// tension k (d - length) + c ḋ.
struct Spring {
  int body_A;        ///< Index in the model; world_body for the world.
  int body_B;        ///< Likewise.
  Vec3 p_AP;         ///< One end, in A [m].
  Vec3 p_BQ;         ///< The other end, in B [m].
  double stiffness;  ///< k [N/m], ≥ 0.
  double damping;    ///< c [N s/m], ≥ 0.
  double length;     ///< [m], ≥ 0.
};
/// Force -linear v and torque -angular ω on a body.
struct Drag {
  /// Index in the model.
  int body;
  double linear;   ///< [kg/s], ≥ 0.
  double angular;  ///< [kg m²/s], ≥ 0.
};

using Force = std::variant<ConstantForce, ConstantTorque, Spring, Drag>;

}  // namespace rigor
