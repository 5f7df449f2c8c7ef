#pragma once

#include "rigor/model/model.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The properties of a model that can change while its bodies stay as they are.
struct ModelChanges {
  Vec3 g_W = Vec3::Zero();  ///< Gravity [m/s²].
  struct Surface {
    double friction;     ///< Coulomb μ, ≥ 0.
    double restitution;  ///< e in [0, 1].
    bool operator==(const Surface&) const = default;
  };
  std::vector<Surface> surfaces;    ///< One per material. Pairs with coefficients of their own keep them.
  std::vector<Force> added_forces;  ///< Besides the model's own.

  /// Laws along a coordinate of a joint, in place of the model's own and of its drives; its limits stay.
  struct Axis {
    int joint, coordinate;  ///< Of the model.
    JointAxis laws;
    std::optional<JointDrive> drive;  ///< A motor besides; it is checked.
  };
  std::vector<Axis> axes;
  /// Where a kinematic body goes, in place of the model's own velocities and path.
  struct KinematicMotion {
    int body;
    Vec3 p_WB;  ///< At t = 0, as in Body [m].
    Quat q_WB;
    Vec3 v_WB, w_WB;  ///< [m/s], [rad/s].
    std::vector<PathPoint> path;
  };
  std::vector<KinematicMotion> kinematic_motions;
  bool ends_drives = false;  ///< The changed model has none.
};

/// No change: the gravity and the surfaces of the model.
ModelChanges unchanged(const Model& model);

/// Throws InputError if changed_model() refused these laws for that coordinate.
void check_change(const Model& model, const ModelChanges::Axis& change);
/// The model with these changes; the bodies, and so the States that belong to it, are the same. Throws
/// InputError if a value is outside its limits. added_forces and kinematic_motions are not checked.
std::shared_ptr<const Model> changed_model(const Model& model, const ModelChanges& changes);

}  // namespace rigor
