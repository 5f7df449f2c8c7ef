#include "rigor/api/batch.hpp"

#include "api/api_scenes.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace rigor::batch_test {
namespace {

constexpr const char* events = "{scheme: event-driven}";

TEST(Batch, ControllersActInEachWorldOnAnyNumberOfThreads) {
  std::vector<std::vector<double>> states;
  for (const int threads : {1, 3}) {
    Batch batch(scene_with(events, wheel_on_hinge), 7, threads);
    batch.set_controller([](int index, Simulation& world) { world.set_motor_effort("axle", 0.01 * index); },
                         0.02);
    batch.advance_to(0.5);
    for (int i = 0; i < batch.size(); ++i)
      EXPECT_NEAR(batch.world(i).joint_motion("axle").rates[0], 0.01 * i * 0.5 / wheel_moment, 1e-9);
    states.push_back(batch.states());
    batch.reset(3);
    EXPECT_EQ(batch.world(3).time(), 0);
    EXPECT_EQ(batch.world(4).time(), 0.5);
  }
  EXPECT_EQ(states[0], states[1]);
}

TEST(Batch, StatesGoOutAndIn) {
  Batch batch(scene_with(events, busy_scene), 3, 2);
  batch.advance_to(0.2);
  const std::vector<double> before = batch.states();
  batch.advance_to(0.4);
  batch.set_states(before);
  const std::vector<double> after = batch.states();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-12) << i;
  EXPECT_THROW(batch.set_states(std::vector<double>(5)), InputError);
  std::vector<double> bad = before;
  bad[13 + 3] = 5;
  EXPECT_THROW(batch.set_states(bad), InputError);
}

TEST(Batch, AnInterruptEndsAllWorlds) {
  Batch batch(scene_with(events, busy_scene), 4, 2);
  std::atomic<int> calls{0};
  batch.set_interrupt([&calls] { return ++calls > 20; });
  EXPECT_THROW(batch.advance_to(5), Interrupted);
  batch.set_interrupt({});
  batch.advance_to(0.01);
}

TEST(Contacts, StepsGiveTheImpulsesThatTheyUsed) {
  // A box that slides to rest on the floor: Σ h f is the change of its momentum less that of its weight.
  Simulation simulation(scene_with("{scheme: time-stepping}", R"(
materials: [{name: wood, friction: 0.3, restitution: 0}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: wood}]}
  - {name: box, position: [0, 0, 0.1], velocity: [1, 0, 0], mass: 2, shapes: [{type: box, size: [0.2, 0.2, 0.2], material: wood}]}
)"));
  for (int k = 0; k < 20; ++k) {
    const Vec3 before = 2 * simulation.velocity("box");
    simulation.step();
    Vec3 impulse = 2 * 9.80665 * 0.01 * -Vec3::UnitZ();
    for (const TouchingPoint& point : simulation.contacts()) impulse += 0.01 * point.force_W;
    EXPECT_LT((2 * simulation.velocity("box") - before - impulse).norm(), 1e-9) << k;
  }
}

}  // namespace
}  // namespace rigor::batch_test
