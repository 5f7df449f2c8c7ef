#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

// Numbers of the audit of a run, by name: a short one ("impacts", "dissipated"), or a path through the keys
// of its JSON with points between them ("energy.motor_work", "solver.max_residual", "joints.axle.efforts.0").

/// Whether audits of a model have a number of this name.
bool has_audit_quantity(const Model& model, std::string_view name);
/// All names, to suggest one.
std::vector<std::string> audit_quantity_names(const Model& model);
/// The number; NaN if the audit says that it is not known, and 0 or 1 of what is true or not.
double audit_quantity(const Audit& audit, std::string_view name);

}  // namespace rigor
