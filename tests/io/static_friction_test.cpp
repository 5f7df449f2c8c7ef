#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::static_friction_test {
namespace {

/// Coefficients of materials a and b, with this text of a, b and of their pair.
PairCoefficients pair_of(const std::string& a, const std::string& b, const std::string& pair) {
  std::string text = "rigor: 1\nmethod: {scheme: time-stepping}\nmaterials:\n  - {name: a, " + a +
                     "}\n  - {name: b, " + b + "}\n";
  if (!pair.empty()) text += "pairs: [{between: [a, b], " + pair + "}]\n";
  const Scene scene = parse_scene(text + "bodies: []\n", "s.yaml", ".");
  return scene.model->coefficients(1, 2);
}

std::string error_of(const std::string& a, const std::string& pair) {
  try {
    pair_of(a, "friction: 0.5", pair);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(StaticFriction, OfMaterialsIsTheMeanOfWhatHoldsEach) {
  EXPECT_FALSE(pair_of("friction: 0.4", "friction: 0.9", "").static_friction);
  const PairCoefficients pair = pair_of("friction: 0.4, static_friction: 0.5", "friction: 0.9", "");
  EXPECT_DOUBLE_EQ(pair.friction, 0.6);
  EXPECT_DOUBLE_EQ(*pair.static_friction, std::sqrt(0.5 * 0.9));
}

TEST(StaticFriction, OfAPairReplacesThatOfTheMaterials) {
  const std::string a = "friction: 0.4, static_friction: 0.5", b = "friction: 0.9";
  EXPECT_DOUBLE_EQ(*pair_of(a, b, "static_friction: 0.8").static_friction, 0.8);
  EXPECT_DOUBLE_EQ(*pair_of(a, b, "restitution: 0.1").static_friction, std::sqrt(0.5 * 0.9));
  // What the materials stick with belongs to what they slide with.
  EXPECT_FALSE(pair_of(a, b, "friction: 0.7").static_friction);
}

TEST(StaticFriction, BelowFrictionIsRefused) {
  EXPECT_NE(error_of("friction: 0.4, static_friction: 0.3", "")
                .find("static_friction is 0.3, must be at least friction, 0.4"),
            std::string::npos);
  EXPECT_NE(error_of("friction: 0.4", "friction: 0.6, static_friction: 0.5")
                .find("static_friction is 0.5, must be at least friction, 0.6"),
            std::string::npos);
  EXPECT_NE(error_of("static_friction: -1", ""), "");
}

}  // namespace
}  // namespace rigor::static_friction_test
