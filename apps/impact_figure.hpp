#pragma once

#include "apps/impact_report.hpp"
#include "rigor/view/plot/drawing.hpp"

namespace rigor {

/// The paths of the laws side by side in the plane of the tangential velocity, with the invariant directions,
/// and below them the energy that each law dissipates.
Drawing impact_figure(const ImpactReport& report);

}  // namespace rigor
