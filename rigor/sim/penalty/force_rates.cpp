#include "rigor/sim/penalty/force_rates.hpp"

#include "rigor/core/index.hpp"
#include "rigor/model/joint_traits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigor {

namespace {

/// Sums of k μ and c μ at one body.
struct BodyRates {
  double stiff = 0, damped = 0;
};

/// Adds what one end of a spring contributes to the sums of its body, with μ = 1/m + r²/I.
void add_end(const Model& model, const Spring& spring, int body, const Vec3& p_BP,
             std::vector<BodyRates>& rates) {
  if (body == world_body || model.body(body).motion != MotionType::dynamic) return;
  const Body& of_end = model.body(body);
  const double mobility = 1 / of_end.mass + p_BP.squaredNorm() / of_end.moments.minCoeff();
  BodyRates& sums = rates[at(body)];
  sums.stiff += spring.stiffness * mobility;
  sums.damped += spring.damping * mobility;
}

/// About a direction that turns with the body nothing is more mobile than about the axis of the least moment.
double turning_mobility(const Body& body, bool is_about_z, const Mat3& R_BF) {
  if (!is_about_z) return 1 / body.moments.minCoeff();
  return R_BF.col(2).cwiseAbs2().cwiseQuotient(body.moments).sum();
}

/// Adds what the laws of a joint contribute to the sums of its body on one side, where its frame F is. What
/// its other rows hold makes the bodies less mobile than they are by themselves.
void add_joint(const Model& model, const Joint& joint, int body, const Pose& X_BF,
               std::vector<BodyRates>& rates) {
  if (body == world_body || model.body(body).motion != MotionType::dynamic) return;
  const Body& of_side = model.body(body);
  for (std::size_t k = 0; k < joint.axes.size(); ++k) {
    const CoordinateType coordinate = joint_traits(joint.type).coordinate_list[k];
    const double mobility = is_angle(coordinate)
                                ? turning_mobility(of_side, coordinate == CoordinateType::twist, X_BF.R)
                                : 1 / of_side.mass + X_BF.p.squaredNorm() / of_side.moments.minCoeff();
    BodyRates& sums = rates[at(body)];
    sums.stiff += joint.axes[k].stiffness * mobility;
    sums.damped += joint.axes[k].damping * mobility;
  }
}

/// Rate at which drag slows a body down: the faster of translation and rotation.
double rate_of_drag(const Body& body, const Environment::DragRates& drag) {
  return std::max(drag.linear / body.mass, drag.angular / body.moments.minCoeff() + drag.angular_damping);
}

}  // namespace

bool drags_in_closed_form(const Model& model, const Environment& environment, int body, double target_step) {
  constexpr double most_steps = 100;
  if (model.body(body).motion != MotionType::dynamic || !environment.has_drag(body)) return false;
  const double rate = rate_of_drag(model.body(body), environment.drag(body));
  return !environment.is_jointed(body) || rate * target_step > most_steps;
}

PenaltyRates rates_of_forces(const Model& model, const Environment& environment, double target_step) {
  std::vector<BodyRates> rates(model.bodies().size());
  PenaltyRates bound{};
  // Drag and damping.
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion == MotionType::dynamic && !drags_in_closed_form(model, environment, i, target_step))
      bound.damping = std::max(bound.damping, rate_of_drag(body, environment.drag(i)));
  }
  // Springs add up at the bodies of their ends.
  for (const Force& force : model.forces()) {
    if (const Spring* const spring = std::get_if<Spring>(&force)) {
      add_end(model, *spring, spring->body_A, spring->p_AP, rates);
      add_end(model, *spring, spring->body_B, spring->p_BQ, rates);
    }
  }
  for (const Joint& joint : model.joints()) {
    add_joint(model, joint, joint.body_A, joint.X_AF, rates);
    add_joint(model, joint, joint.body_B, joint.X_BK, rates);
  }
  // ω² ≤ 2 max_b Σ_i k_i μ_ib, and likewise the rate of the dampers.
  for (const BodyRates& sums : rates) {
    bound.frequency = std::max(bound.frequency, std::sqrt(2 * sums.stiff));
    bound.damping = std::max(bound.damping, 2 * sums.damped);
  }
  return bound;
}

}  // namespace rigor
