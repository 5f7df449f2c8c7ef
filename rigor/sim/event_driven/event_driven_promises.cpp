#include "rigor/sim/event_driven/event_driven_promises.hpp"

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/tolerances.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Ten times the error of a step where it is controlled; integrators of fixed order are as good as their
/// steps.
double energy_share(const Method& method) {
  switch (method.integrator) {
    case IntegratorMethod::exact:
    case IntegratorMethod::dopri5:
    case IntegratorMethod::dop853:
      return std::max(1e-9, 10 * method.tolerance);
    case IntegratorMethod::euler:
    case IntegratorMethod::semi_implicit_euler:
    case IntegratorMethod::midpoint:
    case IntegratorMethod::rk4:
    case IntegratorMethod::lie_rk4:
      break;
  }
  return 1e-6;
}

}  // namespace

SchemePromises event_driven_promises(const Model& model, const Method& method) {
  return {.acts_in_steps = method.scheme != Scheme::event_driven,
          .energy_share = energy_share(method),
          .joint_drift = projected_joint_drift(model.length_scale()),
          .penetration = method.contact_tolerance};
}

}  // namespace rigor
