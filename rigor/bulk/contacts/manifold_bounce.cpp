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
/// Sweeps over the points of a manifold, one point after the other; each leaves a third of the error or less.
constexpr int point_sweeps = 8;

/// u = (n·v, t1·ω, t2·ω) of ManifoldBlock, of one body alone: the point at (p1, p2) moves along n with
/// u·(1, p2, -p1), and its impulse is that multiple of a force and two moments. r: from the centre of mass.
Vec3 normal_motion(const ManifoldFrame& f, const Vec3& r, const MotionRecord& motion) {
  const Vec3 w = vector_of(motion.w);
  return Vec3(f.n.dot(vector_of(motion.v) + w.cross(r)), f.t1.dot(w), f.t2.dot(w));
}

Mat3 matrix_of(const InverseInertia& I) {
  Mat3 m;
  m << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  return m;
}

/// The response of a body's velocities to a wrench (force along n, moments about t1 and t2): dv n and dw
/// times it, with the inertia that contacts have.
struct WrenchResponse {
  double dv;
  Mat3 dw;
  Mat3 K;  ///< That of u.
};
WrenchResponse response_of(const InverseInertia& inertia, const ManifoldFrame& f, const Vec3& r) {
  Mat3 J;
  J << r.cross(f.n).transpose(), f.t1.transpose(), f.t2.transpose();
  WrenchResponse response;
  response.dv = inertia.inv_mass;
  response.dw = matrix_of(inertia) * J.transpose();
  response.K = J * response.dw;
  response.K(0, 0) += response.dv;
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

/// u·row is the normal velocity of the point.
Vec3 row_of(const SolvedManifold::Point& point) {
  return Vec3(1, point.p2, -point.p1);
}

bool meets(const SolvedManifold& manifold, std::size_t point) {
  return manifold.impulses.normal[point] > 0 && manifold.points[point].first_speed < -bounce_speed;
}

/// Impulses of the points that part them as they should, and their wrench.
struct BounceImpulses {
  std::array<double, Manifold::max_points> points{};
  Vec3 wrench = Vec3::Zero();
};

/// Points that bounce reach their speed, others that were pressed are held. u: as they move, K: what wrenches
/// change of it.
BounceImpulses find_impulses(const SolvedManifold& manifold, const Vec3& u, const Mat3& K) {
  const double e = manifold.restitution;
  BounceImpulses found;
  for (int sweep = 0; sweep < point_sweeps; ++sweep) {
    for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
      const SolvedManifold::Point& point = manifold.points[k];
      if (!(manifold.impulses.normal[k] > 0)) continue;
      const bool is_fast = meets(manifold, k);
      const double wanted = is_fast ? -e * point.first_speed : 0;
      const Vec3 row = row_of(point);
      const double speed = row.dot(u + K * found.wrench);
      const double next = std::max(0.0, found.points[k] + (wanted - speed) / row.dot(K * row));
      found.wrench += (next - found.points[k]) * row;
      found.points[k] = next;
    }
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
  const Vec3 u = normal_motion(f, f.rB, B) - normal_motion(f, f.rA, A);
  double work = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    const double before = point.first_speed, now = u.dot(row_of(point));
    work += 0.5 * static_cast<double>(manifold.impulses.normal[k]) * (before + now);
  }
  return std::max(0.0, -work);
}

std::array<float, Manifold::max_points> bounce(const Model& model, const SolvedManifold& manifold,
                                               double most, HeldBodies& held, BulkBodies& bodies) {
  const ManifoldFrame& f = manifold.frame;
  const std::array<int, 2> indices{manifold.body_A, manifold.body_B};

  // u of B against A, and its response K to a wrench on both.
  std::array<WrenchResponse, 2> responses;
  Vec3 u = Vec3::Zero();
  Mat3 K = Mat3::Zero();
  for (const bool is_B : {false, true}) {
    const std::size_t body = at(indices[is_B]);
    responses[is_B] = response_of(bodies.inertia[body], f, is_B ? f.rB : f.rA);
    if (!held.contains(indices[is_B])) K += responses[is_B].K;
    u += (is_B ? 1 : -1) * normal_motion(f, is_B ? f.rB : f.rA, bodies.motion[body]);
  }

  // What is held does not bounce off what stands.
  if (K.isZero(0)) return {};

  // Newton's law.
  const BounceImpulses found = find_impulses(manifold, u, K);

  // What the whole change of the velocities would cost.
  Cost cost;
  std::array<Vec3, 2> dv, dw;
  for (const bool is_B : {false, true}) {
    const Vec3 wrench = (is_B ? 1 : -1) * found.wrench;
    dv[is_B] = responses[is_B].dv * wrench[0] * f.n;
    dw[is_B] = responses[is_B].dw * wrench;
    const int body = indices[is_B];
    if (bodies.is_dynamic(body) && !held.contains(body)) {
      add_cost(model, body, bodies, dv[is_B], dw[is_B], cost);
    } else {
      // It moves as it must: what it works is given.
      const MotionRecord& motion = bodies.motion[at(body)];
      cost.linear += wrench.dot(normal_motion(f, is_B ? f.rB : f.rA, motion));
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
  std::array<float, Manifold::max_points> impulses;
  for (std::size_t k = 0; k < Manifold::max_points; ++k)
    impulses[k] = static_cast<float>(part * found.points[k]);
  return impulses;
}

}  // namespace rigor
