#pragma once

#include "rigor/geometry/convex/penetration.hpp"

#include <optional>

namespace rigor {

/// Penetration of an ellipsoid and another one, a point or a segment, with a proof in closed form that no
/// direction is better; nothing for other cores, where they do not overlap, where Newton's method from
/// `start` leads to no maximum, or where the proof does not hold.
///
/// About the maximum n of s the sum of two ellipsoids holds a third one that touches it there,
///   h(m) = |A m| + |B m| ≥ |(A + S B) m| for any rotation S, with equality at n if S turns B n into A n
/// up to length. A ball inside that one parts no sooner, and whether it lies inside is a question of one
/// eigenvalue: docs/theory/distance.md. Of a segment the witness takes the place of the second ellipsoid.
std::optional<Penetration> find_ellipsoid_penetration(const CorePair& pair, const Vec3& start);

}  // namespace rigor
