#include "rigor/geometry/convex/penetration.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/expanding_polytope.hpp"
#include "rigor/geometry/convex/level_face.hpp"
#include "rigor/geometry/convex/maximum_cap.hpp"
#include "rigor/geometry/convex/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigor {
namespace {

/// Expansions before the search gives up and returns the bounds it has. For polytopes the limit is a guard
/// that no known pair reaches. Curved shapes can reach theirs: two concentric balls (as ellipsoids) do,
/// because all their directions are equally good.
constexpr int kMaxExpansions = 4000;
constexpr int kMaxCurvedExpansions = 400;
/// Gap between the two bounds of the depth of curved shapes at which the search ends, relative to the depth
/// or the extent of the smaller core.
constexpr double kCurvedTolerance = 1e-6;
/// Factor by which that gap is reduced where Newton's method finds no maximum at it.
constexpr double kTighter = 1e-2;
/// Newton's method starts from a facet whose gap to the boundary of the difference is this small, relative to
/// the same length.
constexpr double kPolishGap = 1e-2;
/// Directions within this cosine of one that was already polished are assumed to lead to the same maximum,
/// until a facet ends the search.
constexpr double kSameMaximum = 0.95;

/// A local maximum of s and the cap of directions about it in which no direction is better.
struct Maximum {
  Vec3 n;
  double cosine;  ///< Of the cap's half angle; 1: no cap is known.
};

class Search {
 public:
  Search(const CorePair& pair, const Penetration& touching)
      : pair_(pair), result_(touching), is_polytope_(is_polytope(pair.a) && is_polytope(pair.b)) {}

  Penetration run(std::span<const DifferencePoint> simplex) {
    // A difference without volume has no facets: along its flat normal, in one sense or the other, the
    // separation is already the largest.
    ExpandingPolytope polytope(pair_, result_.best.n, simplex);
    if (polytope.is_flat()) {
      try_direction(polytope.flat_normal());
      try_direction(-polytope.flat_normal());
      finish();
    } else {
      // A curved maximum found early proves caps of directions, whose facets need no expansion.
      if (!is_polytope_) polish_first();
      expand(polytope);
    }
    return result_;
  }

 private:
  /// Whether the witnesses are s(n) n apart. If so, n is a local maximum of s.
  bool is_exact(const Separation& s) const { return (s.b - s.a - s.value * s.n).norm() <= pair_.rounding; }
  bool is_exact() const { return is_exact(result_.best); }

  /// The length that the tolerances are relative to [m]: the depth, or the extent of the smaller core.
  double resolution() const {
    const double smaller = std::min(pair_.a.extent, pair_.b.extent);
    return std::isfinite(result_.best.value) ? std::max(smaller, std::abs(result_.best.value)) : smaller;
  }

  /// Expands the polytope at its lowest facet until minus the height of that facet, an upper bound of the
  /// signed distance, meets the best separation known, a lower bound.
  void expand(ExpandingPolytope& polytope) {
    double relative_tolerance = is_polytope_ ? 0 : kCurvedTolerance;
    const int limit = is_polytope_ ? kMaxExpansions : kMaxCurvedExpansions;
    for (int i = 0; i < limit; ++i) {
      // Where no facet is lower than the best depth known, the best maximum is the global one.
      const std::optional<int> lowest = lowest_open_facet(polytope);
      if (!lowest) {
        result_.upper = std::min(result_.upper, result_.best.value);
        finish();
        return;
      }
      // Upper bound: the ball inscribed about the origin up to the lowest facet lies inside the difference.
      // It counts once the origin is inside, where all heights are positive.
      const ExpandingPolytope::Facet facet = polytope.facet(*lowest);
      if (facet.height >= 0) result_.upper = std::min(result_.upper, -facet.height);
      // The bounds have met. For curved shapes the witnesses must be exact as well; where Newton's method
      // does not make them so, the search continues with a smaller tolerance.
      const double tolerance = std::max(relative_tolerance * resolution(), pair_.rounding);
      if (-facet.height - result_.best.value <= tolerance) {
        if (finish(polytope, *lowest) || tolerance == pair_.rounding) return;
        relative_tolerance *= kTighter;
      }

      // Lower bound: the support point over the lowest facet gives the separation along its normal.
      const DifferencePoint p = pair_.lowest(-facet.m, &polytope.point(facet.v[0]));
      const double separation = -facet.m.dot(p.w);
      if (separation >= result_.best.value) take_facet(polytope, *lowest, separation);
      // Near the boundary the facet's normal is a good start for Newton's method. On the boundary to rounding
      // the facet cannot rise; otherwise the polytope takes in the support point.
      const double gap = -facet.height - separation;
      if (!is_polytope_ && gap < kPolishGap * resolution() && !is_near_a_maximum(-facet.m)) {
        polish(polytope, *lowest);
      }
      if (gap <= pair_.rounding || !polytope.expand(*lowest, p)) {
        finish(polytope, *lowest);
        return;
      }
    }
    finish();
  }

  /// The lowest facet that is not seen from the origin within the cap of a maximum. Facets within a cap are
  /// set aside: every direction of their cones is proved to be no better.
  std::optional<int> lowest_open_facet(ExpandingPolytope& polytope) const {
    for (;;) {
      const std::optional<int> lowest = polytope.lowest_facet(-result_.best.value);
      if (!lowest || !is_in_a_cap(polytope, *lowest)) return lowest;
      polytope.set_aside(*lowest);
    }
  }

