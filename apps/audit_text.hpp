#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <cstdio>
#include <string>

namespace rigor {

/// The audit as lines for a reader; colours if the stream, where it will be printed, is a terminal.
std::string audit_text(const Audit& audit, std::FILE* stream);

}  // namespace rigor
