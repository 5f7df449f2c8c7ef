#pragma once

#include "rigor/geometry/convex/penetration.hpp"

#include <optional>

namespace rigor {

/// Penetration of two solids of revolution (rings or segments) whose axes are parallel to within the accuracy
/// of curved shapes, in closed form. Nothing for other cores, where the cores do not overlap, or where the
/// witnesses do not come out exact.
///
/// Seen at the angle θ from the axis, both support values are those of the profiles, and of all directions at
/// that angle the one against the offset ρ of the axes is the worst: the depth is the minimum over θ of
///   F(θ) = max_i (r_i sin θ - z_i cos θ) + max_j (r_j sin θ + z_j cos θ) + p_z cos θ - ρ sin θ,
/// the support value of a convex polygon, which is least along the axis or square to a side of one of the
/// profiles. An expanding polytope would have to follow the circle of directions that are all as good.
/// Axes that differ by the angle α change it by no more than α times the extent of B.
std::optional<Penetration> find_parallel_penetration(const CorePair& pair, const Vec3& start);

}  // namespace rigor
