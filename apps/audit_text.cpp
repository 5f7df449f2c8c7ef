#include "apps/audit_text.hpp"

#include "apps/remedies.hpp"
#include "apps/terminal.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/sim/method/method_use.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigor {

namespace {

/// Longer lists belong in a file.
constexpr std::size_t most_bodies = 10;
constexpr std::size_t most_spans = 10;

template <typename... Values>
void add_line(std::string& text, const char* title, fmt::format_string<const Values&...> format,
              const Values&... values) {
  fmt::format_to(std::back_inserter(text), "  {:<14}{}\n", title, fmt::format(format, values...));
}

/// The choices that apply to the schemes that carried the run.
std::string method_text(const Audit& audit) {
  std::string text;
  for (const std::string& key : method_choice_keys()) {
    if (!audit.uses(key)) continue;
    const bool is_several = key == "scheme" && audit.was_handed_over();
    const std::string value = is_several ? scheme_name(Scheme::automatic) : method_choice(audit.method, key);
    if (!value.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, value);
  }
  return text;
}

/// What work and dissipation consist of.
std::string energy_parts_text(const Audit& audit) {
  const AdvanceReport& report = audit.report;
  return fmt::format("{:.6g} J by motors; {:.6g} J to friction, {:.6g} J to impacts; {:.6g} J to springs",
                     report.motor_work, report.friction_loss, report.impact_loss - report.impact_gain,
                     audit.final.elastic - audit.initial.elastic);
}

/// Where `auto` handed over from one scheme to another: which carried what, how accurately, and why it ended.
void add_spans(const Audit& audit, std::string& text) {
  if (!audit.was_handed_over()) return;
  std::size_t shown = 0;
  for (const Audit::Span& span : audit.spans) {
    if (shown == most_spans) break;
    add_line(text, shown++ == 0 ? "spans" : "",
             "{:.6g} to {:.6g} s {}: {} impacts, at times known to {:.3g} s", span.of.begin, span.of.end,
             span.of.name(), span.of.impacts, audit.impact_time_error(span.of));
    const std::string overlap = std::isfinite(span.penetration)
                                    ? fmt::format("{:.3g} m", span.penetration)
                                    : fmt::format("{:.3g} of a body's thickness", span.penetration_share);
    // Without all of the work there is no rise to judge.
    const std::string rise = audit.knows_work ? fmt::format("{:.3g} J unexplained rise of at most {:.3g} J, ",
                                                            span.of.rise, span.most_rise)
                                              : std::string();
    add_line(text, "", "  {}penetration at most {}", rise, overlap);
    if (!span.of.end_cause.empty()) add_line(text, "", "  handed over: {}", span.of.end_cause);
  }
  if (audit.spans.size() > shown)
    add_line(text, "", "and {} more spans; --json has them all", audit.spans.size() - shown);
  add_line(text, "", "the whole run is judged by the weaker promises of all");
}

void add_motion(const Audit& audit, std::string& text) {
  const AdvanceReport& report = audit.report;
  add_line(text, "events", "{} impacts, {} came to rest, {} separations, {} slip to stick; {} steps",
           report.impacts, report.resting, report.separations, report.slip_to_stick, report.steps);
  add_line(text, "energy", "{:.9g} J at the start, {:.9g} J at the end", audit.initial.total(),
           audit.final.total());
  if (audit.knows_work) {
    add_line(text, "", "{:.9g} J work, {:.9g} J dissipated, {:.3g} J unexplained rise", report.work,
             audit.dissipated, audit.max_increase);
    add_line(text, "", "{}", energy_parts_text(audit));
  } else {
    add_line(
        text, "", "{}",
        "the work of motors, and of moved bodies on joints and springs, is not known to `solver: substep`");
  }
  add_line(text, "momentum", "error {:.3g} kg m/s linear, {:.3g} kg m²/s angular",
           audit.linear_momentum_error, audit.angular_momentum_error);
  if (report.penetration_A >= 0 && report.penetration_B >= 0) {
    const auto name = [&](int body) { return escaped_text(audit.bodies[at(body)].name); };
    add_line(text, "penetration", "{:.3g} m at most, of {} and {} at {:.6g} s", report.max_penetration,
             name(report.penetration_A), name(report.penetration_B), report.penetration_time);
  } else {
    add_line(text, "penetration", "{:.3g} m at most", report.max_penetration);
  }
  if (!audit.joints.empty()) {
    add_line(text, "joints", "off by {:.3g} at most{}; steps moved them by {:.3g} before they were corrected",
             report.max_joint_drift,
             at(report.drift_joint) >= audit.joints.size()
                 ? std::string()
                 : " at " + escaped_text(audit.joints[at(report.drift_joint)].name),
             report.max_joint_projection);
  }
  if (uses_choice(audit.method, "sleeping") && audit.method.sleeping)
    add_line(text, "sleeping", "{} bodies at the end", audit.sleeping_count);
  add_line(text, "impact times", "known to {:.3g} s", report.toi_bracket);
  add_line(text, "solver", "largest residual {:.3g}, at most {} iterations, {} fallbacks, {} coarse steps",
           report.max_residual, report.max_iterations, report.fallbacks, report.coarse_steps);
}

void add_bodies(const Audit& audit, std::string& text) {
  std::size_t shown = 0;
  for (const Audit::BodyEnd& body : audit.bodies) {
    if (shown == most_bodies) break;
    ++shown;
    const Vec3 &p = body.position, &v = body.velocity, &w = body.angular_velocity;
    const Quat& q = body.orientation;
    fmt::format_to(std::back_inserter(text), "  {}\n", escaped_text(body.name));
    fmt::format_to(std::back_inserter(text), "    position         [{:.9g}, {:.9g}, {:.9g}] m\n", p.x(),
                   p.y(), p.z());
    fmt::format_to(std::back_inserter(text), "    orientation      [{:.9g}, {:.9g}, {:.9g}, {:.9g}]\n", q.w(),
                   q.x(), q.y(), q.z());
    fmt::format_to(std::back_inserter(text), "    velocity         [{:.9g}, {:.9g}, {:.9g}] m/s\n", v.x(),
                   v.y(), v.z());
    fmt::format_to(std::back_inserter(text), "    angular velocity [{:.9g}, {:.9g}, {:.9g}] rad/s\n", w.x(),
                   w.y(), w.z());
  }
  if (audit.bodies.size() > shown) {
    fmt::format_to(std::back_inserter(text), "  and {} more bodies; --json has them all\n",
                   audit.bodies.size() - shown);
  }
}

std::string numbers_text(const std::vector<double>& numbers) {
  return fmt::format("{:.9g}", fmt::join(numbers, ", "));
}

void add_joints(const Audit& audit, std::string& text) {
  std::size_t shown = 0;
  for (const Audit::JointEnd& joint : audit.joints) {
    if (shown++ == most_bodies) break;
    fmt::format_to(std::back_inserter(text), "  joint {}\n", escaped_text(joint.name));
    if (!joint.coordinates.empty()) {
      fmt::format_to(std::back_inserter(text), "    coordinates      [{}], rates [{}]\n",
                     numbers_text(joint.coordinates), numbers_text(joint.rates));
    }
    if (!joint.efforts.empty())
      fmt::format_to(std::back_inserter(text), "    motor            [{}]\n", numbers_text(joint.efforts));
    const Vec3 &f = joint.force, &m = joint.torque;
    if (!f.allFinite()) {
      text += "    reaction         not known: in a group of more contacts than are solved for\n";
      continue;
    }
    fmt::format_to(std::back_inserter(text), "    reaction         [{:.9g}, {:.9g}, {:.9g}] N\n", f.x(),
                   f.y(), f.z());
    fmt::format_to(std::back_inserter(text), "                     [{:.9g}, {:.9g}, {:.9g}] N m\n", m.x(),
                   m.y(), m.z());
  }
  if (audit.joints.size() > most_bodies) {
    fmt::format_to(std::back_inserter(text), "  and {} more joints; --json has them all\n",
                   audit.joints.size() - most_bodies);
  }
}

void add_verdict(const Audit& audit, std::FILE* stream, std::string& text) {
  for (const std::string& warning : audit.warnings) {
    text += fmt::format("  {} {}\n", toned("warning:", Tone::doubtful, stream), escaped_lines(warning));
  }
  for (const std::string& violation : audit.violations) {
    text += fmt::format("  {} {}\n", toned("violated:", Tone::bad, stream), escaped_lines(violation));
  }
  // A run that ended early is judged until there, and says so.
  const std::string until =
      audit.is_complete() ? std::string()
                          : fmt::format(" until t = {:.6g} s of {:.6g} s", audit.end_time, audit.duration);
  const Tone good = audit.is_complete() ? Tone::good : Tone::doubtful;
  const char* const judged = audit.knows_work
                                 ? "energy, momentum, joints and penetration are within their tolerances"
                                 : "momentum, joints and penetration are within their tolerances; energy "
                                   "is not judged";
  text += audit.violations.empty()
              ? fmt::format("  {}: {}\n", toned("audit passed" + until, good, stream), judged)
              : fmt::format("  {}\n", toned("audit FAILED" + until, Tone::bad, stream));
  if (audit.report.reason == StopReason::reached_end) text += remedies_text(audit);
}

}  // namespace

std::string audit_text(const Audit& audit, std::FILE* stream) {
  const double speed = audit.wall_time > 0 ? audit.sim_time / audit.wall_time : 0;
  std::string text =
      fmt::format("{}: {:.6g} s simulated in {:.3g} s ({:.3g} times real time)\n",
                  toned(audit.scene, Tone::strong, stream), audit.sim_time, audit.wall_time, speed);
  add_line(text, "method", "{}", method_text(audit));
  if (!audit.scheme_reason.empty()) add_line(text, "scheme: auto", "{}", audit.scheme_reason);
  add_spans(audit, text);
  add_motion(audit, text);
  add_bodies(audit, text);
  add_joints(audit, text);
  add_verdict(audit, stream, text);
  return text;
}

}  // namespace rigor
