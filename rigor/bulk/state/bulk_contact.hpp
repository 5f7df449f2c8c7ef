#pragma once

#include "rigor/core/index.hpp"
#include "rigor/math/types.hpp"
#include "rigor/model/contact_key.hpp"
#include "rigor/model/manifold_memory.hpp"

#include <array>

namespace rigor {

/// Where two shapes touched, or nearly did, in a step, and what acted between them: the impulses of the whole
/// step.
struct BulkContact {
  struct Point {
    Vec3 p_W;               ///< Place at the beginning of the step [m].
    double gap;             ///< Gap at the beginning of the step [m], negative when overlapping.
    double normal_impulse;  ///< [N s], >= 0.
  };
  int body_A = -1, body_B = -1;    ///< Model indices, body_A < body_B.
  int shape_A = -1, shape_B = -1;  ///< Indices among the shapes of these bodies.
  int part = 0;                    ///< Which manifold, for shapes with several (meshes).
  Vec3 n_W;                        ///< Unit normal from A to B.
  int point_count = 0;
  std::array<Point, ManifoldMemory::max_points> points;
  Vec3 center_W;            ///< The middle of the points, where friction acts [m].
  Vec3 friction_impulse_W;  ///< Impulse of friction on B [N s].
  Vec3 friction_moment_W;   ///< Angular impulse of torsional and rolling friction on B [N m s].
  double approach_speed;    ///< Of the fastest pressed point, at the beginning of the step [m/s], >= 0.
  bool is_new;              ///< Whether it did not press at the end of the step before.

  double normal_impulse() const;  ///< Sum over all points [N s].
  /// Impulse on B, normal and friction [N s].
  Vec3 impulse_W() const { return normal_impulse() * n_W + friction_impulse_W; }
  ContactKey key() const { return {body_A, body_B, shape_A, shape_B, at(part)}; }
};

}  // namespace rigor
