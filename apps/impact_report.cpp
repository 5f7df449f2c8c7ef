#include "apps/impact_report.hpp"

#include "apps/terminal.hpp"
#include "rigor/core/range.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>
#include <numbers>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

std::string vector_text(const Vec3& v) {
  // Avoids -0, which means nothing to a reader.
  return fmt::format("[{}, {}, {}]", number_text(v.x() + 0.0), number_text(v.y() + 0.0),
                     number_text(v.z() + 0.0));
}
std::string line(const char* name, const std::string& text) {
  return fmt::format("  {:<12}{}\n", name, text);
}
Json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
/// JSON has no infinity.
Json json_of_number(double value) {
  return std::isinf(value) ? Json("inf") : Json(value);
}

// The contact

std::string scene_text(const SceneContact& scene) {
  const Contact& contact = scene.system.contacts[0];
  const Mat3& frame = scene.system.frames[0];
  std::string text =
      line("point", fmt::format("{} m (contact {} of {}), gap {} m", vector_text(contact.p_W()), scene.number,
                                scene.count, number_text(contact.point.gap)));
  text += line("normal",
               vector_text(frame.col(2)) + fmt::format(" from {} to {}", scene.names[0], scene.names[1]));
  return text + line("tangents", vector_text(frame.col(0)) + " and " + vector_text(frame.col(1)));
}

std::string stick_text(const CollisionMatrix& matrix) {
  const StickTest test = test_sticking(matrix);
  return fmt::format("{}: it needs friction {} of the normal force, mu is {}",
                     test.is_stable ? "stable" : "not stable", number_text(test.ratio),
                     number_text(matrix.mu));
}

std::string direction_text(const CollisionMatrix& matrix) {
  const std::vector<InvariantDirection> directions = invariant_directions_of(matrix);
  if (matrix.mu == 0)
    return line("directions", "without friction slip changes by the same in all directions");
  if (directions.empty()) return line("directions", "slip keeps its direction, whatever it is");
  std::string text;
  for (const InvariantDirection& direction : directions) {
    text += line(text.empty() ? "directions" : "", fmt::format("{:>8.3f} degrees: slip {} at {} m/s per N s",
                                                               direction.theta * 180 / std::numbers::pi,
                                                               direction.radial_rate > 0 ? "grows" : "dies",
                                                               number_text(std::abs(direction.radial_rate))));
  }
  return text;
}

std::string problem_text(const GivenImpact& problem) {
  const Collision& collision = problem.collision;
  const Mat3& K = collision.matrix.K;
  const std::string title =
      problem.scene ? fmt::format("impact of {} and {}", problem.scene->names[0], problem.scene->names[1])
                    : "impact";
  std::string text = toned(title, Tone::strong, stdout) + "\n";
  if (problem.scene) text += scene_text(*problem.scene);
  for (int row = 0; row < 3; ++row)
    text += line(row == 0 ? "K" : "", vector_text(K.row(row)) + (row == 2 ? " 1/kg" : ""));
  text += line("condition", number_text(condition_number(K)));
  text += line("velocity", vector_text(collision.u) + " m/s before, of B against A");
  text += line("mu, e", number_text(collision.matrix.mu) + ", " + number_text(collision.restitution));
  text += line("sticking", stick_text(collision.matrix)) + direction_text(collision.matrix);
  const double energy = removable_energy(K, collision.u);
  text +=
      line("energy", std::isfinite(energy) ? number_text(energy) + " J at most can be lost at this contact"
                                           : "K is singular: the energy that can be lost is not known");
  return text;
}

// The laws

/// Kinetic energy of the bodies before and after, and the velocities after.
ContactSystem after_impact(const SceneContact& scene, const LawResult& result) {
  ContactSystem system = scene.system;
  apply_impulses(result.end.lambda, system);
  return system;
}

/// Indices of A and B in the lists of the system.
std::array<std::size_t, 2> places_of(const ContactSystem& system) {
  const Contact& contact = system.contacts[0];
  return {static_cast<std::size_t>(system.local_index(contact.body_A)),
          static_cast<std::size_t>(system.local_index(contact.body_B))};
}

