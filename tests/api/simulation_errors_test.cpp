#include "api/api_scenes.hpp"
#include "rigor/api/batch.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

namespace rigor::simulation_errors_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SimulationErrors, SayWhatIsAllowed) {
  Simulation s(scene_with("{scheme: event-driven}", busy_scene));
  const auto holds = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  holds(message_of([&] { s.position("bal"); }), "there is no body 'bal'; did you mean 'ball'?");
  holds(message_of([&] { s.joint("axl"); }), "there is no joint 'axl'; did you mean 'axle'?");
  holds(message_of([&] { s.position(BodyHandle{7}); }), "must be from 0 to 4");
  holds(message_of([&] { s.position(BodyHandle{}); }), "must be from 0 to 4");
  holds(message_of([&] { s.apply_force("floor", Vec3(1, 0, 0)); }), "'floor' is static");
  holds(message_of([&] { s.apply_impulse("cart", Vec3(1, 0, 0)); }), "'cart' is kinematic");
  holds(message_of([&] { s.apply_force("ball", Vec3(nan, 0, 0)); }), "force is nan N");
  holds(message_of([&] { s.apply_torque("ball", Vec3(0, 1e300, 0)); }), "torque is 1e+300 N m");
  holds(message_of([&] { s.set_velocity("floor", Vec3::Zero(), Vec3::Zero()); }), "'floor' is static");
  holds(message_of([&] { s.set_velocity("ball", Vec3(0, nan, 0), Vec3::Zero()); }), "velocity is nan m/s");
  holds(message_of([&] { s.set_pose("ball", {2 * Mat3::Identity(), Vec3::Zero()}); }), "not a rotation");
  holds(message_of([&] { s.move_to("ball", Pose(), 1); }), "is not kinematic");
  holds(message_of([&] { s.move_to("cart", Pose(), -1); }), "duration is -1 s");
  holds(message_of([&] { s.set_motor_velocity("axle", 1, -1); }), "must be at least 0");
  holds(message_of([&] { s.set_motor_velocity("axle", 1, 1, 1); }), "must be from 0 to 0");
  holds(message_of([&] { s.set_motor_position("axle", 4, 1, 1); }), "target is 4 rad");
  holds(message_of([&] { s.set_friction("rubbr", 1); }), "did you mean 'rubber'?");
  holds(message_of([&] { s.set_friction("rubber", -1); }), "friction is -1");
  holds(message_of([&] { s.set_gravity(Vec3(0, 0, nan)); }), "gravity is nan");
  holds(message_of([&] { s.advance_to(-1); }), "must be at least that of the simulation");
  holds(message_of([&] { s.advance_to(nan); }), "must be at least");
  holds(message_of([&] { s.set_controller([](Simulation&) {}, nan); }), "period");
  holds(message_of([&] { s.restore("nonsense"); }), "not the bytes of a saved simulation");
  holds(message_of([&] { Batch(s.scene(), 0); }), "must be from 1 to 1000000");
  s.set_controller([](Simulation& own) { own.advance_to(5); });
  holds(message_of([&] { s.step(); }), "a controller cannot advance");
  s.set_controller({});
  s.step();
  EXPECT_NEAR(s.time(), 0.01, 1e-15);
}

