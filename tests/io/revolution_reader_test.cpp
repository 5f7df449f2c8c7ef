// The shape `revolution` in a scene file, and what is refused with which message.

#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rigor::revolution_reader_test {
namespace {

Scene scene_of(const std::string& shape) {
  return parse_scene(
      "rigor: 1\nname: s\nrun: {duration: 1}\nbodies:\n  - {name: a, shapes: [{type: revolution, " + shape +
          "}]}\n",
      "s.yaml", ".");
}

TEST(RevolutionReader, ReadsAProfile) {
  const Scene scene = scene_of("profile: [[1, 0], [2, 1], [0, 3]]");
  const Body& body = scene.model->body(0);
  ASSERT_EQ(body.shapes.size(), 1u);
  const Revolution& solid = std::get<Revolution>(body.shapes[0].shape);
  ASSERT_EQ(solid.rings->size(), 3u);
  EXPECT_EQ((*solid.rings)[1].radius, 2);
  EXPECT_EQ((*solid.rings)[1].z, 1);
  // Frusta of volumes 7π/3 and 8π/3, at the default density of 1000 kg/m³.
  EXPECT_NEAR(body.mass, 1000 * 5 * std::numbers::pi, 1e-10);
}

TEST(RevolutionReader, RefusesWithThePlaceAndTheReason) {
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"radius: 1", "s.yaml:5:"},
      {"profile: [[1, 0]]",
       "s.yaml:5:52: shape 0 (revolution) of body 'a': the profile has 1 points, must have at least 2"},
      {"profile: [[1, 0, 0], [1, 1, 0]]",
       "s.yaml:5:52: shape 0 (revolution) of body 'a': a point of the profile has 3 numbers, must have 2: "
       "[radius, z]"},
      {"profile: [[-1, 0], [1, 1]]",
       "s.yaml:5:52: shape 0 (revolution) of body 'a': point 0 of the profile has radius -1 m, must be >= 0"},
      {"profile: [[0, 0], [0, 1]]",
       "s.yaml:5:52: shape 0 (revolution) of body 'a': the profile lies on the axis: the solid has no "
       "volume"},
      {"profile: [[1, 0], [0.5, 1], [1, 2]]",
       "s.yaml:5:52: shape 0 (revolution) of body 'a': the profile is not convex: point 1 [0.5, 1] lies 0.5 "
       "m inside"},
      {"profile: [[1e-10, 0], [0, 1]]",
       "s.yaml:5:5: body 'a': shape 0 (revolution): largest radius is 1e-10 m, must be from 1e-09 to 1e+09 "
       "m"},
  };
  for (const auto& [shape, message] : mistakes) {
    try {
      scene_of(shape);
      ADD_FAILURE() << "accepted: " << shape;
    } catch (const InputError& error) {
      ASSERT_FALSE(error.messages().empty());
      EXPECT_TRUE(error.messages()[0].starts_with(message)) << error.messages()[0];
    }
  }
}

}  // namespace
}  // namespace rigor::revolution_reader_test
