#pragma once

#include "rigor/sim/report/scheme_promises.hpp"

namespace rigor {

class Model;
struct Method;

/// What time stepping with the solvers exact and pgs promises.
SchemePromises time_stepping_promises(const Model& model, const Method& method);

}  // namespace rigor
