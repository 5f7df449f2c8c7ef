#pragma once

#include "rigor/sim/report/scheme_promises.hpp"

namespace rigor {

class Model;
struct Method;

/// What the schemes of this room promise: event-driven, impulse-based and hybrid.
SchemePromises event_driven_promises(const Model& model, const Method& method);

}  // namespace rigor