std::string bodies_text(const SceneContact& scene, const LawResult& result) {
  const ContactSystem after = after_impact(scene, result);
  std::string text =
      line("", fmt::format("kinetic {} J before, {} J after", number_text(kinetic_energy(scene.system)),
                           number_text(kinetic_energy(after))));
  const double work = work_of_prescribed(scene.system, result.end.lambda);
  if (work != 0) text += line("", fmt::format("work of the moving body {} J", number_text(work)));
  for (std::size_t side = 0; side < 2; ++side) {
    const BodyKinetics& body = after.kinetics[places_of(after)[side]];
    if (body.inverse_mass == 0) continue;
    text += line(side == 0 ? "A after" : "B after",
                 fmt::format("{}: velocity {} m/s, angular velocity {} rad/s", scene.names[side],
                             vector_text(body.v), vector_text(body.w)));
  }
  return text;
}

std::string path_text(const LawResult& result) {
  if (result.algebraic) {
    const AlgebraicOutcome& outcome = *result.algebraic;
    return line("path",
                fmt::format("none; the share of the sticking impulse is {}{}", number_text(outcome.share),
                            outcome.is_limited ? ", limited by friction" : ""));
  }
  std::string text =
      line("phases", (result.phases.empty() ? "" : result.phases + ": ") + phases_in_words(result.phases));
  if (result.compression) {
    text += line("work", fmt::format("of the normal impulse: {} J in compression, {} J at the end",
                                     number_text(result.compression->work), number_text(result.end.work)));
  }
  return text;
}

std::string law_text(const GivenImpact& problem, const LawResult& result) {
  std::string text = toned(law_title(result.law), Tone::strong, stdout) + "\n";
  text += line("velocity", vector_text(result.end.u) + " m/s after");
  text += line("impulse", vector_text(result.end.lambda) + " N s on B");
  text += path_text(result);
  text += line("energy", number_text(result.energy_change) + " J change");
  return problem.scene ? text + bodies_text(*problem.scene, result) : text;
}

Json json_of_contact(const SceneContact& scene) {
  const Contact& contact = scene.system.contacts[0];
  const Mat3& frame = scene.system.frames[0];
  return {{"bodies", {scene.names[0], scene.names[1]}},
          {"contact", scene.number},
          {"contacts", scene.count},
          {"point", json_of(contact.p_W())},
          {"gap", contact.point.gap},
          {"tangent_1", json_of(frame.col(0))},
          {"tangent_2", json_of(frame.col(1))},
          {"normal", json_of(frame.col(2))},
          {"kinetic_energy", kinetic_energy(scene.system)}};
}

Json json_of_bodies(const SceneContact& scene, const LawResult& result) {
  const ContactSystem after = after_impact(scene, result);
  Json json = {{"kinetic_energy", kinetic_energy(after)},
               {"work_of_moving_body", work_of_prescribed(scene.system, result.end.lambda)}};
  for (std::size_t side = 0; side < 2; ++side) {
    const BodyKinetics& body = after.kinetics[places_of(after)[side]];
    json[side == 0 ? "A" : "B"] = {{"velocity", json_of(body.v)}, {"angular_velocity", json_of(body.w)}};
  }
  return json;
}

Json json_of_result(const GivenImpact& problem, const LawResult& result) {
  Json json = {{"velocity", json_of(result.end.u)},
               {"impulse", json_of(result.end.lambda)},
               {"energy_change", result.energy_change}};
  if (result.algebraic) {
    json["share"] = result.algebraic->share;
    json["is_limited_by_friction"] = result.algebraic->is_limited;
  } else {
    json["phases"] = result.phases;
    json["phases_in_words"] = phases_in_words(result.phases);
    json["work"] = result.end.work;
  }
  if (result.compression) {
    json["compression"] = {{"velocity", json_of(result.compression->u)},
                           {"impulse", json_of(result.compression->lambda)},
                           {"work", result.compression->work}};
  }
  if (problem.scene) json["after"] = json_of_bodies(*problem.scene, result);
  return json;
}

