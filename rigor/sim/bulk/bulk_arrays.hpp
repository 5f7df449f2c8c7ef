#pragma once

#include "rigor/bulk/state/bulk_contact.hpp"
#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

struct BulkBodies;

/// All bodies of a BulkSimulation in arrays, a row a place; rows of places without a body are 0.
struct BodyArrays {
  std::vector<char> is_there;            ///< 1 or 0.
  std::vector<double> position;          ///< 3 a place: of the user's frame [m].
  std::vector<double> orientation;       ///< 4: its quaternion w x y z.
  std::vector<double> velocity;          ///< 3: of the centre of mass [m/s].
  std::vector<double> angular_velocity;  ///< 3 [rad/s].
};

/// The contacts of a step in arrays, a row a point, in the order of bodies.
struct ContactArrays {
  std::vector<int> body_A, body_B;  ///< Places, body_A < body_B.
  std::vector<double> point;        ///< 3: at the beginning of the step [m].
  std::vector<double> normal;       ///< 3: unit, from A to B.
  std::vector<double> force;        ///< 3: mean force on B in the step, normal and friction [N].
  std::vector<double> gap;          ///< 1: at the beginning of the step [m], negative when overlapping.
};

/// What contacts have done to each body in a step, a row a place.
struct ContactLoads {
  std::vector<double> force;   ///< 3: mean force in the step [N].
  std::vector<double> torque;  ///< 3: about the centre of mass at its beginning [N m].
};

/// Friction, which acts in the middle of a contact, is shared among its points as they press.
ContactArrays contact_arrays(const std::vector<BulkContact>& contacts, double step);
/// centers: of the bodies at the beginning of the step [m], by place.
ContactLoads contact_loads(const std::vector<BulkContact>& contacts, const std::vector<Vec3>& centers,
                           double step);

}  // namespace rigor
