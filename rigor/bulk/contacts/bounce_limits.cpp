#include "rigor/bulk/contacts/bounce_limits.hpp"

#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>

namespace rigor {

namespace {

/// Work of the forces of a step on a body [J].
double work_of_forces(const Model& model, int body, const MotionRow& acceleration, const BulkBodies& bodies) {
  const MotionRecord& moved = bodies.motion[at(body)];
  const Mat3 R_WB = bodies.q[at(body)].toRotationMatrix();
  const Vec3 torque_B =
      model.body(body).moments.cwiseProduct(R_WB.transpose() * vector_of(acceleration.data() + 4));
  return model.body(body).mass * vector_of(acceleration.data()).dot(vector_of(moved.dp)) +
         (R_WB * torque_B).dot(vector_of(moved.dr));
}

}  // namespace

BounceLimits::BounceLimits(const Model& model) : model_(&model), islands_(model) {}

void BounceLimits::begin(const BulkBodies& bodies, const Executor& executor) {
  energies_.resize(bodies.x.size());
  lost_.resize(bodies.x.size());
  wanted_.resize(bodies.x.size());
  executor.for_ranges(bodies.count(), 256, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      energies_[at(i)] = bodies.is_dynamic(i) ? kinetic_energy_now(*model_, i, bodies) : 0;
  });
}

void BounceLimits::limit(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations,
                         const Executor& executor, BulkContacts& contacts) {
  // What each body has lost: E(begin) - E(now), with the work of forces in it.
  executor.for_ranges(bodies.count(), 256, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (!bodies.is_dynamic(i)) continue;
      energies_[at(i)] +=
          work_of_forces(*model_, i, accelerations[at(i)], bodies) - kinetic_energy_now(*model_, i, bodies);
    }
  });

  // The sum over each island, with the work of bodies that move as they must.
  islands_.build(contacts.manifolds());
  std::fill(lost_.begin(), lost_.end(), 0);
  std::fill(wanted_.begin(), wanted_.end(), 0);
  for (int i = 0; i < bodies.count(); ++i) {
    if (bodies.is_dynamic(i)) lost_[at(islands_.island_of(i))] += energies_[at(i)];
  }
  const auto island_of = [&](int body_A, int body_B) {
    return at(islands_.island_of(bodies.is_dynamic(body_A) ? body_A : body_B));
  };
  contacts.for_contacts([&](const SolvedManifold& manifold, std::size_t) {
    lost_[island_of(manifold.body_A, manifold.body_B)] += work_of_mover(manifold, bodies);
  });

  // What the bounces of an island want, and the share that each of them gets.
  contacts.for_bounces(
      [&](int body_A, int body_B, double& most) { wanted_[island_of(body_A, body_B)] += most; });
  contacts.for_bounces([&](int body_A, int body_B, double& most) {
    const std::size_t island = island_of(body_A, body_B);
    if (wanted_[island] > lost_[island]) most *= std::max(0.0, lost_[island]) / wanted_[island];
  });
}

}  // namespace rigor
