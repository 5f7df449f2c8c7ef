#pragma once

#include "rigor/sim/advance_report.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Name of the reason as docs/errors.md lists it: "events_accumulate".
std::string_view stop_reason_name(StopReason reason);
/// What a user can try when a run stopped for this reason; one line. docs/errors.md says the same.
std::string_view stop_advice(StopReason reason);
/// Why a run stopped, when, which bodies, and what to try; empty if it reached its end.
std::string stop_text(const AdvanceReport& report, double time, const std::vector<std::string>& bodies);

}  // namespace rigor
