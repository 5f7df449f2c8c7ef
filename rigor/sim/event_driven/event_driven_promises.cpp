#include "rigor/sim/event_driven/event_driven_promises.hpp"

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/tolerances.hpp"

namespace rigor {

SchemePromises event_driven_promises(const Model& model, const Method& method) {
  return {.acts_in_steps = method.scheme != Scheme::event_driven,
          .joint_drift = projected_joint_drift(model.length_scale()),
          .penetration = method.contact_tolerance};
}

}  // namespace rigor
