#pragma once

#include "rigor/geometry/convex/gauss_map.hpp"
#include "rigor/geometry/convex/inner_polytope.hpp"
#include "rigor/geometry/convex/penetration.hpp"

#include <optional>

namespace rigor {

/// The signed distance of two overlapping or touching polytopes: minus their depth.
struct PolytopePenetration {
  GaussPoint best;  ///< The direction, and the face of the difference, that part them.
  double upper;     ///< No direction has a larger separation, rounding apart [m].
};

/// Global maximum of the separation over all directions, for polytopes that overlap or touch: climbs the
/// Gauss map from `start` to a local maximum, then grows a polytope inside the difference until its lowest
/// facet proves that no direction is better; a better one met on the way is climbed from in turn. So the
/// answer is never a local maximum only. Two boxes try all directions there are instead. Nothing if the
/// bodies are apart and not nearest at a face or two edges, or if rounding or the size of the proof is in the
/// way (very round and deep pairs): to be answered by another method.
///
/// Faces that touch to rounding may be coplanar with others: then best.is_maximum is false, and upper, which
/// the witness points have to tell, infinite.
///
/// `proof` is where the proof begins if it holds one of before, and where it is left. The depth does not
/// depend on it beyond rounding; which of several equally short ways out is returned may depend on `start`.
std::optional<PolytopePenetration> find_polytope_penetration(const PolytopePair& pair,
                                                             const FeaturePair& start, double rounding,
                                                             CachedProof& proof);

/// The same for two cores with flat faces (boxes and hulls) that overlap or touch, from direction n, with
/// witness points in every case. Nothing for all others.
std::optional<Penetration> find_polytope_penetration(const CorePair& pair, const Vec3& n);

}  // namespace rigor
