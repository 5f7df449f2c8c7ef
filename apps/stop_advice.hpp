#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Name of the reason as docs/errors.md lists it: "events_accumulate".
std::string_view stop_reason_name(StopReason reason);
/// Advice for a run that stopped for this reason, in one line, as in docs/errors.md.
std::string_view stop_advice(StopReason reason);
/// Why the run with this audit stopped at that time [s], which bodies were involved, and what to try; empty
/// if it reached its end.
std::string stop_text(const Audit& audit, double time);

}  // namespace rigor
