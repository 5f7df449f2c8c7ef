#include "rigor/io/scene/expectation_reader.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"

namespace rigor {

std::vector<ExpectedPlace> read_expectations(const ObjectReader& scene) {
  std::vector<ExpectedPlace> expected;
  std::size_t index = 0;
  for (const YamlNode* const node : scene.list("expect")) {
    const ObjectReader reader(*node, key_table("expectation"), "expectation " + std::to_string(index++),
                              scene.errors());
    ExpectedPlace place;
    place.body = reader.text("body").value_or("");
    place.time = reader.number("time").value_or(0);
    place.position = reader.vector("position");
    if (reader.has("orientation")) place.orientation = reader.quaternion("orientation");
    if (place.orientation) place.orientation->normalize();
    place.error = reader.number("error").value_or(0);
    if (!reader.has("position") && !reader.has("orientation"))
      reader.fail("body", "it expects nothing; give 'position', 'orientation' or both");
    expected.push_back(std::move(place));
  }
  return expected;
}

void check_expectations(const ObjectReader& scene, const std::vector<ExpectedPlace>& expected,
                        const Model& model) {
  std::vector<std::string> names;
  for (const Body& body : model.bodies()) {
    if (body.motion == MotionType::dynamic) names.push_back(body.name);
  }
  const std::vector<const YamlNode*> nodes = scene.list("expect");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::optional<int> body = model.find_body(expected[i].body);
    if (body && model.body(*body).motion == MotionType::dynamic) continue;
    scene.errors().add(*nodes[i], "expectation " + std::to_string(i) + ": there is no dynamic body " +
                                      quoted_text(expected[i].body) + suggestion(expected[i].body, names));
  }
}

}  // namespace rigor
