// The truth that rigor_convex_bench measures errors against, in long double and without the library's code.

#include "convex_bench.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/revolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace rigor::bench {
namespace {

using Real = long double;
using Vec3L = Eigen::Matrix<Real, 3, 1>;
using Mat3L = Eigen::Matrix<Real, 3, 3>;

struct SupportOf {
  const Vec3L& d;

  Vec3L ball(Real radius) const { return radius / d.norm() * d; }
  Vec3L signs(const Vec3L& h) const {
    return {d.x() < 0 ? -h.x() : h.x(), d.y() < 0 ? -h.y() : h.y(), d.z() < 0 ? -h.z() : h.z()};
  }
  Vec3L rim(Real radius, Real z) const {
    const Real length = std::sqrt(d.x() * d.x() + d.y() * d.y());
    if (length == 0) return {radius, 0, z};
    return {radius * d.x() / length, radius * d.y() / length, z};
  }

  Vec3L operator()(const Sphere& s) const { return ball(s.radius); }
  Vec3L operator()(const Box& s) const { return signs(s.half_extents.cast<Real>()); }
  Vec3L operator()(const Capsule& s) const {
    const Vec3L end = signs(Vec3L(0, 0, s.half_length));
    return end + ball(s.radius);
  }
  Vec3L operator()(const Cylinder& s) const {
    return rim(s.radius, d.z() < 0 ? -s.half_length : s.half_length);
  }
  Vec3L operator()(const Cone& s) const {
    const Vec3L base = rim(s.radius, -s.half_length);
    const Vec3L apex(0, 0, s.half_length);
    return d.dot(apex) > d.dot(base) ? apex : base;
  }
  Vec3L operator()(const Revolution& s) const {
    Vec3L best = rim(s.rings->front().radius, s.rings->front().z);
    for (const Ring& ring : *s.rings) {
      const Vec3L p = rim(ring.radius, ring.z);
      if (d.dot(p) > d.dot(best)) best = p;
    }
    return best;
  }
  Vec3L operator()(const Ellipsoid& s) const {
    const Vec3L radii = s.radii.cast<Real>();
    const Vec3L stretched = radii.cwiseProduct(d);
    return radii.cwiseProduct(stretched) / stretched.norm();
  }
  Vec3L operator()(const Convex& s) const {
    Vec3L best = s.hull->vertices[0].cast<Real>();
    Real height = d.dot(best);
    for (const Vec3& v : s.hull->vertices) {
      const Vec3L p = v.cast<Real>();
      if (d.dot(p) <= height) continue;
      best = p;
      height = d.dot(p);
    }
    return best;
  }
  Vec3L operator()(const HalfSpace&) const { return Vec3L::Zero(); }
  Vec3L operator()(const Cavity&) const { return Vec3L::Zero(); }
  Vec3L operator()(const Mesh&) const { return Vec3L::Zero(); }
};

/// The difference B - A, in the world.
class Difference {
 public:
  Difference(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB)
      : a_(a), b_(b), R_WA_(X_WA.R.cast<Real>()), R_WB_(X_WB.R.cast<Real>()) {
    p_AB_ = X_WB.p.cast<Real>() - X_WA.p.cast<Real>();
  }
  Vec3L lowest(const Vec3L& n) const {
    const Vec3L d_A = R_WA_.transpose() * n;
    const Vec3L d_B = R_WB_.transpose() * -n;
    return p_AB_ + R_WB_ * std::visit(SupportOf{d_B}, b_) - R_WA_ * std::visit(SupportOf{d_A}, a_);
  }
  Real separation(const Vec3L& n) const { return n.dot(lowest(n)) / n.norm(); }
  const Mat3L& R_WA() const { return R_WA_; }
  const Mat3L& R_WB() const { return R_WB_; }
  const Vec3L& p_AB() const { return p_AB_; }

 private:
  const Shape& a_;
  const Shape& b_;
  Mat3L R_WA_, R_WB_;
  Vec3L p_AB_;
};

/// Wolfe's method: the point of the hull of the set nearest to the origin, points being added and dropped.
/// Source: Wolfe, Finding the Nearest Point in a Polytope, Math. Programming 11, 1976.
class MinimumNorm {
 public:
  explicit MinimumNorm(const Difference& difference) : difference_(difference) {
    points_ = {difference.lowest(difference.p_AB())};
    weights_ = {1};
  }

