#pragma once

#include "rigor/geometry/decomposition/lipschitz_maximum.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/convex_polygon.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <span>

namespace rigor {

/// Bounds of the largest distance of a point of the hull from the solid inside the closed mesh [m]: how far
/// the hull extends beyond the solid, its concavity. `place` is the farthest point met. Where only points in
/// front of one of some planes can be outside the solid, `in_front_of` confines the search to them.
MaximumBounds hull_excess(const ConvexHull& hull, const Mesh& mesh, const WindingNumber& winding,
                          const MaximumGoal& goal, std::span<const CutPlane> in_front_of = {});

/// Volume of a hull [m³].
double hull_volume(const ConvexHull& hull);

}  // namespace rigor
