#include "apps/stop_advice.hpp"

#include "apps/remedies.hpp"

#include "rigor/core/index.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

std::string_view stop_reason_name(StopReason reason) {
  switch (reason) {
    case StopReason::reached_end:
      return "reached_end";
    case StopReason::events_accumulate:
      return "events_accumulate";
    case StopReason::impact_unsolved:
      return "impact_unsolved";
    case StopReason::not_finite:
      return "not_finite";
    case StopReason::unresolved:
      return "unresolved";
    case StopReason::interrupted:
      return "interrupted";
    case StopReason::broken_promise:
      return "broken_promise";
  }
  return "";
}

std::string_view stop_advice(StopReason reason) {
  switch (reason) {
    case StopReason::reached_end:
      return "nothing: the run is complete";
    case StopReason::events_accumulate:
      return "raise method.resting_velocity, lower the restitution of the bodies' materials, or look for "
             "bodies that are "
             "squeezed between others";
    case StopReason::impact_unsolved:
      return "set method.simultaneous to another of its choices (reflections, lcp, sequential, projection, "
             "moreau), or look for a "
             "body that is squeezed between two that cannot give way";
    case StopReason::not_finite:
      return "look for stiff springs, huge forces or velocities at these bodies; a smaller run.step or "
             "method.integrator=dopri5 helps with stiff ones";
    case StopReason::unresolved:
      return "lower the stiffness, damping, force, torque or speed of a motor that acts on these bodies, "
             "make light ones "
             "heavier, or set a run.step as short as the motion asks for";
    case StopReason::interrupted:
      return "run it again, or continue from the checkpoint with --resume";
    case StopReason::broken_promise:
      return "report this defect of the program with the scene; meanwhile another method.scheme or run.step "
             "may go round it";
  }
  return "";
}

std::string stop_text(const Audit& audit, double time) {
  const AdvanceReport& report = audit.report;
  if (report.reason == StopReason::reached_end) return {};
  constexpr std::size_t most_names = 10;
  const std::size_t count = report.bodies.size();
  std::string text = fmt::format("the simulation stopped at t = {:.9g} s ({}): {}", time,
                                 stop_reason_name(report.reason), report.detail);
  for (std::size_t i = 0; i < std::min(count, most_names); ++i) {
    text += i == 0 ? "\n  bodies: " : ", ";
    text += audit.bodies[at(report.bodies[i])].name;
  }
  if (count > most_names) text += fmt::format(" and {} more", count - most_names);
  text += fmt::format("\n  what to try: {}", stop_advice(report.reason));
  std::string remedies = remedies_text(audit);
  if (!remedies.empty()) text += "\n" + remedies.substr(0, remedies.size() - 1);
  return text;
}

}  // namespace rigor
