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
  if (changed.are_ties_new) return find_free(model);
  list_free();
}

void StepBalance::list_free() {
  free_.clear();
  for (std::size_t i = 0; i < is_free_.size(); ++i) {
    if (is_free_[i] != 0) free_.push_back(static_cast<int>(i));
  }
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
  list_free();
}

void StepBalance::begin(const BulkBodies& bodies) {
  begin_ = momenta_of(bodies);
}

StepBalance::Momenta StepBalance::momenta_of(const BulkBodies& bodies) const {
  Momenta all;
  for (const int i : free_) {
    if (!bodies.is_dynamic(i)) continue;
    const Vec3 v = vector_of(bodies.motion[at(i)].v);
    all.sum += masses_[at(i)] * (v + vector_of(bodies.finer_v[at(i)].data()));
    all.sum_of_norms += masses_[at(i)] * v.norm();
  }
  return all;
}

void StepBalance::end(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations, double h,
                      const BulkContacts& contacts, const DirectIslands& direct,
                      BulkStepReport& report) const {
  // Forces give their impulse to the bodies of the balance.
  Vec3 given = Vec3::Zero();
  const Momenta now = momenta_of(bodies);
  report.rounded_momentum = std::max(begin_.sum_of_norms, now.sum_of_norms);
  for (const int i : free_) {
    if (!bodies.is_dynamic(i)) continue;
    const Vec3 impulse = h * masses_[at(i)] * vector_of(accelerations[at(i)].data());
    given += impulse;
    report.rounded_momentum += impulse.norm();
  }
  // What a contact gives to the bodies of the balance, if it is not between two of them.
  const auto book = [&](int body_A, int body_B, const Vec3& impulse) {
    const bool is_A = is_booked(bodies, body_A), is_B = is_booked(bodies, body_B);
    if (is_A != is_B) given += is_B ? impulse : Vec3(-impulse);
    report.rounded_momentum += impulse.norm();
  };
  // Contacts give the impulse that comes from other bodies; impacts and the work of kinematic bodies are read
  // on the way. Contacts that last between two bodies of the balance give it nothing, nor do those that were
  // near and not pressed.
  const auto is_wanted = [&](int a, int b, bool is_new, bool is_pressed) {
    return is_pressed && (is_new || is_booked(bodies, a) != is_booked(bodies, b) ||
                          bodies.is_dynamic(a) != bodies.is_dynamic(b));
  };
  const auto note = [&](const SolvedManifold& manifold, std::size_t number) {
    const int body_A = manifold.body_A, body_B = manifold.body_B;
    const ManifoldWrench on_B = total_wrench(manifold);
    if (contacts.manifolds().is_new(number) && approach_speed(manifold) > impact_speed) {
      const Vec3 p_W = bodies.x[at(body_A)] + found_arm(manifold, bodies);
      report.impacts.push_back({body_A, body_B, p_W, on_B.impulse});
    }
    book(body_A, body_B, on_B.impulse);
    report.work += work_of_mover(manifold, bodies);
  };
  contacts.for_contacts(is_wanted, note);
  // Islands that were solved directly have contacts of their own.
  for (const BulkContact& contact : direct.contacts()) {
    if (contact.is_new && contact.approach_speed > impact_speed)
      report.impacts.push_back({contact.body_A, contact.body_B, contact.center_W, contact.impulse_W()});
    book(contact.body_A, contact.body_B, contact.impulse_W());
  }
  // Impacts are put into the order of bodies, whatever the blocks are. The change of momentum that nothing
  // gave is the error.
  std::stable_sort(report.impacts.begin(), report.impacts.end(),
                   [](const BulkImpact& a, const BulkImpact& b) {
                     return std::pair(a.body_A, a.body_B) < std::pair(b.body_A, b.body_B);
                   });
  report.momentum_error = now.sum - begin_.sum - given;
}

}  // namespace rigor
