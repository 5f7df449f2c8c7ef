#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/method/scheme_choice.hpp"

#include <memory>

namespace rigor {

/// The stepper of the method's scheme, or of the one that `auto` stands for. target_step H > 0 [s] is the
/// longest step; threads >= 1 is for schemes that use several, whose results do not depend on it.
std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const Method& method,
                                      double target_step, int threads = 1);
/// The same of a choice that is known: resolve_scheme() looks at the contacts at t = 0.
std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const ResolvedMethod& choice,
                                      double target_step, int threads = 1);

}  // namespace rigor
