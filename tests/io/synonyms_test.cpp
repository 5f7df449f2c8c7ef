// Words of other engines and of textbooks in scene files: the scene that they give is that of the format's
// own words, bit for bit, and one line says what the word is here.

#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rigor::synonyms_test {
namespace {

Scene parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "s.yaml", ".", overrides);
}

std::uint64_t mark_of(const Scene& scene) {
  return fingerprint(*scene.model, scene.method, scene.run.step);
}

/// One body of that shape, under a joint and a method; `%` stands for the part that is written in two ways.
std::string with_part(std::string frame, const std::string& part) {
  return frame.replace(frame.find('%'), 1, part);
}
const std::string shape_frame = "rigor: 1\nbodies:\n  - {name: a, shapes: [{%}]}\n";
const std::string joint_frame =
    "rigor: 1\nbodies:\n  - {name: a, shapes: [{type: sphere, radius: 1}]}\n"
    "joints:\n  - {name: j, bodies: [world, a], anchor: [0, 0, 2], %}\n";
const std::string body_frame =
    "rigor: 1\nbodies:\n  - {name: a, shapes: [{type: sphere, radius: 1, material: m}], %}\n"
    "materials: [{name: m, friction: 0.25}]\n";
const std::string material_frame =
    "rigor: 1\nbodies:\n  - {name: a, shapes: [{type: sphere, radius: 1, material: m}]}\n"
    "materials: [{name: m, %}]\n";
const std::string top_frame = "rigor: 1\nbodies: [{name: a, shapes: [{type: sphere, radius: 1}]}]\n%\n";

struct Pair {
  std::string frame, written, meant;
};
const std::vector<Pair>& pairs() {
  static const std::vector<Pair> all = {
      {shape_frame, "type: ball, radius: 0.3", "type: sphere, radius: 0.3"},
      {shape_frame, "type: sphere, diameter: 0.7", "type: sphere, radius: 0.35"},
      {shape_frame, "type: box, half_extents: [0.1, 0.2, 0.7]", "type: box, size: [0.2, 0.4, 1.4]"},
      {shape_frame, "type: cuboid, dimensions: [1, 2, 3]", "type: box, size: [1, 2, 3]"},
      {shape_frame, "type: cylinder, radius: 1, height: 0.3", "type: cylinder, radius: 1, length: 0.3"},
      {shape_frame, "type: capsule, radius: 1, half_height: 0.3", "type: capsule, radius: 1, length: 0.6"},
      {shape_frame, "type: cone, radius: 1, height: 3", "type: cone, radius: 1, length: 3"},
      {shape_frame, "type: ellipsoid, semi_axes: [1, 2, 3]", "type: ellipsoid, radii: [1, 2, 3]"},
      {shape_frame, "type: hull, vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]",
       "type: convex, vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"},
      {joint_frame, "type: revolute, axis: [0, 1, 0]", "type: hinge, axis: [0, 1, 0]"},
      {joint_frame, "type: prismatic, axis: [0, 1, 0]", "type: slider, axis: [0, 1, 0]"},
      {joint_frame, "type: weld", "type: fixed"},
      {joint_frame, "type: spherical", "type: ball"},
      {body_frame, "pos: [1, 2, 3], omega: [0, 0, 1]", "position: [1, 2, 3], angular_velocity: [0, 0, 1]"},
      {body_frame, "motion: fixed", "motion: static"},
      {material_frame, "mu: 0.7, bounciness: 0.1", "friction: 0.7, restitution: 0.1"},
      {top_frame, "method: {scheme: substep}", "method: {scheme: time-stepping, solver: substep}"},
      {top_frame, "method: {integrator: rk45}", "method: {integrator: dopri5}"},
      {top_frame, "run: {dt: 0.003}", "run: {step: 0.003}"},
  };
  return all;
}

TEST(Synonyms, GiveTheSceneOfTheOwnWordsAndAdvice) {
  for (const Pair& pair : pairs()) {
    const Scene written = parsed(with_part(pair.frame, pair.written));
    const Scene meant = parsed(with_part(pair.frame, pair.meant));
    EXPECT_EQ(mark_of(written), mark_of(meant)) << pair.written;
    EXPECT_GT(written.warnings.size(), meant.warnings.size()) << pair.written;
  }
}

TEST(Synonyms, AreToldOnceWithTheirPlaceAndTheWordHere) {
  const Scene scene = parsed(
      "rigor: 1\nbodies:\n"
      "  - {name: a, shapes: [{type: box, half_extents: [1, 1, 1]}, {type: box, half_extents: [2, 1, 1]}]}\n"
      "  - {name: b, position: [9, 0, 0], shapes: [{type: sphere, radius: 1}]}\n"
      "joints:\n"
      "  - {name: p, type: revolute, bodies: [world, a], anchor: [0, 0, 2], axis: [0, 1, 0]}\n"
      "  - {name: q, type: revolute, bodies: [world, b], anchor: [9, 0, 2], axis: [0, 1, 0]}\n");
  const std::vector<std::string> expected = {
      "s.yaml:3:50: 'half_extents' of a box is read as 'size' (times 2), its name here",
      "s.yaml:6:21: the joint 'revolute' is read as 'hinge', its name here"};
  EXPECT_EQ(scene.warnings, expected);
}

TEST(Synonyms, WorkInOverrides) {
  const std::string text = with_part(joint_frame, "type: ball");
  const Scene scene =
      parsed(text, {"joints.j.type=revolute", "joints.j.axis=[0, 1, 0]", "method.scheme=substep"});
  EXPECT_EQ(mark_of(scene), mark_of(parsed(text, {"joints.j.type=hinge", "joints.j.axis=[0, 1, 0]",
                                                  "method.scheme=time-stepping", "method.solver=substep"})));
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_EQ(scene.warnings[0].rfind("--set joints.j.type=revolute: ", 0), 0u) << scene.warnings[0];
  EXPECT_EQ(scene.warnings[1].rfind("--set method.scheme=substep: ", 0), 0u) << scene.warnings[1];
}

TEST(Synonyms, BesideTheOwnWordAreRefused) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parsed(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message(with_part(shape_frame, "type: box, size: [1, 1, 1], half_extents: [1, 1, 1]"))
                .find("unknown key 'half_extents'"),
            std::string::npos);
  EXPECT_NE(message(with_part(top_frame, "method: {scheme: substep, solver: pgs}")).find("'substep'"),
            std::string::npos);
  // A number that is none is told of under the name of the format.
  EXPECT_NE(message(with_part(shape_frame, "type: sphere, diameter: wide")).find("radius must be a number"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::synonyms_test
