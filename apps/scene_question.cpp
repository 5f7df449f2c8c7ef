#include "apps/scene_question.hpp"

#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/model/scene_queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

constexpr double largest_number = 1e9;

/// `count` numbers separated by commas or spaces.
std::vector<double> parse_numbers(const char* option, const std::string& text, std::size_t count,
                                  const char* example) {
  const auto refuse = [&](const std::string& what) {
    throw UsageError(fmt::format("{} {}: {}, such as {}", option, quoted_text(text), what, example));
  };
  std::vector<double> numbers;
  const char *at = text.data(), *const end = at + text.size();
  while (at != end) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    double number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    const bool is_number = error == std::errc() && std::abs(number) <= largest_number &&
                           (next == end || *next == ' ' || *next == ',');
    if (!is_number) refuse(fmt::format("must be numbers of at most {:g}", largest_number));
    numbers.push_back(number);
    at = next;
  }
  if (numbers.size() != count) refuse(fmt::format("{} numbers, must be {}", numbers.size(), count));
  return numbers;
}

std::string title_of(const Model& model, const ShapeIndex& at) {
  return shape_title(model.body(at.body), static_cast<std::size_t>(at.shape));
}

Answer answer_ray(const DistanceOptions& options, const Model& model, const SceneQueries& queries) {
  const std::vector<double> n = parse_numbers("--ray", options.ray, 6, "\"0,0,5 0,0,-1\"");
  const Ray ray{Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5])};
  if (ray.direction_W.isZero(0)) throw UsageError("--ray: the direction is zero, must have a length");
  const std::vector<BodyRayHit> hits = queries.all_hits(ray);
  Answer answer;
  answer.text = fmt::format("ray from {} m along {}: {} crossings\n", rounded_text(ray.origin_W),
                            rounded_text(ray.direction_W), hits.size());
  Json list = Json::array();
  for (const BodyRayHit& at : hits) {
    const double distance = at.hit.fraction * ray.direction_W.norm();
    const std::string triangle = at.hit.triangle < 0 ? "" : fmt::format(", triangle {}", at.hit.triangle);
    answer.text +=
        fmt::format("  {:.9g} m {} {} at {} m, normal {}{}\n", distance, at.hit.enters ? "into" : "out of",
                    title_of(model, at.on), rounded_text(at.hit.p_W), rounded_text(at.hit.n_W), triangle);
    list.push_back({{"body", model.body(at.on.body).name},
                    {"shape", at.on.shape},
                    {"distance", distance},
                    {"fraction", at.hit.fraction},
                    {"point", vector_json(at.hit.p_W)},
                    {"normal", vector_json(at.hit.n_W)},
                    {"enters", at.hit.enters}});
    if (at.hit.triangle >= 0) list.back()["triangle"] = at.hit.triangle;
  }
  answer.json = {
      {"origin", vector_json(ray.origin_W)}, {"direction", vector_json(ray.direction_W)}, {"hits", list}};
  return answer;
}

std::string text_of(const Model& model, const NearBody& near) {
  return fmt::format("  {:.9g} m {}: from {} m to {} m\n", near.distance, title_of(model, near.on),
                     rounded_text(near.p_WQ), rounded_text(near.p_WB));
}

Json json_of(const Model& model, const NearBody& near) {
  return {{"body", model.body(near.on.body).name},
          {"shape", near.on.shape},
          {"distance", near.distance},
          {"point", vector_json(near.p_WQ)},
          {"point_on_body", vector_json(near.p_WB)},
          {"normal", vector_json(near.n_W)}};
}

Answer answer_point(const DistanceOptions& options, const Model& model, const SceneQueries& queries) {
  const std::vector<double> n = parse_numbers("--point", options.point, 3, "1,-2,0.5");
  const Vec3 p_W(n[0], n[1], n[2]);
  const std::vector<NearBody> near = queries.nearest(p_W, options.closest.value_or(1));
  Answer answer;
  answer.text = fmt::format("point {} m\n", rounded_text(p_W));
  Json list = Json::array(), inside = Json::array();
  for (const NearBody& body : near) {
    answer.text += text_of(model, body);
    list.push_back(json_of(model, body));
  }
  std::string names;
  for (const int body : queries.containing(p_W)) {
    names += (names.empty() ? "" : ", ") + escaped_text(model.body(body).name);
    inside.push_back(model.body(body).name);
  }
  answer.text += fmt::format("  inside of {}\n", names.empty() ? "no body" : names);
  answer.json = {{"point", vector_json(p_W)}, {"closest", list}, {"inside", inside}};
  return answer;
}

bool has_unbounded_shape(const Body& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(),
                     [](const BodyShape& s) { return is_unbounded(s.shape); });
}

/// Throws InputError for a body to which the question does not apply.
void check_has_shapes(const Body& body) {
  if (body.shapes.empty()) throw InputError(fmt::format("body {} has no shapes", quoted_text(body.name)));
}

