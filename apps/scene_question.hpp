#pragma once

#include "apps/options.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace rigor {

/// The output of `rigor distance`: text and JSON.
struct Answer {
  std::string text;
  nlohmann::ordered_json json;
};

/// Whether the options ask for a ray, a point, the closest bodies or a push instead of two bodies. Throws
/// UsageError for options that do not go together.
bool is_scene_question(const DistanceOptions& options);

/// The answer to that question, from the scene at t = 0. Throws UsageError and InputError.
Answer answer_scene_question(const DistanceOptions& options, const Scene& scene);

/// Index of the named body; UsageError with the nearest name if there is none.
int find_body_or_throw(const Scene& scene, const std::string& name);

/// "ball.shapes[0] (sphere)".
std::string shape_title(const Body& body, std::size_t shape);
/// "[x, y, z]", to nine digits.
std::string rounded_text(const Vec3& v);
nlohmann::ordered_json vector_json(const Vec3& v);

}  // namespace rigor