  /// Both bounds; lower ≤ 0 where the set may hold the origin.
  ReferenceDistance solve() {
    Vec3L v = points_[0];
    Real lower = -std::numeric_limits<Real>::infinity();
    for (int i = 0; i < 2000 && v.norm() > 1e-17L; ++i) {
      const Vec3L w = difference_.lowest(v);
      lower = std::max(lower, v.dot(w) / v.norm());
      if (v.norm() - lower < 1e-18L || points_.size() == 4) break;
      const Real before = v.squaredNorm();
      points_.push_back(w);
      weights_.push_back(0);
      minor_cycles();
      v = point();
      if (v.squaredNorm() >= before) break;
    }
    return {lower, std::max(v.norm(), lower)};
  }

 private:
  Vec3L point() const {
    Vec3L v = Vec3L::Zero();
    for (std::size_t i = 0; i < points_.size(); ++i) v += weights_[i] * points_[i];
    return v;
  }

  /// Weights of the point of the affine hull nearest to the origin.
  std::vector<Real> affine_weights() const {
    const Eigen::Index m = static_cast<Eigen::Index>(points_.size()) - 1;
    if (m == 0) return {1};
    Eigen::Matrix<Real, 3, Eigen::Dynamic> E(3, m);
    for (Eigen::Index i = 0; i < m; ++i) E.col(i) = points_[static_cast<std::size_t>(i) + 1] - points_[0];
    const Eigen::Matrix<Real, Eigen::Dynamic, 1> y = E.colPivHouseholderQr().solve(-points_[0]);
    std::vector<Real> weights{1 - y.sum()};
    for (Eigen::Index i = 0; i < m; ++i) weights.push_back(y[i]);
    return weights;
  }

  void minor_cycles() {
    for (;;) {
      const std::vector<Real> wanted = affine_weights();
      Real step = 1;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (wanted[i] < 0) step = std::min(step, weights_[i] / (weights_[i] - wanted[i]));
      }
      for (std::size_t i = 0; i < wanted.size(); ++i) weights_[i] += step * (wanted[i] - weights_[i]);
      if (step == 1) return;
      std::size_t least = 0;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (wanted[i] < 0 && (wanted[least] >= 0 || weights_[i] < weights_[least])) least = i;
      }
      points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(least));
      weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(least));
    }
  }

  const Difference& difference_;
  std::vector<Vec3L> points_;
  std::vector<Real> weights_;
};

/// A polytope's edges with the normals of their two faces, and its face normals, in the world.
struct GaussMap {
  struct Arc {
    Vec3L edge, from, to;
  };
  std::vector<Vec3L> normals;
  std::vector<Arc> arcs;
};

std::optional<ConvexHull> hull_of(const Shape& shape) {
  if (const Box* const box = std::get_if<Box>(&shape)) return make_box_hull(box->half_extents);
  if (const Convex* const convex = std::get_if<Convex>(&shape)) return *convex->hull;
  return std::nullopt;
}

GaussMap gauss_map(const ConvexHull& hull, const Mat3L& R) {
  GaussMap map;
  for (const std::vector<int>& face : hull.faces) {
    Vec3L area = Vec3L::Zero();
    const Vec3L p = hull.vertices[static_cast<std::size_t>(face[0])].cast<Real>();
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Vec3L q = hull.vertices[static_cast<std::size_t>(face[i])].cast<Real>();
      const Vec3L r = hull.vertices[static_cast<std::size_t>(face[i + 1])].cast<Real>();
      area += (q - p).cross(r - p);
    }
    map.normals.push_back(R * area.normalized());
  }
  for (const ConvexHull::Edge& e : hull.edges) {
    const Vec3L edge =
        (hull.vertices[static_cast<std::size_t>(e.v1)] - hull.vertices[static_cast<std::size_t>(e.v0)])
            .cast<Real>();
    map.arcs.push_back(
        {R * edge, map.normals[static_cast<std::size_t>(e.f0)], map.normals[static_cast<std::size_t>(e.f1)]});
  }
  return map;
}

