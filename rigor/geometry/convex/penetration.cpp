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

/// Expansions before the search gives up and returns the bounds it has: for polytopes a guard that nothing
/// known reaches; concentric balls (as ellipsoids) reach the other, for all their directions are equally
/// good.
constexpr int kMaxExpansions = 4000;
constexpr int kMaxCurvedExpansions = 400;
/// Enclosure of the depth of curved shapes, relative to the depth or the smaller core.
constexpr double kCurvedTolerance = 1e-6;
/// Where Newton's method finds no maximum at that enclosure, it is made this much smaller.
constexpr double kTighter = 1e-2;
/// Newton's method starts at a facet whose gap to the boundary is this small, relative to the same length.
constexpr double kPolishGap = 1e-2;
/// Directions closer than this (cosine) to one that was polished are taken to lead to the same maximum, until
/// a facet ends the search.
constexpr double kSameMaximum = 0.95;

/// A local maximum of s and the cap of directions about it in which there is no better one.
struct Maximum {
  Vec3 n;
  double cosine;  ///< Of the cap's half angle; 1: no cap is known.
};

class Search {
 public:
  Search(const CorePair& pair, const Penetration& touching)
      : pair_(pair), result_(touching), is_polytope_(is_polytope(pair.a) && is_polytope(pair.b)) {}

  Penetration run(std::span<const DifferencePoint> simplex) {
    ExpandingPolytope polytope(pair_, result_.best.n, simplex);
    if (polytope.is_flat()) {
      try_direction(polytope.flat_normal());
      try_direction(-polytope.flat_normal());
      finish();
    } else {
      if (!is_polytope_) polish_first();
      expand(polytope);
    }
    return result_;
  }

 private:
  /// Are the witnesses s(n) n apart? Then n is a local maximum.
  bool is_exact(const Separation& s) const { return (s.b - s.a - s.value * s.n).norm() <= pair_.rounding; }
  bool is_exact() const { return is_exact(result_.best); }

  /// The length that the enclosure is relative to [m].
  double resolution() const {
    const double smaller = std::min(pair_.a.extent, pair_.b.extent);
    return std::isfinite(result_.best.value) ? std::max(smaller, std::abs(result_.best.value)) : smaller;
  }

  void expand(ExpandingPolytope& polytope) {
    double relative_tolerance = is_polytope_ ? 0 : kCurvedTolerance;
    const int limit = is_polytope_ ? kMaxExpansions : kMaxCurvedExpansions;
    for (int i = 0; i < limit; ++i) {
      const std::optional<int> lowest = lowest_open_facet(polytope);
      if (!lowest) {
        result_.upper = std::min(result_.upper, result_.best.value);
        finish();
        return;
      }
      const ExpandingPolytope::Facet facet = polytope.facet(*lowest);
      if (facet.height >= 0) result_.upper = std::min(result_.upper, -facet.height);
      const double tolerance = std::max(relative_tolerance * resolution(), pair_.rounding);
      if (-facet.height - result_.best.value <= tolerance) {
        if (finish(polytope, *lowest) || tolerance == pair_.rounding) return;
        relative_tolerance *= kTighter;
      }

      const DifferencePoint p = pair_.lowest(-facet.m, &polytope.point(facet.v[0]));
      const double separation = -facet.m.dot(p.w);
      if (separation >= result_.best.value) take_facet(polytope, *lowest, separation);
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

  /// The lowest facet that is not seen from the origin within a cap where the maximum is known.
  std::optional<int> lowest_open_facet(ExpandingPolytope& polytope) const {
    for (;;) {
      const std::optional<int> lowest = polytope.lowest_facet(-result_.best.value);
      if (!lowest || !is_in_a_cap(polytope, *lowest)) return lowest;
      polytope.set_aside(*lowest);
    }
  }

  bool is_near_a_maximum(const Vec3& n) const {
    return std::any_of(maxima_.begin(), maxima_.end(), [&](const Maximum& maximum) {
      return maximum.n.dot(n) > std::min(maximum.cosine, kSameMaximum);
    });
  }

  /// The cones of the facets cover all directions once the origin is inside, where all heights are positive.
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

  /// Makes the best direction and its witnesses exact; false if they are not yet.
  bool finish(const ExpandingPolytope& polytope, int facet) {
    if (!is_exact()) polish(polytope, facet);
    return finish();
  }

  bool finish() {
    snap_to_faces();
    if (!is_exact()) result_.best = with_level_witnesses(pair_, result_.best);
    return is_exact();
  }

  SimplexPoint nearest_on_facet(const std::array<DifferencePoint, 3>& corners) const {
    return nearest_on_triangle({corners[0].w, corners[1].w, corners[2].w, Vec3::Zero()}, 0, 1, 2);
  }

  /// The witnesses are the points of the facet nearest to the origin.
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

  /// From the direction that the search for the nearest points ended with: the sooner a maximum is known, the
  /// fewer facets are in question.
  void polish_first() {
    const std::array<DifferencePoint, 1> lowest{pair_.lowest(result_.best.n)};
    const std::array<double, 1> weights{1};
    take_polished(polish_separation(pair_, result_.best.n, {lowest, weights}));
  }

  void take_polished(const std::optional<Separation>& polished) {
    if (!polished) return;
    if (is_exact(*polished)) maxima_.push_back({polished->n, cap_cosine(pair_, *polished)});
    if (polished->value >= result_.best.value) result_.best = *polished;
  }

  /// Keeps the witnesses: they are level along any direction that is as good.
  void try_direction(const Vec3& n) {
    if (n.squaredNorm() == 0) return;
    const double value = n.dot(pair_.lowest(n).w);
    if (value < result_.best.value - pair_.rounding) return;
    result_.best.n = n;
    result_.best.value = std::max(value, result_.best.value);
  }

  /// A face's own normal is the best name of a direction that is as good to rounding.
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
