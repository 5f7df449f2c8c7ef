#include "rigor/io/trajectory/audit_json.hpp"

#include "rigor/core/index.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/audit_tree.hpp"
#include "rigor/sim/method/method_use.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// The choices that the schemes read which carried the run.
Json method_json(const Audit& audit) {
  const Method& method = audit.method;
  Json json = Json::object();
  for (const std::string& key : method_choice_keys()) {
    if (!audit.uses(key)) continue;
    // Choices of later versions have no value yet.
    const std::string value = method_choice(method, key);
    if (!value.empty()) json[key] = value;
  }
  if (audit.was_handed_over()) json["scheme"] = scheme_name(Scheme::automatic);
  for (const MethodNumber& number : method_numbers()) json[std::string(number.key)] = method.*number.member;
  return json;
}

/// A quantity of the balance of the energy: without all of the work there is none.
Json balance_json(const Audit& audit, double value) {
  return audit.knows_work ? Json(value) : Json(nullptr);
}

Json spans_json(const Audit& audit) {
  Json json = Json::array();
  for (const Audit::Span& span : audit.spans) {
    Method of_span = audit.method;
    of_span.solver = span.of.solver;
    const Json rise = balance_json(audit, span.of.rise), most_rise = balance_json(audit, span.most_rise);
    json.push_back({{"scheme", scheme_name(span.of.scheme)},
                    {"solver", method_choice(of_span, "solver")},
                    {"begin", span.of.begin},
                    {"end", span.of.end},
                    {"impacts", span.of.impacts},
                    {"impact_time_error", audit.impact_time_error(span.of)},
                    {"energy_increase", {{"max", rise}, {"tolerance", most_rise}}},
                    {"penetration_tolerance", nullptr},
                    {"penetration_tolerance_of_thickness", span.penetration_share},
                    {"joint_drift_tolerance", span.joint_drift},
                    {"end_cause", nullptr}});
    if (std::isfinite(span.penetration)) json.back()["penetration_tolerance"] = span.penetration;
    if (!span.of.end_cause.empty()) json.back()["end_cause"] = span.of.end_cause;
  }
  return json;
}

Json penetration_json(const Audit& audit) {
  const AdvanceReport& report = audit.report;
  Json json = {{"max", report.max_penetration},
               {"bodies", nullptr},
               {"time", nullptr},
               {"of_thickness", report.worst_overlap.share}};
  if (report.penetration_A < 0 || report.penetration_B < 0) return json;
  json["bodies"] = {audit.bodies[at(report.penetration_A)].name, audit.bodies[at(report.penetration_B)].name};
  json["time"] = report.penetration_time;
  return json;
}

Json joint_drift_json(const Audit& audit) {
  const AdvanceReport& report = audit.report;
  Json json = {
      {"max", report.max_joint_drift}, {"joint", nullptr}, {"projected", report.max_joint_projection}};
  if (report.drift_joint >= 0) json["joint"] = audit.joints[at(report.drift_joint)].name;
  return json;
}

Json joints_json(const Audit& audit) {
  Json json = Json::object();
  for (const Audit::JointEnd& joint : audit.joints) {
    json[joint.name] = {{"coordinates", joint.coordinates},
                        {"rates", joint.rates},
                        {"force", json_of(joint.force)},
                        {"torque", json_of(joint.torque)}};
    if (!joint.efforts.empty()) json[joint.name]["efforts"] = joint.efforts;
  }
  return json;
}

Json warnings_json(const Audit& audit) {
  Json json = Json::array();
  for (const std::string& violation : audit.violations)
    json.push_back(fmt::format("violated: {}", violation));
  for (const std::string& warning : audit.warnings) json.push_back(warning);
  return json;
}

/// Names are unique, so each entry is appended: looking for an equal one would take time in proportion to
/// the square of the number of bodies.
Json bodies_json(const Audit& audit) {
  Json json = Json::object();
  for (const Audit::BodyEnd& body : audit.bodies) {
    const Quat& q = body.orientation;
    json.get_ref<Json::object_t&>().emplace_back(body.name,
                                                 Json{{"position", json_of(body.position)},
                                                      {"orientation", {q.w(), q.x(), q.y(), q.z()}},
                                                      {"velocity", json_of(body.velocity)},
                                                      {"angular_velocity", json_of(body.angular_velocity)}});
  }
  return json;
}

Json energy_json(const Audit& audit) {
  const AdvanceReport& report = audit.report;
  return {{"initial", audit.initial.total()},
          {"final", audit.final.total()},
          {"work", balance_json(audit, report.work)},
          {"motor_work", balance_json(audit, report.motor_work)},
          {"dissipated", balance_json(audit, audit.dissipated)},
          {"friction_loss", report.friction_loss},
          {"impact_loss", report.impact_loss - report.impact_gain},
          {"elastic", {audit.initial.elastic, audit.final.elastic}},
          {"max_increase", balance_json(audit, audit.max_increase)}};
}

}  // namespace

std::string audit_json(const Audit& audit) {
  return json_text(audit_tree(audit));
}

Json audit_tree(const Audit& audit) {
  const AdvanceReport& report = audit.report;
  Json json;
  json["rigor"] = version;
  json["scene"] = audit.scene;
  json["method"] = method_json(audit);
  if (!audit.scheme_reason.empty()) json["scheme_reason"] = audit.scheme_reason;
  if (!audit.spans.empty()) json["spans"] = spans_json(audit);
  json["complete"] = audit.is_complete();
  json["end_time"] = audit.end_time;
  json["duration"] = audit.duration;
  json["sim_time"] = audit.sim_time;
  json["wall_time"] = audit.wall_time;
  json["steps"] = report.steps;
  json["events"] = {{"impacts", report.impacts},
                    {"resting", report.resting},
                    {"separations", report.separations},
                    {"slip_to_stick", report.slip_to_stick}};
  json["energy"] = energy_json(audit);
  json["linear_momentum_error"] = audit.linear_momentum_error;
  json["angular_momentum_error"] = audit.angular_momentum_error;
  json["penetration"] = penetration_json(audit);
  json["joint_drift"] = joint_drift_json(audit);
  if (audit.method.sleeping) json["sleeping"] = audit.sleeping_count;
  json["toi_bracket"] = report.toi_bracket;
  json["solver"] = {{"max_residual", report.max_residual},
                    {"max_iterations", report.max_iterations},
                    {"fallbacks", report.fallbacks},
                    {"coarse_steps", report.coarse_steps}};
  json["warnings"] = warnings_json(audit);
  json["bodies"] = bodies_json(audit);
  if (!audit.joints.empty()) json["joints"] = joints_json(audit);
  return json;
}

}  // namespace rigor