/// Relative to the energy that can be lost, otherwise to the work of friction and the normal impulse, so that
/// rounding does not count as a gain.
bool gains_energy(const GivenImpact& problem, const LawResult& result) {
  constexpr double rounding = 1e-12;
  const Vec3& u = problem.collision.u;
  return result.energy_change > rounding * result.end.lambda.norm() * (u.norm() + result.end.u.norm());
}

}  // namespace

std::vector<InvariantDirection> invariant_directions_of(const CollisionMatrix& matrix) {
  SlipFlow flow(matrix);
  if (!std::isfinite(flow.mu)) flow.mu = 1, flow.drive = 0;
  return find_invariant_directions(flow);
}

std::string impact_text(const ImpactReport& report) {
  std::string text = problem_text(report.problem);
  for (const LawResult& result : report.results) text += law_text(report.problem, result);
  return text;
}

Json impact_json(const ImpactReport& report) {
  const Collision& collision = report.problem.collision;
  const Mat3& K = collision.matrix.K;
  const StickTest sticking = test_sticking(collision.matrix);
  Json directions = Json::array(), laws = Json::object();
  for (const InvariantDirection& direction : invariant_directions_of(collision.matrix)) {
    directions.push_back({{"angle", direction.theta},
                          {"is_growing", direction.radial_rate > 0},
                          {"slip_rate", direction.radial_rate},
                          {"normal_rate", direction.normal_rate}});
  }
  for (const LawResult& result : report.results) laws[result.law] = json_of_result(report.problem, result);
  Json json = {{"K", {json_of(K.row(0)), json_of(K.row(1)), json_of(K.row(2))}},
               {"condition", json_of_number(condition_number(K))},
               {"velocity", json_of(collision.u)},
               {"mu", json_of_number(collision.matrix.mu)},
               {"e", collision.restitution},
               {"removable_energy", json_of_number(removable_energy(K, collision.u))},
               {"sticking", {{"ratio", json_of_number(sticking.ratio)}, {"is_stable", sticking.is_stable}}},
               {"invariant_directions", directions}};
  if (report.problem.scene) json["scene"] = json_of_contact(*report.problem.scene);
  json["laws"] = laws;
  return json;
}

std::string impact_table(const ImpactReport& report) {
  std::string table = "law,normal_impulse,v_x,v_y,v_z,impulse_x,impulse_y,impulse_z,work,phase,slip\n";
  const auto out = std::back_inserter(table);
  const auto add_row = [&](const std::string& law, const CollisionPoint& at, const std::string& states) {
    fmt::format_to(out, "{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{}\n", law,
                   at.lambda.z(), at.u.x(), at.u.y(), at.u.z(), at.lambda.x(), at.lambda.y(), at.lambda.z(),
                   std::isfinite(at.work) ? fmt::format("{:.17g}", at.work) : "", states);
  };
  for (const LawResult& result : report.results) {
    for (const ImpactPathPoint& point : result.path) {
      add_row(result.law, point.at,
              fmt::format("{},{}", point.is_compressing ? "compression" : "restitution",
                          point.is_sliding ? "slides" : "sticks"));
    }
    if (!result.path.empty()) continue;
    CollisionPoint before;
    before.u = report.problem.collision.u;
    add_row(result.law, before, ",");
    add_row(result.law, result.end, ",");
  }
  return table;
}

std::vector<std::string> impact_warnings(const ImpactReport& report) {
  std::vector<std::string> warnings;
  for (const LawResult& result : report.results) {
    if (gains_energy(report.problem, result)) {
      warnings.push_back(
          fmt::format("the law {} gains {:.6g} J of energy here: with friction Newton's "
                      "restitution can; those of Poisson and Stronge never do",
                      result.law, result.energy_change));
    }
  }
  if (!report.results.empty() && report.results[0].end.lambda.isZero(0))
    warnings.push_back("the bodies do not approach at this contact: there is no impact");
  return warnings;
}

}  // namespace rigor
