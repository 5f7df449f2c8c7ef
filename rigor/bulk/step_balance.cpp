#include "rigor/bulk/step_balance.hpp"

#include "rigor/bulk/bulk_step_report.hpp"
#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/force.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rigor {

namespace {

/// Contacts that begin more slowly than this are not impacts [m/s]: the speed from which the solver lets them
/// bounce.
constexpr double impact_speed = 1e-2;

}  // namespace

StepBalance::StepBalance(const Model& model) {
  for (const Body& body : model.bodies()) masses_.push_back(body.mass);
  find_free(model);
}

void StepBalance::change(const Model& model, const ChangedBodies& changed) {
  // A body that no joint holds is free.
  for (const int body : changed.bodies) {
    masses_[at(body)] = model.body(body).mass;
    is_free_[at(body)] = model.body(body).motion == MotionType::dynamic;
  }
  if (changed.are_ties_new) find_free(model);
}

void StepBalance::find_free(const Model& model) {
  // An island of joints that is tied to the world, or to a body that is not dynamic, has no balance of its
  // own: the joint's impulse is not known.
  BulkIslands islands(model);
  std::vector<bool> is_grounded(at(model.body_count()), false);
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    const std::vector<int> bodies = model.bodies_of_joint(j);
    const Joint& joint = model.joint(j);
    bool is_tied =
        joint.type != JointType::gear && (joint.body_A == world_body || joint.body_B == world_body);
    for (const int body : bodies) is_tied = is_tied || islands.island_of(body) < 0;
    for (const int body : bodies) {
      if (is_tied && islands.island_of(body) >= 0) is_grounded[at(islands.island_of(body))] = true;
    }
  }
  // Momentum is balanced over the bodies of all other islands.
  is_free_.clear();
  for (int i = 0; i < model.body_count(); ++i) {
    const int island = islands.island_of(i);
    is_free_.push_back(island >= 0 && !is_grounded[at(island)]);
  }
}

void StepBalance::begin(const BulkBodies& bodies) {
  begin_ = momentum(bodies);
  momenta_ = sum_of_momenta(bodies);
}

Vec3 StepBalance::momentum(const BulkBodies& bodies) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < bodies.count(); ++i) {
    if (!is_booked(bodies, i)) continue;
    sum += masses_[at(i)] * (vector_of(bodies.motion[at(i)].v) + vector_of(bodies.finer_v[at(i)].data()));
  }
  return sum;
}

double StepBalance::sum_of_momenta(const BulkBodies& bodies) const {
  double sum = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    if (is_booked(bodies, i)) sum += masses_[at(i)] * vector_of(bodies.motion[at(i)].v).norm();
  }
  return sum;
}

void StepBalance::book(const BulkBodies& bodies, int body_A, int body_B, const Vec3& impulse,
                       Vec3& given) const {
  if (is_booked(bodies, body_B) && !is_booked(bodies, body_A)) given += impulse;
  if (is_booked(bodies, body_A) && !is_booked(bodies, body_B)) given -= impulse;
}

void StepBalance::end(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations, double h,
                      const BulkContacts& contacts, const DirectIslands& direct,
                      BulkStepReport& report) const {
  // Forces give their impulse to the bodies of the balance.
  Vec3 given = Vec3::Zero();
  report.rounded_momentum = std::max(momenta_, sum_of_momenta(bodies));
  for (int i = 0; i < bodies.count(); ++i) {
    if (!is_booked(bodies, i)) continue;
    const Vec3 impulse = h * masses_[at(i)] * vector_of(accelerations[at(i)].data());
    given += impulse;
    report.rounded_momentum += impulse.norm();
  }
  // Contacts give the impulse that comes from other bodies; impacts and the work of kinematic bodies are read
  // on the way. Contacts that last between two bodies of the balance give it nothing.
  const auto is_wanted = [&](int a, int b, bool is_new) {
    return is_new || is_booked(bodies, a) != is_booked(bodies, b) ||
           bodies.is_dynamic(a) != bodies.is_dynamic(b);
  };
  const auto note = [&](const SolvedManifold& manifold, std::size_t number) {
    const int body_A = manifold.body_A, body_B = manifold.body_B;
    const ManifoldWrench on_B = total_wrench(manifold);
    if (contacts.manifolds().is_new(number) && approach_speed(manifold) > impact_speed) {
      const Vec3 p_W = bodies.x[at(body_A)] + found_arm(manifold, bodies);
      report.impacts.push_back({body_A, body_B, p_W, on_B.impulse});
    }
    book(bodies, body_A, body_B, on_B.impulse, given);
    report.rounded_momentum += on_B.impulse.norm();
    report.work += work_of_mover(manifold, bodies);
  };
  contacts.for_contacts(is_wanted, note);
  // Islands that were solved directly have contacts of their own.
  for (const BulkContact& contact : direct.contacts()) {
    if (contact.is_new && contact.approach_speed > impact_speed)
      report.impacts.push_back({contact.body_A, contact.body_B, contact.center_W, contact.impulse_W()});
    book(bodies, contact.body_A, contact.body_B, contact.impulse_W(), given);
    report.rounded_momentum += contact.impulse_W().norm();
  }
  // Impacts are put into the order of bodies, whatever the blocks are. The change of momentum that nothing
  // gave is the error.
  std::stable_sort(report.impacts.begin(), report.impacts.end(),
                   [](const BulkImpact& a, const BulkImpact& b) {
                     return std::pair(a.body_A, a.body_B) < std::pair(b.body_A, b.body_B);
                   });
  report.momentum_error = momentum(bodies) - begin_ - given;
}

}  // namespace rigor