/// The largest separation over all face normals and all products of edges whose arcs on the Gauss map cross
/// (within rounding, for a product more does no harm).
Real polytope_maximum(const Difference& difference, const GaussMap& a, const GaussMap& b) {
  Real best = -std::numeric_limits<Real>::infinity();
  for (const Vec3L& n : a.normals) best = std::max(best, difference.separation(n));
  for (const Vec3L& n : b.normals) best = std::max(best, difference.separation(-n));
  for (const GaussMap::Arc& e : a.arcs) {
    for (const GaussMap::Arc& f : b.arcs) {
      // The arc of A from n0 to n1 crosses that of -B.
      constexpr Real slack = 1e-12L;
      const Real c0 = -f.edge.dot(e.from), c1 = -f.edge.dot(e.to);
      if (c0 * c1 > slack) continue;
      const Real d0 = -e.edge.dot(f.from), d1 = -e.edge.dot(f.to);
      if (d0 * d1 > slack) continue;
      Vec3L n = e.edge.cross(f.edge);
      const Real length = n.norm();
      if (length <= 1e-15L) continue;
      n /= length;
      best = std::max({best, difference.separation(n), difference.separation(-n)});
    }
  }
  return best;
}

/// Local maximum of s by a pattern of directions that shrinks.
Real climb(const Difference& difference, Vec3L n, std::mt19937_64& random) {
  Real best = difference.separation(n);
  for (Real step = 0.05L; step > 1e-10L;) {
    const Vec3L side = n.unitOrthogonal();
    const Vec3L up = n.cross(side);
    const Real turn = static_cast<Real>(random() >> 11) * 0x1p-53L * 2 * std::numbers::pi_v<Real>;
    bool is_better = false;
    for (int k = 0; k < 8; ++k) {
      const Real angle = turn + static_cast<Real>(k) * std::numbers::pi_v<Real> / 4;
      const Vec3L m = (n + step * (std::cos(angle) * side + std::sin(angle) * up)).normalized();
      const Real value = difference.separation(m);
      if (value <= best) continue;
      best = value;
      n = m;
      is_better = true;
      break;
    }
    step *= is_better ? 1.5L : 0.6L;
  }
  return best;
}

Real many_start_maximum(const Difference& difference, const std::vector<Vec3>& normals) {
  std::vector<Vec3L> starts;
  for (const Vec3& n : normals) starts.push_back(n.cast<Real>().normalized());
  for (int i = 0; i < 3; ++i) {
    for (const Real sign : {1.0L, -1.0L}) {
      starts.push_back(sign * difference.R_WA().col(i));
      starts.push_back(sign * difference.R_WB().col(i));
    }
  }
  constexpr int kStarts = 600;
  for (int i = 0; i < kStarts; ++i) {
    const Real z = 1 - (2 * static_cast<Real>(i) + 1) / kStarts;
    const Real angle = static_cast<Real>(i) * std::numbers::pi_v<Real> * (3 - std::sqrt(5.0L));
    const Real r = std::sqrt(1 - z * z);
    starts.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  std::vector<std::pair<Real, Vec3L>> seeds;
  for (const Vec3L& n : starts) seeds.emplace_back(difference.separation(n), n);
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });

  // The best starts of different regions.
  Real best = seeds[0].first;
  std::vector<Vec3L> climbed;
  std::mt19937_64 random(1);
  for (const auto& [value, n] : seeds) {
    const bool is_near =
        std::any_of(climbed.begin(), climbed.end(), [&](const Vec3L& m) { return m.dot(n) > 0.95L; });
    if (is_near) continue;
    best = std::max(best, climb(difference, n, random));
    climbed.push_back(n);
    if (climbed.size() == 8) break;
  }
  return best;
}

}  // namespace

long double reference_separation(const Vec3& n, const Shape& a, const Pose& X_WA, const Shape& b,
                                 const Pose& X_WB) {
  return Difference(a, X_WA, b, X_WB).separation(n.cast<Real>());
}

ReferenceDistance reference_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                                     const std::vector<Vec3>& normals) {
  const Difference difference(a, X_WA, b, X_WB);
  ReferenceDistance apart = MinimumNorm(difference).solve();
  if (apart.lower > 0) {
    // The normals that were found prove lower bounds too.
    for (const Vec3& n : normals) apart.lower = std::max(apart.lower, difference.separation(n.cast<Real>()));
    return apart;
  }
  const std::optional<ConvexHull> hull_a = hull_of(a);
  const std::optional<ConvexHull> hull_b = hull_of(b);
  const Real best = hull_a && hull_b ? polytope_maximum(difference, gauss_map(*hull_a, difference.R_WA()),
                                                        gauss_map(*hull_b, difference.R_WB()))
                                     : many_start_maximum(difference, normals);
  return {best, best};
}

}  // namespace rigor::bench
