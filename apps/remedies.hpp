#pragma once

#include "rigor/sim/audit/audit.hpp"

#include <string>
#include <vector>

namespace rigor {

/// A setting with which a run that failed may succeed.
struct Remedy {
  std::string setting;  ///< As of --set: "method.scheme=time-stepping".
  std::string meaning;  ///< Why, and what it costs, in one line.
};

/// What to set for a run that stopped or broke what its scheme promises, the best first; none if nothing
/// failed, or no setting helps. `tools/check_advice.py` tries them.
std::vector<Remedy> remedies_of(const Audit& audit);
/// The same as lines "  try --set SETTING: MEANING".
std::string remedies_text(const Audit& audit);

}  // namespace rigor
