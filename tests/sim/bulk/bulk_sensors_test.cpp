// Sensors, and all bodies and contacts of a BulkSimulation in arrays.

#include "rigor/core/input_error.hpp"
#include "rigor/sim/bulk/bulk_simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::bulk_sensors_test {
namespace {

constexpr double g = 9.81, kStep = 1.0 / 60;

ModelBuilder ground() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_body({.name = "floor", .motion = MotionType::fixed, .shapes = {{HalfSpace{Vec3::UnitZ(), 0}}}});
  return builder;
}

BodyDescription body_of(const Shape& shape, const Vec3& p_W) {
  return {.p_WU = p_W, .shapes = {{shape}}};
}

TEST(BulkSensors, ABallThatFallsThroughIsFeltFromTheFirstStepToTheLast) {
  ModelBuilder builder = ground();
  BulkSimulation simulation(builder.build());
  const BodyId ball = simulation.add_body(body_of(Sphere{0.1}, Vec3(0, 0, 5)));
  const SensorId sensor =
      simulation.add_sensor({.shape = Box{Vec3(1, 1, 0.5)}, .X_US = {Mat3::Identity(), Vec3(0, 0, 3)}});
  int begins = 0, ends = 0;
  for (int k = 0; k < 120; ++k) {
    simulation.step();
    const double z = simulation.pose(ball)->p.z();
    const bool is_inside = std::abs(z - 3) <= 0.6;
    ASSERT_EQ(simulation.overlaps(sensor)->size(), is_inside ? 1u : 0u) << z;
    for (const SensorEvent& event : simulation.sensor_events()) {
      EXPECT_EQ(event.body, ball);
      EXPECT_EQ(event.sensor, sensor);
      EXPECT_EQ(event.kind == SensorEvent::Kind::begin, is_inside);
      ++(event.kind == SensorEvent::Kind::begin ? begins : ends);
    }
  }
  EXPECT_EQ(begins, 1);
  EXPECT_EQ(ends, 1);
  // It pushes nothing: the ball lies where it would without it.
  EXPECT_NEAR(simulation.pose(ball)->p.z(), 0.1, 1e-3);
  EXPECT_EQ(simulation.remove_sensor(sensor), BulkStatus::done);
  EXPECT_EQ(simulation.remove_sensor(sensor), BulkStatus::no_such_sensor);
  // None on a body that is not there.
  const BodyId gone = simulation.add_body({.shapes = {{Sphere{0.1}}}});
  simulation.remove_body(gone);
  EXPECT_EQ(simulation.add_sensor({.shape = Sphere{1}, .body = gone}), SensorId{});
  EXPECT_FALSE(simulation.overlaps(sensor));
}

TEST(BulkSensors, ABodyThatGoesEndsAndItsSuccessorInThePlaceBegins) {
  BulkSimulation simulation(ground().build());
  const BodyId first = simulation.add_body(body_of(Sphere{0.2}, Vec3(0, 0, 0.2)));
  simulation.add_sensor({.shape = Sphere{1}});
  simulation.step();
  ASSERT_EQ(simulation.sensor_events().size(), 1u);
  for (int k = 0; k < 90; ++k) simulation.step();
  EXPECT_TRUE(*simulation.is_asleep(first));
  EXPECT_TRUE(simulation.sensor_events().empty());  // It sleeps there and is felt still.
  simulation.remove_body(first);
  const BodyId second = simulation.add_body(body_of(Sphere{0.1}, Vec3(0, 0, 0.1)));
  ASSERT_EQ(first.place, second.place);
  simulation.step();
  ASSERT_EQ(simulation.sensor_events().size(), 2u);
  EXPECT_EQ(simulation.sensor_events()[0].body, first);
  EXPECT_EQ(simulation.sensor_events()[0].kind, SensorEvent::Kind::end);
  EXPECT_EQ(simulation.sensor_events()[1].body, second);
}

