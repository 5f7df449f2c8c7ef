#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <string>

namespace rigor {

/// The audit as JSON (docs/output.md lists the keys, in their order). Numbers have 17 significant digits;
/// quantities that are not computed are null. Violated tolerances come first among the warnings, as
/// "violated: ...".
std::string audit_json(const Audit& audit);

}  // namespace rigor
