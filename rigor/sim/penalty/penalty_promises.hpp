#pragma once

#include "rigor/sim/report/scheme_promises.hpp"

namespace rigor {

class Model;
struct Method;

/// What the penalty scheme promises, with local and with global springs.
SchemePromises penalty_promises(const Model& model, const Method& method);

}  // namespace rigor
