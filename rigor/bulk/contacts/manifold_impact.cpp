#include "rigor/bulk/contacts/manifold_impact.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rigor {

namespace {

/// A point that meets more slowly does not bounce [m/s].
constexpr float bounce_speed = 1e-2f;
/// Sweeps over the points and the friction of a manifold, one after the other: at most so many, and no more
/// once one changes the wrench by less than this share of it.
constexpr int most_sweeps = 400;
constexpr double settled = 1e-10;

Mat3 matrix_of(const InverseInertia& I) {
  Mat3 m;
  m << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  return m;
}

bool meets_fast(const SolvedManifold::Point& point) {
  return point.first_speed < -bounce_speed;
}

/// The impulse of friction on a disc from the one before: it stops the velocity, or else is opposed to it on
/// the rim, as in the sweeps (manifold_sweep.inl). K: the response of the velocity.
Eigen::Vector2d on_disc(double radius, const Eigen::Matrix2d& K, const Eigen::Vector2d& u,
                        const Eigen::Vector2d& before) {
  if (!(K.determinant() > 0)) return before;
  Eigen::Vector2d stopping = before - K.inverse() * u;
  if (stopping.norm() <= radius) return stopping;
  // The larger eigenvalue of the response.
  const double mean = 0.5 * K.trace(), most = mean + std::hypot(0.5 * (K(0, 0) - K(1, 1)), K(0, 1));
  const Eigen::Vector2d sliding = before - u / most;
  const double length = sliding.norm();
  if (!(length > 0)) return Eigen::Vector2d::Zero();
  return radius / length * sliding;
}

/// Friction of the whole impact, the sweeps and this: as far as all normal impulses bear it, it stops
/// slip, twist and rolling. u: as the bodies move now.
void add_friction(const SolvedManifold& manifold, const Vec6& u, const Mat6& K, ImpactImpulses& found) {
  // The normal impulses Σ λ and Σ λ |p| of the impact, which bound friction as in the sweeps.
  double pressed = 0, spread = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    const double impulse = static_cast<double>(manifold.impulses.normal[k]) + found.points[k];
    pressed += impulse;
    spread += impulse * std::hypot(point.p1, point.p2);
  }
  const auto total_of = [](const std::array<float, 2>& x) {
    return Eigen::Vector2d(static_cast<double>(x[0]), static_cast<double>(x[1]));
  };

  // Slip: a disc of impulses at the centre.
  const Eigen::Vector2d slip_before = total_of(manifold.impulses.tangent);
  const Vec6 first = u + K * found.wrench;
  found.slip = on_disc(manifold.friction * pressed, K.block<2, 2>(1, 1), first.segment<2>(1),
                       slip_before + found.slip) -
               slip_before;
  found.wrench.segment<2>(1) = found.slip;

  // Twist: a moment about n. A single point without torsional friction bears none.
  const double twist_limit = manifold.friction * spread + manifold.torsional_friction * pressed;
  if (twist_limit > 0 && K(3, 3) > 0) {
    const double before = manifold.impulses.twist, rate = u[3] + K.row(3).dot(found.wrench);
    found.twist = std::clamp(before + found.twist - rate / K(3, 3), -twist_limit, twist_limit) - before;
    found.wrench[3] = found.twist;
  }

  // Rolling: a disc of moments along t1 and t2, where the points have theirs too.
  if (manifold.rolling_friction > 0) {
    const Eigen::Vector2d before = total_of(manifold.impulses.roll);
    const Vec6 now = u + K * found.wrench;
    const Eigen::Vector2d next = on_disc(manifold.rolling_friction * pressed, K.block<2, 2>(4, 4),
                                         now.segment<2>(4), before + found.roll) -
                                 before;
    found.wrench.segment<2>(4) += next - found.roll;
    found.roll = next;
  }
}

/// Sweeps over friction and points until they change no more. mobility: the responses of the points that take
/// part to their impulses; 0 of the others.
ImpactImpulses sweep_impact(const SolvedManifold& manifold, const ImpactAim& aim,
                            const std::array<double, Manifold::max_points>& mobility, bool has_friction,
                            const Vec6& u, const Mat6& K) {
  ImpactImpulses found;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const Vec6 before = found.wrench;
    if (has_friction) add_friction(manifold, u, K, found);
    for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
      const double own = manifold.impulses.normal[k];
      if (!(mobility[k] > 0)) continue;
      const bool is_fast = meets_fast(manifold.points[k]);
      const double wanted = is_fast ? aim.speeds[k] : 0, least = is_fast && aim.may_take_back ? -own : 0;
      const Vec6 row = row_of(manifold.points[k]);
      const double speed = row.dot(u + K * found.wrench);
      const double next = std::max(least, found.points[k] + (wanted - speed) / mobility[k]);
      found.wrench += (next - found.points[k]) * row;
      found.points[k] = next;
    }
    if (sweep > 0 && (found.wrench - before).norm() <= settled * found.wrench.norm()) break;
  }
  return found;
}

}  // namespace

