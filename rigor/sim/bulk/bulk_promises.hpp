#pragma once

#include "rigor/sim/report/scheme_promises.hpp"

namespace rigor {

class Model;

/// What time stepping with the solver substep promises.
SchemePromises bulk_promises(const Model& model);

}  // namespace rigor
