#include "rigor/sim/islands/too_fast.hpp"

#include "rigor/core/index.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

Unresolved too_fast(const Model& model, const Environment& environment, const std::vector<int>& bodies,
                    const std::vector<BodyPhase>& phases, double h) {
  double fastest = -1;
  std::string what = "moves faster than numbers hold";
  int which = bodies.front();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = model.body(bodies[i]);
    const double turns = angular_velocity({body.mass, body.moments}, phases[i].q, phases[i].L).norm();
    const double swings = environment.stiff_rate(bodies[i]);
    if (!(std::max(turns, swings) > fastest)) continue;
    fastest = std::max(turns, swings);
    which = bodies[i];
    what = swings > turns
               ? fmt::format("can swing or settle at {:.3g} 1/s under its springs, dampers and drag", swings)
               : fmt::format("turns at {:.3g} rad/s", turns);
  }
  return {{which},
          fmt::format("body '{}' {}, which asks for steps of {:.2g} s", model.body(which).name, what, h)};
}

}  // namespace rigor
