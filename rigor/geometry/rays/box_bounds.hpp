#pragma once

#include "rigor/geometry/rays/ray_cast.hpp"
#include "rigor/geometry/shape/aabb.hpp"

namespace rigor {

/// No shapes inside the boxes have a smaller signed distance [m]: the distance of the boxes, or minus the
/// least way that takes them apart.
double signed_distance_bound(const Aabb& a, const Aabb& b);

/// No shape inside the box is met by the ray at a smaller fraction; infinity if none is met at all.
double ray_bound(const Aabb& box, const Ray& ray);

}  // namespace rigor
