#include "rigor/sim/method/resting_choice.hpp"

#include "rigor/sim/method/tolerances.hpp"

namespace rigor {

RestingChoice resting_choice(const Method& method) {
  return {method.resting == RestingMethod::motion_space ? RestingSpace::motion : RestingSpace::contact,
          method.lcp == LcpMethod::dantzig ? LcpName::dantzig : LcpName::lemke};
}

double direction_tolerance(const Method& method) {
  return 1e-3 * method.resting_velocity;
}

double slip_tolerance(const Method& method) {
  // Soft steps in 32 bits leave micrometres a second of what rests: friction of a slip would be told.
  if (method.solver == SolverMethod::substep) return method.resting_velocity;
  return still_speed(method.resting_velocity);
}

double parting_tolerance(const Method& method) {
  // A plate whose joints leave it a micrometre a second under a heavy box would carry it on one edge.
  if (method.solver == SolverMethod::substep) return method.resting_velocity;
  return parting_speed(method.resting_velocity);
}

}  // namespace rigor