TEST(BulkSensors, ACarriedSensorGoesWithItsBodyAndFeelsGroupsOfItsMask) {
  BulkSimulation simulation(ground().build());
  BodyDescription carrier = body_of(Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.1));
  carrier.motion = MotionType::kinematic;
  const BodyId cart = simulation.add_body(carrier);
  BodyDescription red = body_of(Sphere{0.1}, Vec3(3, 0, 0.1)), blue = body_of(Sphere{0.1}, Vec3(3, 0.5, 0.1));
  red.group = 2;
  const BodyId felt = simulation.add_body(red);
  simulation.add_body(blue);
  const SensorId eye = simulation.add_sensor(
      {.shape = Sphere{0.8}, .X_US = {Mat3::Identity(), Vec3(1, 0, 0)}, .body = cart, .mask = 2});
  simulation.step();
  EXPECT_TRUE(simulation.overlaps(eye)->empty());
  simulation.set_pose(cart, {Mat3::Identity(), Vec3(2, 0, 0.1)});
  simulation.step();
  ASSERT_EQ(simulation.overlaps(eye)->size(), 1u);
  EXPECT_EQ(simulation.overlaps(eye)->front(), felt);
  simulation.remove_body(cart);
  simulation.step();
  EXPECT_FALSE(simulation.overlaps(eye));
  ASSERT_EQ(simulation.sensor_events().size(), 1u);
  EXPECT_EQ(simulation.sensor_events()[0].kind, SensorEvent::Kind::end);
  EXPECT_THROW(simulation.add_sensor({.shape = HalfSpace{Vec3::UnitZ(), 0}}), InputError);
  EXPECT_THROW(simulation.add_sensor({.shape = Sphere{-1}}), InputError);
}

TEST(BulkArrays, ContactsOfAHeapCarryItsWeightAndLeaveNoTorque) {
  BulkSimulation simulation(ground().build(), {.sleeping = false});
  std::vector<BodyId> cubes;
  for (int i = 0; i < 4; ++i)
    cubes.push_back(
        simulation.add_body(body_of(Box{Vec3(0.25, 0.3, 0.2)}, Vec3(0.03 * i, 0, 0.2 + 0.4 * i))));
  for (int k = 0; k < 300; ++k) simulation.step();
  const ContactLoads loads = simulation.contact_loads();
  const double m = simulation.model().body(1).mass, weight = m * g;
  for (const BodyId& cube : cubes) {
    const std::size_t row = 3 * static_cast<std::size_t>(cube.place);
    EXPECT_LT((Vec3::Map(&loads.force[row]) - Vec3(0, 0, weight)).norm(), 1e-3 * weight);
    // Arms are turned back by what the springs lean (docs/theory/bulk.md): by about a thousandth of the
    // height.
    EXPECT_LT(Vec3::Map(&loads.torque[row]).norm(), 4 * weight * 1e-3 * 0.4);
  }
  EXPECT_NEAR(loads.force[2], -4 * weight, 4e-3 * weight);  // On the floor.
  // Point by point the same.
  const ContactArrays contacts = simulation.contact_arrays();
  Vec3 on_floor = Vec3::Zero();
  for (std::size_t k = 0; k < contacts.gap.size(); ++k) {
    if (contacts.body_A[k] == 0) on_floor -= Vec3::Map(&contacts.force[3 * k]);
  }
  EXPECT_NEAR(on_floor.z(), loads.force[2], 1e-9 * weight);
  const BodyArrays bodies = simulation.body_arrays();
  EXPECT_EQ(bodies.position.size(), 3 * bodies.is_there.size());
  EXPECT_EQ(bodies.is_there[0], 1);
  EXPECT_EQ(bodies.is_there.back(), 0);
  EXPECT_EQ(Vec3(Vec3::Map(&bodies.position[3 * static_cast<std::size_t>(cubes[2].place)])),
            simulation.pose(cubes[2])->p);
}

TEST(BulkArrays, ContactsOfBodiesThatHaveGoneAreNotTold) {
  BulkSimulation simulation(ground().build());
  const BodyId a = simulation.add_body(body_of(Sphere{0.2}, Vec3(0, 0, 0.2))),
               b = simulation.add_body(body_of(Sphere{0.2}, Vec3(2, 0, 0.2)));
  for (int k = 0; k < 5; ++k) simulation.step();
  ASSERT_EQ(simulation.contacts().size(), 2u);
  simulation.remove_body(a);
  ASSERT_EQ(simulation.contacts().size(), 1u);
  EXPECT_EQ(simulation.contacts()[0].body_B, b.place);
  // Not even where places grow.
  for (int i = 0; i < 200; ++i) simulation.add_body(body_of(Sphere{0.2}, Vec3(4 + i, 0, 5)));
  ASSERT_EQ(simulation.contacts().size(), 1u);
  EXPECT_EQ(simulation.contacts()[0].body_B, b.place);
}

}  // namespace
}  // namespace rigor::bulk_sensors_test
