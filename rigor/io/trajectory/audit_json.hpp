#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <string>

namespace rigor {

/// The audit as JSON (docs/output.md lists the keys, in their order). Numbers have 17 significant digits;
/// what is not computed is null. What broke its tolerance comes first among the warnings, as "violated: ...".
std::string audit_json(const Audit& audit);

}  // namespace rigor