  /// Whether n is likely to lead Newton's method to a maximum that is already known.
  bool is_near_a_maximum(const Vec3& n) const {
    return std::any_of(maxima_.begin(), maxima_.end(), [&](const Maximum& maximum) {
      return maximum.n.dot(n) > std::min(maximum.cosine, kSameMaximum);
    });
  }

  /// Whether all corners of facet i are seen from the origin within one cap, and with them every direction of
  /// its cone. The cones cover all directions only once the origin is inside, where heights are positive.
  bool is_in_a_cap(const ExpandingPolytope& polytope, int i) const {
    const ExpandingPolytope::Facet& facet = polytope.facet(i);
    return std::any_of(maxima_.begin(), maxima_.end(), [&](const Maximum& maximum) {
      if (maximum.cosine == -1) return true;
      return maximum.cosine < 1 && facet.height > 0 &&
             std::all_of(facet.v.begin(), facet.v.end(), [&](int v) {
               const Vec3& w = polytope.point(v).w;
               return -maximum.n.dot(w) >= maximum.cosine * w.norm();
             });
    });
  }

  /// Makes the best direction and its witnesses exact; false if they could not be made so.
  bool finish(const ExpandingPolytope& polytope, int facet) {
    if (!is_exact()) polish(polytope, facet);
    return finish();
  }

  /// The same without a facet to polish from. Parallel faces have many nearest pairs: where the witnesses are
  /// not along n, they are taken from the faces that are level along it.
  bool finish() {
    snap_to_faces();
    if (!is_exact()) result_.best = with_level_witnesses(pair_, result_.best);
    return is_exact();
  }

  SimplexPoint nearest_on_facet(const std::array<DifferencePoint, 3>& corners) const {
    return nearest_on_triangle({corners[0].w, corners[1].w, corners[2].w, Vec3::Zero()}, 0, 1, 2);
  }

  /// Takes the facet's normal as the best direction. Its witnesses are the points of A and B behind the
  /// facet's point nearest to the origin, with the same barycentric weights.
  void take_facet(const ExpandingPolytope& polytope, int i, double separation) {
    const std::array<DifferencePoint, 3> corners = polytope.corners(i);
    const SimplexPoint nearest = nearest_on_facet(corners);
    result_.best = {-polytope.facet(i).m, separation, Vec3::Zero(), Vec3::Zero()};
    for (int k = 0; k < nearest.count; ++k) {
      const DifferencePoint& corner = corners[at(nearest.index[at(k)])];
      result_.best.a += nearest.weight[at(k)] * corner.a;
      result_.best.b += nearest.weight[at(k)] * corner.b;
    }
  }

  /// Newton's method from the normal of facet i. The pieces of the cores that its nearest point combines,
  /// with their weights, are those that should meet at the maximum.
  void polish(const ExpandingPolytope& polytope, int i) {
    const Vec3 n = -polytope.facet(i).m;
    const std::array<DifferencePoint, 3> corners = polytope.corners(i);
    const SimplexPoint nearest = nearest_on_facet(corners);
    std::array<double, 3> weights{};
    for (int k = 0; k < nearest.count; ++k) {
      weights[at(nearest.index[at(k)])] = nearest.weight[at(k)];
    }
    take_polished(polish_separation(pair_, n, {corners, weights}));
  }

  /// Newton's method from the direction with which GJK ended: the sooner a maximum is known, the fewer facets
  /// need to be looked at.
  void polish_first() {
    const std::array<DifferencePoint, 1> lowest{pair_.lowest(result_.best.n)};
    const std::array<double, 1> weights{1};
    take_polished(polish_separation(pair_, result_.best.n, {lowest, weights}));
  }

  /// Records a maximum and its cap if it is exact, and makes it the best if it is no worse.
  void take_polished(const std::optional<Separation>& polished) {
    if (!polished) return;
    if (is_exact(*polished)) maxima_.push_back({polished->n, cap_cosine(pair_, *polished)});
    if (polished->value >= result_.best.value) result_.best = *polished;
  }

  /// Makes n the best direction if it is as good to rounding. The witnesses stay: those of one maximum are
  /// level along every direction that is as good.
  void try_direction(const Vec3& n) {
    if (n.squaredNorm() == 0) return;
    const double value = n.dot(pair_.lowest(n).w);
    if (value < result_.best.value - pair_.rounding) return;
    result_.best.n = n;
    result_.best.value = std::max(value, result_.best.value);
  }

  /// Replaces the best direction by the normal of a face where that is as good to rounding: it carries no
  /// error of the search, and does not vary from step to step. A's face is tried last and so preferred.
  void snap_to_faces() {
    const Mat3& R = pair_.X_AB.R;
    try_direction(-(R * nearest_face_normal(pair_.b, R.transpose() * -result_.best.n)));
    try_direction(nearest_face_normal(pair_.a, result_.best.n));
  }

  const CorePair& pair_;
  Penetration result_;
  bool is_polytope_;
  std::vector<Maximum> maxima_;
};

}  // namespace

Penetration find_penetration(const CorePair& pair, const Penetration& touching,
                             std::span<const DifferencePoint> simplex) {
  return Search(pair, touching).run(simplex);
}

}  // namespace rigor