TEST(SimulationErrors, AJointWithoutAnAxisOfItsOwnTakesNoEffort) {
  Simulation s(scene_with("{scheme: event-driven}", R"(
bodies:
  - {name: ball, position: [0, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
joints:
  - {name: cross, type: universal, bodies: [world, ball], anchor: [0, 0, 0.5], axis: [1, 0, 0], second_axis: [0, 1, 0]}
  - {name: socket, type: ball, bodies: [world, ball], anchor: [0, 0, 0.5]}
)"));
  EXPECT_NE(message_of([&] { s.set_motor_effort("cross", 1); }).find("use set_motor_velocity"),
            std::string::npos);
  EXPECT_NE(message_of([&] { s.set_motor_velocity("socket", 1); }).find("takes no motor"), std::string::npos);
}

TEST(SimulationErrors, WhatAJointCannotHaveIsRefusedWhereItIsSet) {
  Simulation s(scene_with("{scheme: event-driven}", R"(
bodies:
  - {name: ball, position: [0, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
joints:
  - {name: rod, type: distance, bodies: [world, ball], anchors: [[0, 0, 1], [0, 0, 0]]}
)"));
  const std::string before = s.save();
  EXPECT_NE(message_of([&] { s.set_motor_velocity("rod", 1); }).find("give it limits"), std::string::npos);
  EXPECT_NE(message_of([&] { s.set_motor_position("rod", 1, 2, 3); }).find("give it limits"),
            std::string::npos);
  EXPECT_EQ(s.save(), before);
  s.step();
  Simulation alone(scene_with("{scheme: event-driven}", floating_ball));
  EXPECT_EQ(message_of([&] { alone.joint_motion(JointHandle{3}); }), "the scene has no joint");
}

TEST(SimulationErrors, ControllersOfTinyPeriodsEnd) {
  Simulation s(scene_with("{scheme: event-driven}", floating_ball));
  EXPECT_NE(message_of([&] { s.set_controller([](Simulation&) {}, 1e-300); }).find("must be from 1e-12"),
            std::string::npos);
  // After 1e6 s times lie 1.2e-10 s apart: more than the period.
  s.advance_to(1e6);
  int calls = 0;
  s.set_controller([&calls](Simulation&) { ++calls; }, 1e-12);
  s.advance_to(1e6 + 1e-9);
  EXPECT_GT(calls, 0);
  EXPECT_LT(calls, 20);
}

TEST(SimulationErrors, ControllersAreCalledInTimeLateInARun) {
  // 1e6 s are not known to 1e-9 of a millisecond.
  Simulation s(scene_with("{scheme: event-driven}", floating_ball));
  s.advance_to(1e6);
  std::vector<double> times;
  s.set_controller([&times](Simulation& own) { times.push_back(own.time()); }, 0.001);
  s.advance_to(1e6 + 0.0995);
  ASSERT_EQ(times.size(), 100u);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i] - 1e6, 0.001 * double(i), 1e-9);
}

TEST(SimulationErrors, NestedBytesAreNoSavedSimulation) {
  // Each byte begins a list of one: a parser by recursion would fill the stack.
  Simulation s(scene_with("{scheme: event-driven}", floating_ball));
  EXPECT_NE(message_of([&] { s.restore(std::string(3'000'000, '\x81')); }).find("not the bytes of a saved"),
            std::string::npos);
}

TEST(SimulationErrors, StatesOfABatchAreLookedAtBeforeOneIsSet) {
  Batch batch(scene_with("{scheme: event-driven}", floating_ball), 3, 1);
  std::vector<double> states = batch.states();
  states[0] = 7;
  states[2 * 13 + 8] = nan;
  EXPECT_EQ(message_of([&] { batch.set_states(states); }),
            "world 2, body 'ball': velocity is nan m/s, must be from -1e+08 to 1e+08 m/s");
  EXPECT_EQ(batch.world(0).position("ball").x(), 1);
  states[2 * 13 + 8] = 0;
  states[13 + 3] = 0;
  EXPECT_NE(message_of([&] { batch.set_states(states); }).find("must have 1"), std::string::npos);
  EXPECT_EQ(batch.world(0).position("ball").x(), 1);
}

TEST(SimulationErrors, DamagedBytesAreRefusedAndChangeNothing) {
  Simulation s(scene_with("{scheme: event-driven}", busy_scene));
  s.set_motor_velocity("axle", 2);
  s.advance_to(0.1);
  const std::string bytes = s.save();
  const Vec3 before = s.position("ball");
  for (std::size_t i = 0; i < bytes.size(); i += 37) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    try {
      s.restore(damaged);
      s.restore(bytes);
    } catch (const InputError&) {
    }
    ASSERT_EQ(s.position("ball"), before) << i;
  }
  for (std::size_t length = 0; length < bytes.size(); length += 101)
    EXPECT_THROW(s.restore(bytes.substr(0, length)), InputError);
  Simulation other(scene_with("{scheme: event-driven}", floating_ball));
  EXPECT_THROW(other.restore(bytes), InputError);
}

TEST(SimulationErrors, OverlapsAreRefusedOrPushedApart) {
  ModelBuilder builder;
  builder.add_body({.name = "a", .shapes = {{Sphere{1}}}});
  builder.add_body({.name = "b", .p_WU = Vec3(1.5, 0, 0), .shapes = {{Sphere{1}}}});
  EXPECT_NE(message_of([&] { Simulation s(builder.build()); }).find("overlap by 0.5 m"), std::string::npos);
  Scene scene;
  scene.model = builder.build();
  const Simulation apart(scene, true);
  EXPECT_NEAR((apart.position("b") - apart.position("a")).norm(), 2, 1e-5);
  EXPECT_NE(message_of([] { Simulation s(std::shared_ptr<const Model>{}); }).find("no model"),
            std::string::npos);
}

TEST(SimulationErrors, AnInterruptLeavesTheSimulationAsItWas) {
  Simulation s(scene_with("{scheme: event-driven}", busy_scene));
  s.advance_to(0.1);
  const Vec3 before = s.position("ball");
  bool stop = true;
  s.set_interrupt([&stop] { return stop; });
  EXPECT_THROW(s.advance_to(0.5), Interrupted);
  EXPECT_EQ(s.position("ball"), before);
  stop = false;
  s.advance_to(0.5);
  EXPECT_NEAR(s.time(), 0.5, 1e-12);
}

TEST(SimulationErrors, ASimulationThatStoppedSaysWhyAndCanGoOnWhenItIsChanged) {
  Simulation s(scene_with("{scheme: event-driven}", floating_ball));
  s.apply_impulse("ball", Vec3(1e15, 0, 0));
  for (int k = 0; k < 40; ++k) s.apply_impulse("ball", Vec3(1e15, 0, 0));
  s.set_velocity("ball", Vec3(1e8, 0, 0), Vec3::Zero());
  s.step();
  EXPECT_GT(s.position("ball").x(), 9e5);
}

TEST(Batch, WorldsGoTheirOwnWayOnAnyNumberOfThreads) {
  const Scene scene = scene_with("{scheme: event-driven}", busy_scene);
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 3}) {
    Batch batch(scene, 5, threads);
    for (int k = 0; k < 20; ++k) {
      batch.for_each([](int i, Simulation& world) { world.apply_force("ball", Vec3(0.1 * i, 0, 0)); });
      batch.step();
    }
    results.push_back(batch.states());
  }
  EXPECT_EQ(results[0], results[1]);
  ASSERT_EQ(results[0].size(), 5u * 5 * 13);
  // The force makes a difference, and a world alone has the same bits.
  EXPECT_NE(results[0][13], results[0][5 * 13 + 13]);
  Simulation alone(scene);
  for (int k = 0; k < 20; ++k) {
    alone.apply_force("ball", Vec3(0.1 * 3, 0, 0));
    alone.step();
  }
  EXPECT_EQ(Vec3(Vec3::Map(&results[0][3 * 65 + 13])), alone.position("ball"));
}

}  // namespace
}  // namespace rigor::simulation_errors_test
