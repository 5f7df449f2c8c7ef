#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace rigor {

/// A half-line or a segment in W. A point on it is given by its fraction: origin_W + fraction · direction_W.
struct Ray {
  Vec3 origin_W;     ///< [m].
  Vec3 direction_W;  ///< Of any length > 0 [m].
  /// Fraction at which the ray ends, ≥ 0. With the direction q - p from the origin p, 1 makes it the segment
  /// from p to q.
  double max_fraction = std::numeric_limits<double>::infinity();

  /// The point at this share of the ray [m].
  Vec3 at(double fraction) const { return origin_W + fraction * direction_W; }
};

/// A point where a ray crosses the surface of a shape.
struct RayHit {
  double fraction = 0;      ///< In [0, max_fraction].
  Vec3 p_W = Vec3::Zero();  ///< The point [m].
  Vec3 n_W = Vec3::Zero();  ///< Outward unit normal of the surface there.
  bool enters = true;       ///< Whether the ray enters the shape there; false where it leaves.
  int triangle = -1;        ///< Index of the triangle of a mesh; -1 for all other shapes.
};

/// All points where the ray crosses the surface, in the order of their fractions. The first hit of a ray that
/// begins inside the shape is thus where it leaves. Convex shapes have at most two hits. Whether a ray that
/// begins on the surface crosses it there is left to rounding.
///
/// Shapes with curved surfaces have closed forms; polyhedra are clipped face by face. A mesh is watertight:
/// no ray passes between two neighbouring triangles or hits both, not even through an edge or a vertex (the
/// triangles are projected along the ray and the decision is exact).
///
/// Sources: Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, Computers & Graphics 3(1), 1978;
/// Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, J. Computer Graphics Techniques 2(1), 2013
/// (here with exact signs in place of a second try in double).
std::vector<RayHit> find_ray_hits(const Shape& shape, const Pose& X_WS, const Ray& ray);

/// The first of these hits, or nothing. For a mesh this is cheaper than finding all of them.
std::optional<RayHit> find_ray_hit(const Shape& shape, const Pose& X_WS, const Ray& ray);

}  // namespace rigor
