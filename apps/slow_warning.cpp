#include "apps/slow_warning.hpp"

#include "rigor/sim/foreseen_work.hpp"
#include "rigor/sim/method/scheme_choice.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rigor {

std::string slow_warning(const Scene& scene, const State& start) {
  constexpr double soon = 60;
  const ForeseenWork work = foresee_work(scene.model, scene.method, scene.run, start);
  if (work.seconds <= soon) return {};
  const long minutes = std::lround(work.seconds / 60);
  return fmt::format(
      "{} will not end soon: by what lies on each other here it takes some {} minute{} or more; --set "
      "method.scheme=auto suits such a scene, and 'rigor check --estimate' measures the others",
      scheme_name(scene.method.scheme), minutes, minutes == 1 ? "" : "s");
}

}  // namespace rigor