WrenchResponse response_of(const InverseInertia& inertia, const ManifoldFrame& f, const Vec3& r) {
  Mat3 axes;
  axes << f.n, f.t1, f.t2;
  // What a wrench is at the centre of mass: the force, and the moment T + r × F.
  Mat3 arms;
  arms << r.cross(f.n), r.cross(f.t1), r.cross(f.t2);
  Eigen::Matrix<double, 3, 6> moments;
  moments << arms, axes;
  WrenchResponse response;
  response.dv << inertia.inv_mass * axes, Mat3::Zero();
  response.dw = matrix_of(inertia) * moments;
  response.K = moments.transpose() * response.dw;
  response.K.topLeftCorner<3, 3>().diagonal().array() += inertia.inv_mass;
  return response;
}

Vec6 motion_at(const ManifoldFrame& f, const Vec3& r, const MotionRecord& motion) {
  const Vec3 w = vector_of(motion.w), v = vector_of(motion.v) + w.cross(r);
  Vec6 u;
  u << f.n.dot(v), f.t1.dot(v), f.t2.dot(v), f.n.dot(w), f.t1.dot(w), f.t2.dot(w);
  return u;
}

Vec6 motion_at(const SolvedManifold& manifold, const BulkBodies& bodies) {
  const ManifoldFrame& f = manifold.frame;
  return motion_at(f, f.rB, bodies.motion[at(manifold.body_B)]) -
         motion_at(f, f.rA, bodies.motion[at(manifold.body_A)]);
}

Vec6 row_of(const SolvedManifold::Point& point) {
  Vec6 row;
  row << 1, 0, 0, 0, point.p2, -point.p1;
  return row;
}

double meeting_speed(const SolvedManifold& manifold, std::size_t point,
                     const std::vector<MotionRow>& accelerations, const BulkBodies& bodies) {
  const SolvedManifold::Point& own = manifold.points[point];
  const auto acceleration_of = [&](int body) {
    return bodies.gives_way(body) ? vector_of(accelerations[at(body)].data()) : Vec3(Vec3::Zero());
  };
  const Vec3 a = acceleration_of(manifold.body_B) - acceleration_of(manifold.body_A);
  // u² = u⁻² - 2 a·n s over the part s of the gap that the bodies have closed.
  const auto way_of = [&](int body, const Vec3& r) {
    MotionRecord way;
    std::copy_n(bodies.motion[at(body)].dp, 3, way.v);
    std::copy_n(bodies.motion[at(body)].dr, 3, way.w);
    return motion_at(manifold.frame, r, way);
  };
  const Vec6 way = way_of(manifold.body_B, manifold.frame.rB) - way_of(manifold.body_A, manifold.frame.rA);
  const double closed = std::clamp(-way.dot(row_of(own)), 0.0, std::max(0.0, own.gap));
  const double square = own.first_speed * own.first_speed - 2 * manifold.frame.n.dot(a) * closed;
  return -std::sqrt(std::max(0.0, square));
}

bool strikes(const SolvedManifold& manifold, std::size_t point) {
  return manifold.impulses.normal[point] > 0 && meets_fast(manifold.points[point]);
}

bool strikes(const SolvedManifold& manifold) {
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    if (strikes(manifold, k)) return true;
  }
  return false;
}

ManifoldImpulses ImpactImpulses::part(double share) const {
  ManifoldImpulses impulses;
  for (std::size_t k = 0; k < Manifold::max_points; ++k)
    impulses.normal[k] = static_cast<float>(share * points[k]);
  for (const int k : {0, 1}) {
    impulses.tangent[at(k)] = static_cast<float>(share * slip[k]);
    impulses.roll[at(k)] = static_cast<float>(share * roll[k]);
  }
  impulses.twist = static_cast<float>(share * twist);
  return impulses;
}

ImpactImpulses find_impact(const SolvedManifold& manifold, const ImpactAim& aim, const Vec6& u,
                           const Mat6& K) {
  // Points that nothing moves have no impulse, and those that nothing has pressed. But what came as fast from
  // no farther than one that was pressed has met too.
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    if (manifold.impulses.normal[k] > 0) farthest = std::max(farthest, manifold.points[k].gap);
  }
  std::array<double, Manifold::max_points> mobility{};
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    const bool has_met = aim.may_take_back && point.mass > 0 && meets_fast(point) && point.gap <= farthest;
    const Vec6 row = row_of(point);
    if (manifold.impulses.normal[k] > 0 || has_met) mobility[k] = row.dot(K * row);
  }
  const bool has_friction =
      manifold.friction > 0 || manifold.torsional_friction > 0 || manifold.rolling_friction > 0;
  const ImpactImpulses found = sweep_impact(manifold, aim, mobility, has_friction, u, K);
  // Friction with long arms may press points more than it takes from them, beyond all numbers.
  return found.wrench.allFinite() ? found : sweep_impact(manifold, aim, mobility, false, u, K);
}

}  // namespace rigor
