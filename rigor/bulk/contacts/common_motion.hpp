#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/model/model.hpp"

#include <span>

namespace rigor {

/// The motion of a rigid body.
struct CommonMotion {
  Vec3 center = Vec3::Zero();               ///< Whose velocity V is [m].
  Vec3 V = Vec3::Zero(), W = Vec3::Zero();  ///< [m/s], [rad/s].
  Vec3 velocity_at(const Vec3& p) const { return V + W.cross(p - center); }
};

/// Between two steps, the motion of dynamic bodies if they moved as one rigid body with their momenta, M V =
/// P and I W = L about their centre of mass.
CommonMotion common_motion(const Model& model, std::span<const int> group, const BulkBodies& bodies);

/// Leaves the bodies this part of their motion against `common`.
void keep_part_of_motion(const Model& model, std::span<const int> group, const CommonMotion& common,
                         double part, BulkBodies& bodies);

}  // namespace rigor
