#include "rigor/bulk/contacts/manifold_bounce.hpp"

#include "rigor/bulk/contacts/manifold_impact.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rigor {

namespace {

/// Adds the kinetic energy that a body gets by the change of its velocities, in its present orientation.
void add_cost(const Model& model, int body, const BulkBodies& bodies, const Vec3& dv, const Vec3& dw,
              ImpactCost& cost) {
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

}  // namespace

bool bounces(const SolvedManifold& manifold) {
  return manifold.restitution > 0 && strikes(manifold);
}

double energy_taken(const SolvedManifold& manifold, const std::vector<MotionRow>& accelerations,
                    const BulkBodies& bodies) {
  const Vec6 u = motion_at(manifold, bodies);
  double work = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    // What did not strike met at the beginning of the step.
    const double before =
        strikes(manifold, k) ? meeting_speed(manifold, k, accelerations, bodies) : point.first_speed;
    const double now = u.dot(row_of(point));
    work += 0.5 * static_cast<double>(manifold.impulses.normal[k]) * (before + now);
  }
  return std::max(0.0, -work);
}

ManifoldImpulses bounce(const Model& model, const SolvedManifold& manifold, double most,
                        const std::vector<MotionRow>& accelerations, HeldBodies& held, BulkBodies& bodies) {
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
  ImpactAim aim;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k)
    aim.speeds[k] = -manifold.restitution * meeting_speed(manifold, k, accelerations, bodies);
  const ImpactImpulses found = find_impact(manifold, aim, u, K);

  // What the whole change of the velocities would cost.
  ImpactCost cost;
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
  return found.part(part);
}

}  // namespace rigor
