#pragma once

#include "rigor/math/pose.hpp"
#include "rigor/model/body_shapes.hpp"

#include <span>

namespace rigor {

/// A shape along its path: its body moves straight and turns about one axis.
struct ShapePath {
  const BodyShape* shape;
  Pose X_WB;         ///< At the beginning.
  Vec3 dp_W, dr_W;   ///< Displacement [m] and rotation vector [rad] of the body.
  double turning;    ///< How far from the centre of the body a rotation moves points [m].
  double thickness;  ///< thickness_of() [m].
};

/// How far two shapes can go.
struct FreePath {
  double part;  ///< Of their paths, or how many of their segments.
  /// Whether they did at the beginning already; found only where they cannot go all of it.
  bool overlap = false;
};

/// The part of their paths, at most 1, that two shapes can go until they overlap by `deep_share` of the
/// thinner one's thickness; shapes that overlap by more at the beginning may do so by a hundredth more. The
/// path is proven free, or seen at distances that no shape skips. likely_W: a unit vector from A to B along
/// which they are likely to be apart, or zero; it saves time only.
///
/// Source of the steps: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, 1996, ch. 2.
FreePath free_path(const ShapePath& A, const ShapePath& B, double deep_share,
                   const Vec3& likely_W = Vec3::Zero());

/// A stretch of the paths of two shapes, both straight.
struct PathSegment {
  ShapePath A, B;
};
/// How many of the segments, one after the other, two shapes can go so; the last one in part.
FreePath free_segments(std::span<const PathSegment> segments, double deep_share,
                       const Vec3& likely_W = Vec3::Zero());

}  // namespace rigor
