#include "apps/slow_warning.hpp"

#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/work_estimate.hpp"

#include <fmt/format.h>

namespace rigor {

std::string slow_warning(const Scene& scene, const State& start) {
  constexpr double soon = 60;
  const WorkEstimate work = estimate_work(scene.model, scene.method, scene.run, start);
  if (work.seconds <= soon) return {};
  return fmt::format(
      "{} may not end soon: by what lies on each other here it is foreseen to take more than a minute; --set "
      "method.scheme=auto suits such a scene, and 'rigor check --estimate' measures the others",
      scheme_name(scene.method.scheme));
}

}  // namespace rigor
