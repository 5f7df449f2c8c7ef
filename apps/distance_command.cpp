#include "apps/commands.hpp"
#include "apps/scene_question.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/contacts/contact_shape.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/distance_cache.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/mesh_penetration/mesh_penetration.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

/// Shapes of the two bodies, by their indices.
struct ShapePair {
  std::size_t a, b;
};
struct PairContact {
  ShapePair shapes;
  ContactPoint point;
};
struct PairDistance {
  ShapePair shapes;
  DistanceResult distance;
};
struct BodyDistance {
  std::vector<PairDistance> pairs;  ///< All pairs of shapes.
  PairDistance nearest;
  std::vector<PairContact> contacts;
};

/// Throws InputError for a pair of shapes whose distance is not defined here.
void check_pair(const BodyShape& a, const BodyShape& b) {
  if (is_unbounded(a.shape) && is_unbounded(b.shape)) {
    throw InputError(fmt::format("shapes of type '{}' and '{}' have no distance: both are without an end",
                                 shape_type_name(a.shape), shape_type_name(b.shape)));
  }
}

DistanceResult shape_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                              DistanceMethod method) {
  DistanceCache cache;
  const DistanceResult found = method == DistanceMethod::lin_canny ? walked_distance(a, X_WA, b, X_WB, cache)
                                                                   : signed_distance(a, X_WA, b, X_WB);
  return found.distance < 0 && are_solid(a, b) ? solid_distance(a, X_WA, b, X_WB) : found;
}

BodyDistance body_distance(const Scene& scene, int body_A, int body_B, double tolerance) {
  const Model& model = *scene.model;
  const State state = make_initial_state(model);
  const Body &A = model.body(body_A), &B = model.body(body_B);
  for (const Body* body : {&A, &B}) {
    if (body->shapes.empty()) throw InputError(fmt::format("body {} has no shapes", quoted_text(body->name)));
  }
  const Pose X_WA{rotation_matrix(state.orientation(body_A)), state.position(body_A)};
  const Pose X_WB{rotation_matrix(state.orientation(body_B)), state.position(body_B)};
  BodyDistance result{};
  for (std::size_t a = 0; a < A.shapes.size(); ++a) {
    for (std::size_t b = 0; b < B.shapes.size(); ++b) {
      check_pair(A.shapes[a], B.shapes[b]);
      const Pose X_WS = X_WA * A.shapes[a].X_BS, X_WT = X_WB * B.shapes[b].X_BS;
      const DistanceResult found =
          shape_distance(A.shapes[a].shape, X_WS, B.shapes[b].shape, X_WT, scene.method.distance);
      const PairDistance pair{{a, b}, found};
      if (result.pairs.empty() || found.distance < result.nearest.distance.distance) result.nearest = pair;
      result.pairs.push_back(pair);
      for (const ContactPoint& point :
           contact_set(A.shapes[a].shape, X_WS, B.shapes[b].shape, X_WT, tolerance)) {
        result.contacts.push_back({{a, b}, point});
      }
    }
  }
  return result;
}

std::string name_of(const Feature& feature) {
  static constexpr std::array names = {"vertex", "edge", "face", "side"};
  const std::string name = fmt::format("{} {}", names[at(feature.kind)], feature.index);
  return feature.part == 0 ? name : fmt::format("{}.{}", name, feature.part);
}

