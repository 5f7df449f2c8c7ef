#pragma once

#include "rigor/geometry/convex/penetration.hpp"

#include <optional>

namespace rigor {

/// Penetration of an ellipsoid and a second ellipsoid, a point or a segment, with a proof in closed form that
/// no direction is better. Nothing for other cores, where the cores do not overlap, where Newton's method
/// from `start` does not lead to a maximum, or where the proof fails.
///
/// At the maximum n of s, the sum of two ellipsoids holds a third one that touches it there,
/// h(m) = |A m| + |B m| ≥ |(A + S B) m| for any rotation S,
/// with equality at n if S takes B n to A n up to length. If the ball whose radius is the depth lies inside
/// that ellipsoid, no direction separates the bodies by a shorter translation, and whether it does is a
/// question of one eigenvalue: docs/theory/distance.md. Against a segment or a point, the witness takes the
/// place of the second ellipsoid.
std::optional<Penetration> find_ellipsoid_penetration(const CorePair& pair, const Vec3& start);

}  // namespace rigor
