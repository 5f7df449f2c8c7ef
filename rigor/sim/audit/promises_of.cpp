#include "rigor/sim/audit/promises_of.hpp"

#include "rigor/sim/bulk/bulk_promises.hpp"
#include "rigor/sim/event_driven/event_driven_promises.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/penalty/penalty_promises.hpp"
#include "rigor/sim/time_stepping/time_stepping_promises.hpp"

namespace rigor {

SchemePromises promises_of(const Model& model, const Method& method) {
  if (method.scheme == Scheme::penalty) return penalty_promises(model, method);
  if (method.scheme != Scheme::time_stepping) return event_driven_promises(model, method);
  return method.solver == SolverMethod::substep ? bulk_promises(model)
                                                : time_stepping_promises(model, method);
}

}  // namespace rigor