std::string text_of(const BodyDistance& found, const Body& A, const Body& B, double tolerance) {
  const DistanceResult& d = found.nearest.distance;
  std::string text = fmt::format("{} to {}: distance {:.9g} m\n", toned(A.name, Tone::strong, stdout),
                                 toned(B.name, Tone::strong, stdout), d.distance);
  text += fmt::format("  proved      from {:.9g} m to {:.9g} m\n", d.lower, d.upper);
  text += fmt::format("  shapes      {} and {}\n", shape_title(A, found.nearest.shapes.a),
                      shape_title(B, found.nearest.shapes.b));
  text += fmt::format("  on {:<9}{} m\n", "A", rounded_text(d.p_WA));
  text += fmt::format("  on {:<9}{} m\n", "B", rounded_text(d.p_WB));
  text += fmt::format("  normal      {} from A to B\n", rounded_text(d.n_W));
  for (const PairDistance& pair : found.pairs) {
    if (found.pairs.size() == 1) break;
    text += fmt::format("  pair        {} and {}: {:.9g} m\n", shape_title(A, pair.shapes.a),
                        shape_title(B, pair.shapes.b), pair.distance.distance);
  }
  text += fmt::format("  contacts    {} closer than {:g} m\n", found.contacts.size(), tolerance);
  for (const PairContact& contact : found.contacts) {
    const ContactPoint& point = contact.point;
    text += fmt::format("    gap {:.3g} m at {} m, normal {}, shapes {} and {}, {} on {}{}\n", point.gap,
                        rounded_text(point.p_WA), rounded_text(point.n_W), contact.shapes.a, contact.shapes.b,
                        name_of(first_feature(point.feature)), name_of(second_feature(point.feature)),
                        point.degenerate ? ", degenerate" : "");
  }
  return text;
}

Json json_of(const BodyDistance& found, const Body& A, const Body& B, double tolerance) {
  const DistanceResult& d = found.nearest.distance;
  Json contacts = Json::array();
  for (const PairContact& contact : found.contacts) {
    const ContactPoint& point = contact.point;
    contacts.push_back({{"gap", point.gap},
                        {"point_A", vector_json(point.p_WA)},
                        {"point_B", vector_json(point.p_WB)},
                        {"normal", vector_json(point.n_W)},
                        {"shapes", {contact.shapes.a, contact.shapes.b}},
                        {"feature", fmt::format("{:#x}", point.feature)},
                        {"feature_A", name_of(first_feature(point.feature))},
                        {"feature_B", name_of(second_feature(point.feature))},
                        {"degenerate", point.degenerate}});
  }
  Json pairs = Json::array();
  for (const PairDistance& pair : found.pairs) {
    pairs.push_back({{"shapes", {pair.shapes.a, pair.shapes.b}},
                     {"distance", pair.distance.distance},
                     {"lower", pair.distance.lower},
                     {"upper", pair.distance.upper},
                     {"point_A", vector_json(pair.distance.p_WA)},
                     {"point_B", vector_json(pair.distance.p_WB)},
                     {"normal", vector_json(pair.distance.n_W)}});
  }
  return {{"bodies", {A.name, B.name}},
          {"distance", d.distance},
          {"lower", d.lower},
          {"upper", d.upper},
          {"shapes", {found.nearest.shapes.a, found.nearest.shapes.b}},
          {"point_A", vector_json(d.p_WA)},
          {"point_B", vector_json(d.p_WB)},
          {"normal", vector_json(d.n_W)},
          {"pairs", pairs},
          {"tolerance", tolerance},
          {"contacts", contacts}};
}

}  // namespace

ExitCode execute(const DistanceOptions& options) {
  const bool is_question = is_scene_question(options);
  const Scene scene = read_scene(options.scene);
  if (is_question) {
    const Answer answer = answer_scene_question(options, scene);
    if (options.json != "-") fmt::print("{}", answer.text);
    write_text(options.json, json_text(answer.json).append("\n"));
    return exit_done;
  }
  const int body_A = find_body_or_throw(scene, options.body_A);
  const int body_B = find_body_or_throw(scene, options.body_B);
  if (body_A == body_B) throw UsageError("BODY_A and BODY_B are the same body; give two");
  const double tolerance = options.tolerance.value_or(scene.method.contact_tolerance);
  const BodyDistance found = body_distance(scene, body_A, body_B, tolerance);
  const Body &A = scene.model->body(body_A), &B = scene.model->body(body_B);
  if (options.json != "-") fmt::print("{}", text_of(found, A, B, tolerance));
  write_text(options.json, json_text(json_of(found, A, B, tolerance)).append("\n"));
  return exit_done;
}

}  // namespace rigor
