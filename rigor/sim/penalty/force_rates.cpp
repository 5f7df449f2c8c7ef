#include "rigor/sim/penalty/force_rates.hpp"

#include "rigor/core/index.hpp"

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
  // ω² ≤ 2 max_b Σ_i k_i μ_ib, and likewise the rate of the dampers.
  for (const BodyRates& sums : rates) {
    bound.frequency = std::max(bound.frequency, std::sqrt(2 * sums.stiff));
    bound.damping = std::max(bound.damping, 2 * sums.damped);
  }
  return bound;
}

}  // namespace rigor
