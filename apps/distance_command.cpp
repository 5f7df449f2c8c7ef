#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/geometry/contact_set.hpp"
#include "rigor/geometry/distance_cache.hpp"
#include "rigor/io/json_text.hpp"
#include "rigor/io/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

/// Shapes of the two bodies, by their places in the lists.
struct ShapePair {
  std::size_t a, b;
};
struct PairContact {
  ShapePair shapes;
  ContactPoint point;
};
struct BodyDistance {
  DistanceResult nearest;  ///< Over all pairs of shapes.
  ShapePair shapes;        ///< Which pair that is.
  std::vector<PairContact> contacts;
};

int find_body(const Scene& scene, const std::string& name) {
  if (const std::optional<int> body = scene.model->find_body(name)) return *body;
  std::vector<std::string> names;
  for (const Body& body : scene.model->bodies()) names.push_back(body.name);
  throw UsageError(fmt::format("the scene has no body {}{}", quoted_text(name), suggestion(name, names)));
}

/// Throws InputError for a pair of shapes whose distance is not defined here.
void check_pair(const BodyShape& a, const BodyShape& b) {
  const bool both_planes =
      std::holds_alternative<HalfSpace>(a.shape) && std::holds_alternative<HalfSpace>(b.shape);
  const bool both_meshes = std::holds_alternative<Mesh>(a.shape) && std::holds_alternative<Mesh>(b.shape);
  if (both_planes || both_meshes) {
    throw InputError(fmt::format("the distance of two shapes of type '{}' is not available in this version",
                                 shape_type_name(a.shape)));
  }
}

DistanceResult shape_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                              DistanceMethod method) {
  DistanceCache cache;
  return method == DistanceMethod::lin_canny ? walked_distance(a, X_WA, b, X_WB, cache)
                                             : signed_distance(a, X_WA, b, X_WB);
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
  bool is_first = true;
  for (std::size_t a = 0; a < A.shapes.size(); ++a) {
    for (std::size_t b = 0; b < B.shapes.size(); ++b) {
      check_pair(A.shapes[a], B.shapes[b]);
      const Pose X_WS = X_WA * A.shapes[a].X_BS, X_WT = X_WB * B.shapes[b].X_BS;
      const DistanceResult found =
          shape_distance(A.shapes[a].shape, X_WS, B.shapes[b].shape, X_WT, scene.method.distance);
      if (is_first || found.distance < result.nearest.distance)
        result.nearest = found, result.shapes = {a, b};
      is_first = false;
      for (const ContactPoint& point :
           contact_set(A.shapes[a].shape, X_WS, B.shapes[b].shape, X_WT, tolerance)) {
        result.contacts.push_back({{a, b}, point});
      }
    }
  }
  return result;
}

std::string shape_title(const Body& body, std::size_t shape) {
  return fmt::format("{}.shapes[{}] ({})", body.name, shape, shape_type_name(body.shapes[shape].shape));
}

std::string vector_text(const Vec3& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}
Json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

std::string text_of(const BodyDistance& found, const Body& A, const Body& B, double tolerance) {
  const DistanceResult& d = found.nearest;
  std::string text = fmt::format("{} to {}: distance {:.17g} m\n", toned(A.name, Tone::strong, stdout),
                                 toned(B.name, Tone::strong, stdout), d.distance);
  text += fmt::format("  proved      from {:.17g} m to {:.17g} m\n", d.lower, d.upper);
  text += fmt::format("  shapes      {} and {}\n", shape_title(A, found.shapes.a),
                      shape_title(B, found.shapes.b));
  text += fmt::format("  on {:<9}{} m\n", "A", vector_text(d.p_WA));
  text += fmt::format("  on {:<9}{} m\n", "B", vector_text(d.p_WB));
  text += fmt::format("  normal      {} from A to B\n", vector_text(d.n_W));
  text += fmt::format("  contacts    {} closer than {:g} m\n", found.contacts.size(), tolerance);
  for (const PairContact& contact : found.contacts) {
    const ContactPoint& point = contact.point;
    text += fmt::format("    gap {:.3g} m at {} m, normal {}, shapes {} and {}, feature {:#x}{}\n", point.gap,
                        vector_text(point.p_WA), vector_text(point.n_W), contact.shapes.a, contact.shapes.b,
                        point.feature, point.degenerate ? ", degenerate" : "");
  }
  return text;
}

Json json_of(const BodyDistance& found, const Body& A, const Body& B, double tolerance) {
  const DistanceResult& d = found.nearest;
  Json contacts = Json::array();
  for (const PairContact& contact : found.contacts) {
    const ContactPoint& point = contact.point;
    contacts.push_back({{"gap", point.gap},
                        {"point_A", json_of(point.p_WA)},
                        {"point_B", json_of(point.p_WB)},
                        {"normal", json_of(point.n_W)},
                        {"shapes", {contact.shapes.a, contact.shapes.b}},
                        {"feature", fmt::format("{:#x}", point.feature)},
                        {"degenerate", point.degenerate}});
  }
  return {{"bodies", {A.name, B.name}},
          {"distance", d.distance},
          {"lower", d.lower},
          {"upper", d.upper},
          {"shapes", {found.shapes.a, found.shapes.b}},
          {"point_A", json_of(d.p_WA)},
          {"point_B", json_of(d.p_WB)},
          {"normal", json_of(d.n_W)},
          {"tolerance", tolerance},
          {"contacts", contacts}};
}

}  // namespace

ExitCode execute(const DistanceOptions& options) {
  const Scene scene = read_scene(options.scene);
  const int body_A = find_body(scene, options.body_A), body_B = find_body(scene, options.body_B);
  if (body_A == body_B) throw UsageError("BODY_A and BODY_B are the same body; give two");
  const double tolerance = options.tolerance.value_or(scene.method.contact_tolerance);
  const BodyDistance found = body_distance(scene, body_A, body_B, tolerance);
  const Body &A = scene.model->body(body_A), &B = scene.model->body(body_B);
  if (options.json != "-") fmt::print("{}", text_of(found, A, B, tolerance));
  write_text(options.json, json_text(json_of(found, A, B, tolerance)).append("\n"));
  return exit_done;
}

}  // namespace rigor
