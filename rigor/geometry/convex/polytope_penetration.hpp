#pragma once

#include "rigor/geometry/convex/gauss_map.hpp"
#include "rigor/geometry/convex/inner_polytope.hpp"
#include "rigor/geometry/convex/penetration.hpp"

#include <optional>

namespace rigor {

/// The signed distance of two overlapping or touching polytopes: minus their depth.
struct PolytopePenetration {
  GaussPoint best;  ///< The direction that separates them, and its face of the difference.
  double upper;     ///< No direction has a larger separation, rounding apart [m].
};

/// Global maximum of the separation over all directions, for polytopes that overlap or touch. Climbs the
/// Gauss map from `start` to a local maximum, then grows a polytope inside the difference until its lowest
/// facet proves that no direction is better; from a better one met on the way the climb continues. So the
/// answer is never merely a local maximum. For two boxes all candidate directions are tried instead. Nothing
/// if the bodies are apart and nearest neither at a face nor at two edges, or if the proof fails by rounding
/// or by its size (very round and deep pairs): another method has to answer then.
///
/// Faces that touch to rounding may be coplanar with others. Then best.is_maximum is false and upper is
/// infinite: it has to come from witness points.
///
/// `proof` is the start of the proof if it holds an earlier one, and receives the new one. The depth does not
/// depend on it beyond rounding; which of several equally short translations out of the overlap is returned
/// may depend on `start`.
std::optional<PolytopePenetration> find_polytope_penetration(const PolytopePair& pair,
                                                             const FeaturePair& start, double rounding,
                                                             CachedProof& proof);

/// The same for two cores with flat faces (boxes and hulls) that overlap or touch, starting from direction n,
/// with witness points in every case. Nothing for all other cores.
std::optional<Penetration> find_polytope_penetration(const CorePair& pair, const Vec3& n);

}  // namespace rigor
