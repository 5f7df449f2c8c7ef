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

/// Rate at which a drag slows a body down: the faster of translation and rotation.
double rate_of_drag(const Body& body, double linear, double angular) {
  return std::max(linear / body.mass, angular / body.moments.minCoeff());
}

}  // namespace

PenaltyRates rates_of_forces(const Model& model) {
  std::vector<BodyRates> rates(model.bodies().size());
  PenaltyRates bound{};
  // Drag and damping of the bodies themselves.
  for (const Body& body : model.bodies()) {
    if (body.motion == MotionType::dynamic)
      bound.damping = std::max({bound.damping, rate_of_drag(body, body.linear_drag, body.angular_drag),
                                body.linear_damping, body.angular_damping});
  }
  // Springs add up at the bodies of their ends; drags act on one body each.
  for (const Force& force : model.forces()) {
    if (const Spring* const spring = std::get_if<Spring>(&force)) {
      add_end(model, *spring, spring->body_A, spring->p_AP, rates);
      add_end(model, *spring, spring->body_B, spring->p_BQ, rates);
    }
    const Drag* const drag = std::get_if<Drag>(&force);
    if (drag != nullptr && model.body(drag->body).motion == MotionType::dynamic)
      bound.damping =
          std::max(bound.damping, rate_of_drag(model.body(drag->body), drag->linear, drag->angular));
  }
  // ω² ≤ 2 max_b Σ_i k_i μ_ib, and likewise the rate of the dampers.
  for (const BodyRates& sums : rates) {
    bound.frequency = std::max(bound.frequency, std::sqrt(2 * sums.stiff));
    bound.damping = std::max(bound.damping, 2 * sums.damped);
  }
  return bound;
}

}  // namespace rigor
