#include "rigor/view/live/live_command.hpp"

#include "rigor/core/input_error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rigor::live_command_test {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_live_command(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LiveCommand, CarriesItsValues) {
  const auto surface = std::get<live::Surface>(
      parse_live_command(R"({"do": "surface", "material": "steel", "friction": 0.25})"));
  EXPECT_EQ(surface.material, "steel");
  EXPECT_EQ(surface.friction, 0.25);
  EXPECT_FALSE(surface.restitution);
  const auto pull = std::get<live::Pull>(
      parse_live_command(R"({"do": "pull", "body": 3, "point": [1, 2, 3], "target": [4, 5, 6.5]})"));
  EXPECT_EQ(pull.pull.body, 3);
  EXPECT_EQ(pull.pull.p_BP, Vec3(1, 2, 3));
  EXPECT_EQ(pull.pull.target, Vec3(4, 5, 6.5));
  EXPECT_TRUE(std::holds_alternative<live::Step>(parse_live_command(R"({"do": "step"})")));
  EXPECT_FALSE(std::get<live::Follow>(parse_live_command(R"({"do": "follow", "value": false})")).value);
}

TEST(LiveCommand, WhatIsNoneIsRefusedWithItsReason) {
  EXPECT_EQ(refusal("{"), "the message is not JSON");
  EXPECT_EQ(refusal(std::string(4000, '[')), "the message is not JSON");
  EXPECT_EQ(refusal("[]"), "a command is a JSON object");
  EXPECT_EQ(refusal("{}"), "do must be a text");
  EXPECT_EQ(refusal(R"({"do": "rum"})"), "unknown command 'rum'; did you mean 'run'?");
  EXPECT_EQ(refusal(R"({"do": "run", "value": 1})"), "unknown key 'value'");
  EXPECT_EQ(refusal(R"({"do": "speed"})"), "value is missing");
  EXPECT_EQ(refusal(R"({"do": "speed", "value": "1"})"), "value must be a number");
  EXPECT_EQ(refusal(R"({"do": "gravity", "value": [0, 0]})"), "value must be a list of three numbers");
  EXPECT_EQ(refusal(R"({"do": "push", "body": -1, "point": [0, 0, 0], "impulse": [0, 0, 0]})"),
            "body must be a body's number");
  EXPECT_EQ(refusal(R"({"do": "push", "body": 4294967296, "point": [0, 0, 0], "impulse": [0, 0, 0]})"),
            "body must be a body's number");
  EXPECT_NE(refusal(R"({"do": "speed", "value": 0})"), "");
  EXPECT_NE(refusal(R"({"do": "gravity", "value": [0, 0, 1e999]})"), "");
}

}  // namespace
}  // namespace rigor::live_command_test
