#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace rigor {

/// Velocity of the point of B at p_W against the point of A there [m/s].
using PointVelocity = std::function<Vec3(const Vec3& p_W)>;

/// The contacts of two convex shapes that touch, along the direction in which they part fastest.
///
/// Shapes that meet at an edge or a corner of both are kept apart by many directions, and one in which they
/// do not approach is enough: what slides over the seam of two floors of one height meets the edge of the
/// second one, but does not strike its side. The nearest points do not know that. `found` is their contact
/// set; the result is that of the face, of either shape, along whose normal the shapes overlap by no more
/// than half the tolerance [m] and approach slowest; nothing if no face is better than `found`, and for
/// meshes, half-spaces and cavities.
std::optional<std::vector<ContactPoint>> parting_contacts(const Shape& a, const Pose& X_WA, const Shape& b,
                                                          const Pose& X_WB, double tolerance,
                                                          const std::vector<ContactPoint>& found,
                                                          const PointVelocity& velocity);

}  // namespace rigor
