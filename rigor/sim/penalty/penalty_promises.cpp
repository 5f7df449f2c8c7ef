#include "rigor/sim/penalty/penalty_promises.hpp"

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/tolerances.hpp"

#include <algorithm>

namespace rigor {

SchemePromises penalty_promises(const Model& model, const Method& method) {
  SchemePromises promises;
  // The energy of springs that steps of a fifth of their time scale integrate is a thousandth off.
  promises.energy_share = 1e-3;
  // Springs carry the weights of bodies at rest in many small impulses: their roundings add up.
  promises.weight_share = 1e-12;
  promises.joint_drift = projected_joint_drift(model.length_scale());
  promises.penetration_share = 0.25;
  // Several impacts at once press deeper than the one that a spring is made for; a spring of given stiffness
  // promises nothing.
  if (method.stiffness == 0)
    promises.penetration = std::max(method.contact_tolerance, 2 * method.penalty_depth);
  return promises;
}

}  // namespace rigor
