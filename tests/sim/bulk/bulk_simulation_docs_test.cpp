// The program of docs/bulk_api.md.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/bulk/bulk_simulation.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace rigor::bulk_simulation_docs_test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The first program after this heading of the page stands in this file.
void expect_program_of_section(const std::string& heading) {
  const std::string root = RIGOR_SOURCE_DIR;
  const std::string page = text_of(root + "/docs/bulk_api.md");
  const std::size_t section = page.find(heading);
  ASSERT_NE(section, std::string::npos);
  const std::size_t begin = page.find("```cpp\n", section) + 7, end = page.find("```", begin);
  ASSERT_LT(begin, end);
  EXPECT_NE(
      text_of(root + "/tests/sim/bulk/bulk_simulation_docs_test.cpp").find(page.substr(begin, end - begin)),
      std::string::npos);
}

TEST(BulkSimulationDocs, TheProgramOnThePageIsThisOne) {
  int sounds = 0;
  double last_force = 0;
  const auto play_sound = [&](const Vec3&, double impulse) { sounds += impulse > 0 ? 1 : 0; };
  const auto show_force = [&](const Vec3&, const Vec3& force) { last_force = force.z(); };

  // clang-format off
// A floor, a crate, and a paddle that the program moves.
ModelBuilder builder;
builder.set_gravity(Vec3(0, 0, -9.81));
builder.add_body({.name = "floor", .motion = MotionType::fixed, .shapes = {{HalfSpace{Vec3::UnitZ(), 0}}}});
builder.add_body({.name = "crate", .p_WU = Vec3(0, 0, 0.25), .shapes = {{Box{Vec3(0.25, 0.25, 0.25)}}}});
builder.add_body({.name = "paddle", .motion = MotionType::kinematic, .p_WU = Vec3(-1, 0, 0.25),
                  .shapes = {{Box{Vec3(0.05, 0.2, 0.2)}}}});

BulkSimulation simulation(builder.build(), {.step = 1.0 / 60, .threads = 2});
const int crate = *simulation.model().find_body("crate");
const int paddle = *simulation.model().find_body("paddle");

// The paddle goes 1 m in a second and pushes the crate, which is pulled up a little too.
for (int k = 1; k <= 60; ++k) {
  simulation.move_to(paddle, {Mat3::Identity(), Vec3(-1 + k / 60.0, 0, 0.25)});
  simulation.apply_force(crate, Vec3(0, 0, 100));
  simulation.step();
  for (const BulkContact& hit : simulation.hits(0.1)) play_sound(hit.center_W, hit.normal_impulse());
}

// With what force does the floor carry the crate? Impulses of the whole step, over its length.
for (const BulkContact& contact : simulation.contacts()) {
  if (contact.body_A == 0 && contact.body_B == crate) show_force(contact.center_W, 60 * contact.impulse_W());
}

// A sensor looks down, past the paddle.
const std::optional<BodyRayHit> seen = simulation.queries().first_hit(
    {Vec3(0.3, 0, 2), Vec3(0, 0, -1)}, [&](int body) { return body != paddle; });

// A second crate comes in, the paddle goes out; what has not changed goes on bit for bit.
builder.add_body({.name = "crate 2", .p_WU = Vec3(0.3, 0, 1), .shapes = {{Box{Vec3(0.2, 0.2, 0.2)}}},
                  .linear_damping = 0.5});
builder.remove_body("paddle");
simulation.set_model(builder.build());
const int second = *simulation.model().find_body("crate 2");

// Until both have come to rest and sleep.
while (!simulation.is_asleep(second)) simulation.step();
  // clang-format on

  EXPECT_GT(sounds, 0);
  EXPECT_GT(simulation.pose(crate).p.x(), 0.25);
  // The floor brakes with half of its force N, the paddle pushes with that and, since the crate would tip
  // over the floor, rubs down on it with half of it: N = m g - 100 N + N/4. The crate has 125 kg. Springs and
  // friction come to that within a third of a second, of which the push has lasted most.
  EXPECT_NEAR(last_force, (125 * 9.81 - 100) / 0.75, 15);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->on.body, crate);
  EXPECT_FALSE(simulation.model().find_body("paddle"));
  EXPECT_NEAR(simulation.pose(second).p.z(), 0.7, 0.01);

  expect_program_of_section("# ");
}

TEST(BulkSimulationDocs, BodiesThatComeAndGo) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  BulkSimulation simulation(builder.build());
  // clang-format off
BodyDescription bullet{.p_WU = Vec3(0, 0, 2), .velocity = Vec3(30, 0, 0), .shapes = {{Sphere{0.05}}}};
const BodyId id = simulation.add_body(bullet);  // An InputError if the description is wrong.
simulation.add_sensor({.shape = Box{Vec3(0.1, 1, 1)}, .X_US = {Mat3::Identity(), Vec3(1, 0, 2)}});

// What comes through the gate goes; whoever has its handle still is told so.
for (int k = 0; k < 10; ++k) {
  simulation.step();
  for (const SensorEvent& event : simulation.sensor_events())
    if (event.kind == SensorEvent::Kind::begin) simulation.remove_body(event.body);
}
const bool is_gone = simulation.apply_force(id, Vec3::UnitX()) == BulkStatus::no_such_body;
  // clang-format on
  EXPECT_TRUE(is_gone);
  EXPECT_TRUE(simulation.bodies().empty());

  expect_program_of_section("## Bodies that come and go");
}

}  // namespace
}  // namespace rigor::bulk_simulation_docs_test
