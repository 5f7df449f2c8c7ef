#include "rigor/bulk/contacts/manifold_bounce.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rigor {

namespace {

/// A point that meets more slowly does not bounce [m/s].
constexpr float bounce_speed = 1e-2f;
/// Sweeps over the points and the friction of a manifold, one after the other: at most so many, and no more
/// once one changes the wrench by less than this share of it.
constexpr int most_sweeps = 32;
constexpr double settled = 1e-10;

/// (V, Ω) of one body alone along n, t1, t2 at the centre of the manifold, as a block has it of two
/// (docs/theory/bulk.md, section 2). r: from the centre of mass.
Vec6 motion_at(const ManifoldFrame& f, const Vec3& r, const MotionRecord& motion) {
  const Vec3 w = vector_of(motion.w), v = vector_of(motion.v) + w.cross(r);
  Vec6 u;
  u << f.n.dot(v), f.t1.dot(v), f.t2.dot(v), f.n.dot(w), f.t1.dot(w), f.t2.dot(w);
  return u;
}

Mat3 matrix_of(const InverseInertia& I) {
  Mat3 m;
  m << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  return m;
}

/// The response of a body's velocities to a wrench (F, T) along n, t1, t2 at the centre of the manifold, with
/// the inertia that contacts have: dv and dw times it.
struct WrenchResponse {
  Eigen::Matrix<double, 3, 6> dv, dw;
  Mat6 K;  ///< Of (V, Ω) there.
};
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

/// A quadratic function without a constant: what a part κ of a change costs.
struct Cost {
  double square = 0, linear = 0;  ///< square κ² + linear κ [J].

  /// The largest part, at most 1, that costs no more than `most` >= 0.
  double affordable_part(double most) const {
    if (square + linear <= most) return 1;
    return (-linear + std::sqrt(linear * linear + 4 * square * most)) / (2 * square);
  }
};

/// Adds the kinetic energy that a body gets by the change of its velocities, in its present orientation.
void add_cost(const Model& model, int body, const BulkBodies& bodies, const Vec3& dv, const Vec3& dw,
              Cost& cost) {
  const Mat3 R_BW = rotation_matrix(orientation_now(body, bodies)).transpose();
  const MotionRecord& motion = bodies.motion[at(body)];
  const double mass = model.body(body).mass;
  const Vec3 moments = model.body(body).moments, dw_B = R_BW * dw;
  cost.square += 0.5 * (mass * dv.squaredNorm() + dw_B.dot(moments.cwiseProduct(dw_B)));
  cost.linear +=
      mass * dv.dot(vector_of(motion.v)) + dw_B.dot(moments.cwiseProduct(R_BW * vector_of(motion.w)));
}

void add_velocity(const Vec3& dv, const Vec3& dw, MotionRecord& motion) {
  for (int k = 0; k < 3; ++k) {
    motion.v[k] += static_cast<float>(dv[k]);
    motion.w[k] += static_cast<float>(dw[k]);
  }
}

/// u·row is the normal velocity of the point, and an impulse of the point that multiple of a wrench.
Vec6 row_of(const SolvedManifold::Point& point) {
  Vec6 row;
  row << 1, 0, 0, 0, point.p2, -point.p1;
  return row;
}

bool meets(const SolvedManifold& manifold, std::size_t point) {
  return manifold.impulses.normal[point] > 0 && manifold.points[point].first_speed < -bounce_speed;
}

/// Impulses with which a manifold bounces, besides those that it has, and their wrench.
struct BounceImpulses {
  std::array<double, Manifold::max_points> points{};
  Eigen::Vector2d slip = Eigen::Vector2d::Zero(), roll = Eigen::Vector2d::Zero();
  double twist = 0;
  Vec6 wrench = Vec6::Zero();
};

/// Keeps a vector within a disc.
Eigen::Vector2d within(double radius, const Eigen::Vector2d& x) {
  const double length = x.norm();
  return length > radius ? Eigen::Vector2d(radius / length * x) : x;
}

/// The impulse that stops what two components of u do, the first of which is `first`.
Eigen::Vector2d stopping_impulse(const Vec6& u, const Mat6& K, Eigen::Index first) {
  const Eigen::Matrix2d own = K.block<2, 2>(first, first);
  if (!(own.determinant() > 0)) return Eigen::Vector2d::Zero();
  return -own.inverse() * u.segment<2>(first);
}

/// Friction of the whole impact, the sweeps and the bounce: as far as all normal impulses bear it, it stops
/// slip, twist and rolling. u: as the bodies move now.
void add_friction(const SolvedManifold& manifold, const Vec6& u, const Mat6& K, BounceImpulses& found) {
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
  found.slip = within(manifold.friction * pressed, slip_before + found.slip + stopping_impulse(first, K, 1)) -
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
    const Eigen::Vector2d next =
        within(manifold.rolling_friction * pressed, before + found.roll + stopping_impulse(now, K, 4)) -
        before;
    found.wrench.segment<2>(4) += next - found.roll;
    found.roll = next;
  }
}