Answer answer_closest(const DistanceOptions& options, const Scene& scene, const SceneQueries& queries) {
  const Model& model = *scene.model;
  const int body_A = find_body_or_throw(scene, options.body_A);
  const Body& A = model.body(body_A);
  check_has_shapes(A);
  // For every other body, the distance to the nearest shape of A. Two unbounded shapes have no distance.
  std::vector<NearBody> near;
  for (const BodyShape& a : A.shapes) {
    const auto others = [&](int body) {
      return body != body_A && !(is_unbounded(a.shape) && has_unbounded_shape(model.body(body)));
    };
    for (const NearBody& found :
         queries.nearest(a.shape, queries.pose(body_A) * a.X_BS, model.body_count(), others)) {
      const auto same = std::find_if(near.begin(), near.end(),
                                     [&](const NearBody& n) { return n.on.body == found.on.body; });
      if (same == near.end()) {
        near.push_back(found);
      } else if (found.distance < same->distance) {
        *same = found;
      }
    }
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const NearBody& a, const NearBody& b) { return a.distance < b.distance; });
  near.resize(std::min(near.size(), static_cast<std::size_t>(*options.closest)));
  Answer answer;
  answer.text = fmt::format("closest to {}\n", toned(A.name, Tone::strong, stdout));
  Json list = Json::array();
  for (const NearBody& body : near) {
    answer.text += text_of(model, body);
    list.push_back(json_of(model, body));
  }
  answer.json = {{"body", A.name}, {"closest", list}};
  return answer;
}

Answer answer_push(const DistanceOptions& options, const Scene& scene, const SceneQueries& queries) {
  const Model& model = *scene.model;
  const int body_A = find_body_or_throw(scene, options.body_A);
  const Body& A = model.body(body_A);
  check_has_shapes(A);
  const std::vector<double> n = parse_numbers("--push", options.push, 3, "0,0,-1");
  const Vec3 displacement(n[0], n[1], n[2]);
  if (displacement.isZero(0)) throw UsageError("--push: the displacement is zero, must have a length");
  std::optional<BodyCastHit> first;
  for (const BodyShape& a : A.shapes) {
    const auto others = [&](int body) {
      return body != body_A && !(is_unbounded(a.shape) && has_unbounded_shape(model.body(body)));
    };
    const std::optional<BodyCastHit> hit =
        queries.cast({&a.shape, queries.pose(body_A) * a.X_BS, displacement}, others);
    if (hit && (!first || hit->hit.fraction < first->hit.fraction)) first = hit;
  }
  Answer answer;
  answer.json = {{"body", A.name}, {"push", vector_json(displacement)}, {"meets", nullptr}};
  answer.text =
      fmt::format("{} pushed by {} m: ", toned(A.name, Tone::strong, stdout), rounded_text(displacement));
  if (!first) {
    answer.text += "meets nothing, proved\n";
    return answer;
  }
  answer.text += fmt::format(
      "meets {}\n  fraction    {:.9g}, proved free before; touching at {:.9g}\n  way         "
      "{:.9g} m\n  at          {} m\n  normal      {} towards it\n",
      title_of(model, first->on), first->hit.fraction, first->hit.upper,
      first->hit.fraction * displacement.norm(), rounded_text(first->hit.p_W), rounded_text(first->hit.n_W));
  answer.json["meets"] = {{"body", model.body(first->on.body).name}, {"shape", first->on.shape},
                          {"fraction", first->hit.fraction},         {"upper", first->hit.upper},
                          {"point", vector_json(first->hit.p_W)},    {"normal", vector_json(first->hit.n_W)}};
  return answer;
}

}  // namespace

int find_body_or_throw(const Scene& scene, const std::string& name) {
  if (const std::optional<int> body = scene.model->find_body(name)) return *body;
  std::vector<std::string> names;
  for (const Body& body : scene.model->bodies()) names.push_back(body.name);
  throw UsageError(fmt::format("the scene has no body {}{}", quoted_text(name), suggestion(name, names)));
}

std::string shape_title(const Body& body, std::size_t shape) {
  return fmt::format("{}.shapes[{}] ({})", escaped_text(body.name), shape,
                     shape_type_name(body.shapes[shape].shape));
}

std::string rounded_text(const Vec3& v) {
  const Vec3 without_minus_zero = v + Vec3::Zero();
  return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", without_minus_zero.x(), without_minus_zero.y(),
                     without_minus_zero.z());
}

nlohmann::ordered_json vector_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

bool is_scene_question(const DistanceOptions& options) {
  const bool has_A = !options.body_A.empty(), has_B = !options.body_B.empty();
  const int questions = !options.ray.empty() + !options.point.empty() + !options.push.empty();
  if (questions > 1) throw UsageError("--ray, --point and --push do not go together; give one");
  if ((!options.ray.empty() || !options.point.empty()) && has_A)
    throw UsageError("--ray and --point ask the whole scene; give no body with them");
  if (!options.ray.empty() && options.closest) throw UsageError("--ray and --closest do not go together");
  if (!options.push.empty() && (!has_A || options.closest))
    throw UsageError("--push needs BODY_A, the body to push, and no --closest");
  const bool is_question = questions == 1 || options.closest;
  if (is_question && has_B) throw UsageError("--push and --closest take one body; leave out BODY_B");
  if (is_question && options.tolerance) throw UsageError("--tolerance needs BODY_A and BODY_B");
  if (options.closest && !has_A && options.point.empty())
    throw UsageError("--closest needs BODY_A or --point");
  if (!is_question && !has_B)
    throw UsageError("give BODY_A and BODY_B, or BODY_A with --closest or --push, or --ray, or --point");
  return is_question;
}

Answer answer_scene_question(const DistanceOptions& options, const Scene& scene) {
  const SceneQueries queries(*scene.model, make_initial_state(*scene.model));
  if (!options.ray.empty()) return answer_ray(options, *scene.model, queries);
  if (!options.point.empty()) return answer_point(options, *scene.model, queries);
  if (!options.push.empty()) return answer_push(options, scene, queries);
  return answer_closest(options, scene, queries);
}

}  // namespace rigor
