#pragma once

#include "rigor/geometry/rays/ray_cast.hpp"
#include "rigor/geometry/shape/aabb.hpp"

namespace rigor {

/// Lower bound of the signed distance of shapes inside the boxes [m]: the distance of the boxes or, if they
/// overlap, minus the length of the shortest translation that separates them.
double signed_distance_bound(const Aabb& a, const Aabb& b);

/// Lower bound of the fraction at which the ray meets a shape inside the box; infinity if it cannot meet one.
double ray_bound(const Aabb& box, const Ray& ray);

}  // namespace rigor
