#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <nlohmann/json_fwd.hpp>

namespace rigor {

/// What audit_json() writes, as a tree.
nlohmann::ordered_json audit_tree(const Audit& audit);

}  // namespace rigor
