#pragma once

#include "rigor/geometry/motion/time_of_contact.hpp"

#include <span>

namespace rigor {

/// From where, and under which allowances, a mesh and another shape are advanced.
struct MeshAdvance {
  double t = 0, t_end = 0;      ///< The span [s].
  double distance = 0;          ///< Of the surfaces at t [m]; 0 or less where they meet.
  double touch = 0;             ///< Distances that rounding cannot tell from contact [m].
  double slack = 0;             ///< By how much parts that touch without approaching may come to overlap [m].
  double rest_velocity = 0;     ///< Gap rates above minus this are not an approach [m/s].
  std::span<const Vec3> n_W{};  ///< Normals of the contacts at t, from A to B.
};

/// A time that a moving mesh A and another one, or a bounded convex shape, can go on from t, at most
/// t_end - t, without a new overlap [s].
///
/// Pairs of triangles (or triangles and the convex shape) that are farther apart than all points can travel
/// are safe. Each other pair is safe as long as one direction parts it (SeparationBound, of second order):
/// that of their nearest points, the normals of the two triangles and those of the contacts are tried.
/// Triangles that slide along each other are parted by the normal of the contact, so that sliding and rolling
/// cost no small steps. What touches at t must not approach: the caller has looked at the contacts.
double safe_mesh_step(const MovingShape& A, const MovingShape& B, const MeshAdvance& from);

/// Upper bound of how fast points of A and B can come nearer, at t and as it grows: speed [m/s] and
/// acceleration [m/s²].
struct ClosingBound {
  double speed;
  double acceleration;

  /// Time in which no point comes nearer by more than the distance [s].
  double time_for(double distance) const;
};
ClosingBound closing_bound(const MovingShape& A, const MovingShape& B, double t, double t_end);

}  // namespace rigor