/// Points that bounce reach their speed, others that were pressed are held, and friction acts as all of their
/// impulses allow. u: as they move, K: what wrenches change of it.
BounceImpulses find_impulses(const SolvedManifold& manifold, const Vec6& u, const Mat6& K) {
  const double e = manifold.restitution;
  const bool has_friction =
      manifold.friction > 0 || manifold.torsional_friction > 0 || manifold.rolling_friction > 0;
  BounceImpulses found;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const Vec6 before = found.wrench;
    if (has_friction) add_friction(manifold, u, K, found);
    for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
      const SolvedManifold::Point& point = manifold.points[k];
      if (!(manifold.impulses.normal[k] > 0)) continue;
      const bool is_fast = meets(manifold, k);
      const double wanted = is_fast ? -e * point.first_speed : 0;
      const Vec6 row = row_of(point);
      const double speed = row.dot(u + K * found.wrench);
      const double next = std::max(0.0, found.points[k] + (wanted - speed) / row.dot(K * row));
      found.wrench += (next - found.points[k]) * row;
      found.points[k] = next;
    }
    if (sweep > 0 && (found.wrench - before).norm() <= settled * found.wrench.norm()) break;
  }
  return found;
}

}  // namespace

bool bounces(const SolvedManifold& manifold) {
  if (!(manifold.restitution > 0)) return false;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    if (meets(manifold, k)) return true;
  }
  return false;
}

double energy_taken(const SolvedManifold& manifold, const BulkBodies& bodies) {
  const ManifoldFrame& f = manifold.frame;
  const MotionRecord& A = bodies.motion[at(manifold.body_A)];
  const MotionRecord& B = bodies.motion[at(manifold.body_B)];
  const Vec6 u = motion_at(f, f.rB, B) - motion_at(f, f.rA, A);
  double work = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    const double before = point.first_speed, now = u.dot(row_of(point));
    work += 0.5 * static_cast<double>(manifold.impulses.normal[k]) * (before + now);
  }
  return std::max(0.0, -work);
}

ManifoldImpulses bounce(const Model& model, const SolvedManifold& manifold, double most, HeldBodies& held,
                        BulkBodies& bodies) {
  const ManifoldFrame& f = manifold.frame;
  const std::array<int, 2> indices{manifold.body_A, manifold.body_B};

  // u of B against A, and its response K to a wrench on both.
  std::array<WrenchResponse, 2> responses;
  Vec6 u = Vec6::Zero();
  Mat6 K = Mat6::Zero();
  for (const bool is_B : {false, true}) {
    const std::size_t body = at(indices[is_B]);
    responses[is_B] = response_of(bodies.inertia[body], f, is_B ? f.rB : f.rA);
    if (!held.contains(indices[is_B])) K += responses[is_B].K;
    u += (is_B ? 1 : -1) * motion_at(f, is_B ? f.rB : f.rA, bodies.motion[body]);
  }

  // What is held does not bounce off what stands.
  if (K.isZero(0)) return {};

  // Newton's law, and Coulomb's for the whole impact.
  const BounceImpulses found = find_impulses(manifold, u, K);

  // What the whole change of the velocities would cost.
  Cost cost;
  std::array<Vec3, 2> dv, dw;
  for (const bool is_B : {false, true}) {
    const Vec6 wrench = (is_B ? 1 : -1) * found.wrench;
    dv[is_B] = responses[is_B].dv * wrench;
    dw[is_B] = responses[is_B].dw * wrench;
    const int body = indices[is_B];
    if (bodies.is_dynamic(body) && !held.contains(body)) {
      add_cost(model, body, bodies, dv[is_B], dw[is_B], cost);
    } else {
      // It moves as it must: what it works is given.
      const MotionRecord& motion = bodies.motion[at(body)];
      cost.linear += wrench.dot(motion_at(f, is_B ? f.rB : f.rA, motion));
    }
  }

  // The part of it that the energy pays for.
  const double part = cost.affordable_part(most);
  for (const bool is_B : {false, true}) {
    const int body = indices[is_B];
    if (!bodies.is_dynamic(body)) continue;
    if (held.contains(body)) {
      held.strike(body, part * dv[is_B], part * dw[is_B]);
    } else {
      add_velocity(part * dv[is_B], part * dw[is_B], bodies.motion[at(body)]);
    }
  }
  // Both ends of the change lie in the cones of friction, and so does what is between them.
  ManifoldImpulses impulses;
  for (std::size_t k = 0; k < Manifold::max_points; ++k)
    impulses.normal[k] = static_cast<float>(part * found.points[k]);
  for (const int k : {0, 1}) {
    impulses.tangent[at(k)] = static_cast<float>(part * found.slip[k]);
    impulses.roll[at(k)] = static_cast<float>(part * found.roll[k]);
  }
  impulses.twist = static_cast<float>(part * found.twist);
  return impulses;
}

}  // namespace rigor
