#pragma once

#include "rigor/sim/report/scheme_promises.hpp"

namespace rigor {

class Model;
struct Method;

/// What the method's scheme, which is not `automatic`, promises of this scene.
SchemePromises promises_of(const Model& model, const Method& method);

}  // namespace rigor
