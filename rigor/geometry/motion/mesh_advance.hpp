#pragma once

#include "rigor/geometry/motion/time_of_contact.hpp"

#include <span>

namespace rigor {

/// The state from which a mesh and another shape are advanced, and the tolerances of the advance.
struct MeshAdvance {
  double t = 0, t_end = 0;      ///< The span [s].
  double distance = 0;          ///< Between the surfaces at t [m]; 0 or less where they meet.
  double touch = 0;             ///< Distances up to this cannot be told from contact [m].
  double slack = 0;             ///< Allowed overlap of parts that touch without approaching [m].
  double rest_velocity = 0;     ///< A pair approaches if its gap rate is below minus this [m/s].
  std::span<const Vec3> n_W{};  ///< Normals of the contacts at t, from A to B.
};

/// The time for which a moving mesh A and a second mesh, or a bounded convex shape B, can be advanced from t
/// without a new overlap [s]; at most t_end - t.
///
/// Pairs of triangles (or of a triangle and the convex shape) that are farther apart than all points can
/// travel are safe. Every other pair is safe as long as one direction separates it (SeparationBound, of
/// second order); the directions tried are that of the nearest points, the normals of the two triangles and
/// the normals of the contacts. Triangles that slide along each other are separated by the normal of the
/// contact, so sliding and rolling do not force small steps. Pairs that touch at t must not be approaching:
/// the caller has examined the contacts.
double safe_mesh_step(const MovingShape& A, const MovingShape& B, const MeshAdvance& from);

/// Upper bound of the speed at which points of A and B approach each other: its value at t, `speed` [m/s],
/// and its rate of growth until t_end, `acceleration` [m/s²].
struct ClosingBound {
  double speed;
  double acceleration;

  /// The time within which no point comes nearer by more than the distance [s].
  double time_for(double distance) const;
};
ClosingBound closing_bound(const MovingShape& A, const MovingShape& B, double t, double t_end);

}  // namespace rigor
