// What impacts of a step do after its substeps.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/bulk_world_scratch.hpp"
#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <cstddef>

namespace rigor {

/// Whether impacts are ended with all joints: the effort grows with their number times that of all joints.
bool BulkWorld::settles_impacts() const {
  return scratch_->passing.may_take_parts();
}

/// Gives what contacts do to held bodies in a substep, on average, to the joints of these.
void BulkWorld::load_joints_of_held() {
  Scratch& s = *scratch_;
  const auto is_wanted = [&](int a, int b, bool, bool is_pressed) {
    return is_pressed && (s.held.contains(a) || s.held.contains(b));
  };
  s.contacts.for_contacts(is_wanted, [&](const SolvedManifold& manifold, std::size_t) {
    const ManifoldWrench on_B = total_wrench(manifold);
    for (const bool is_B : {false, true}) {
      const int body = is_B ? manifold.body_B : manifold.body_A;
      if (!s.held.contains(body)) continue;
      const double part = (is_B ? 1.0 : -1.0) / settings_.substeps;
      const Vec3 arm = is_B ? manifold.frame.rB : manifold.frame.rA;
      // Velocities that a free body would get: m dv = F and I dw = T + r x F, with I in W.
      const Mat3 R_WB = rotation_matrix(bodies_.q[at(body)]);
      const Vec3 moment = R_WB.transpose() * (on_B.moment + arm.cross(on_B.impulse));
      s.held.strike(body, part / model_->body(body).mass * on_B.impulse,
                    part * (R_WB * moment.cwiseQuotient(model_->body(body).moments)));
    }
  });
  if (s.held.take_strikes(bodies_)) s.joints->solve(JointPass::rates, s.executor);
}

/// Lets bodies bounce that met fast in the step, as far as the step's energy allows.
void BulkWorld::bounce_apart() {
  Scratch& s = *scratch_;
  if (!s.contacts.find_bounces(s.forces.accelerations(), bodies_, s.executor)) return;
  s.bounce_limits.limit(bodies_, s.forces.accelerations(), s.executor, s.contacts);
  s.contacts.bounce_apart(*model_, s.forces.accelerations(), s.held, bodies_, s.executor);
  // What struck held bodies goes to their joints.
  if (s.held.take_strikes(bodies_)) s.joints->solve(JointPass::rates, s.executor);
}

}  // namespace rigor
