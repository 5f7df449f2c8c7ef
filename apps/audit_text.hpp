#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <cstdio>
#include <string>

namespace rigor {

/// The audit as lines for a reader; in colour if the stream to which they will be printed is a terminal.
std::string audit_text(const Audit& audit, std::FILE* stream);

}  // namespace rigor
