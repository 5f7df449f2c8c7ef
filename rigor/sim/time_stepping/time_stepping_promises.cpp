#include "rigor/sim/time_stepping/time_stepping_promises.hpp"

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/tolerances.hpp"

namespace rigor {

SchemePromises time_stepping_promises(const Model& model, const Method& method) {
  return {.joint_drift = projected_joint_drift(model.length_scale()),
          .penetration = method.contact_tolerance};
}

}  // namespace rigor
