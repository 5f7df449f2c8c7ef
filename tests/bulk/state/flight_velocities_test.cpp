// Fast bodies in flight: velocities are kept to more than 32 bits.

#include "random_vectors.hpp"
#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>

namespace rigor::flight_velocities_test {
namespace {

constexpr double g = 9.81;

/// Bodies far from each other, thrown at 1 to 1,000 m/s.
std::shared_ptr<const Model> thrown_bodies(int count, test::Random& random) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  for (int i = 0; i < count; ++i) {
    BodyDescription body;
    body.name = "b" + std::to_string(i);
    body.p_WU = Vec3(1e5 * i, 0, 0);
    body.velocity = std::pow(10, random.uniform(0, 3)) * random.vector().normalized();
    body.mass = std::pow(10, random.uniform(-3, 3));
    body.shapes = {{Box{Vec3(0.1, 0.2, 0.3)}}};
    builder.add_body(body);
  }
  return builder.build();
}

TEST(FlightVelocities, FallsAsGravityPullsHoweverFast) {
  test::Random random(5);
  for (const double h : {1.0 / 60, 0.004}) {
    const std::shared_ptr<const Model> model = thrown_bodies(40, random);
    State state = make_initial_state(*model);
    const State start = state;
    BulkWorld world(model, BulkSettings{});
    world.read(state);
    const int steps = 1000;
    for (int k = 0; k < steps; ++k) world.step(h);
    world.write(state);
    for (int i = 0; i < model->body_count(); ++i) {
      const Vec3 v0 = linear_velocity(*model, start, i), v = linear_velocity(*model, state, i);
      const Vec3 exact = v0 - steps * h * g * Vec3::UnitZ();
      // 32 bits alone would lose up to 1e-3 of what gravity gives to the fastest. What is slow enough for
      // them loses 3e-5 of it at most, all of it along the way of gravity.
      const double share = v0.norm() > 100 ? 1e-6 : 3e-5;
      EXPECT_LE(std::abs(v.z() - exact.z()), share * steps * h * g + 1e-7 * v0.norm()) << v0.norm();
      EXPECT_LE((v - v0).head<2>().norm(), 1e-7 * v0.norm());
    }
  }
}

TEST(FlightVelocities, AFreshWorldGoesOnWithTheSameBits) {
  test::Random random(6);
  const std::shared_ptr<const Model> model = thrown_bodies(40, random);
  State state = make_initial_state(*model);
  BulkWorld whole(model, BulkSettings{});
  whole.read(state);
  for (int k = 0; k < 50; ++k) {
    whole.step(1.0 / 60);
    whole.write(state);
    BulkWorld fresh(model, BulkSettings{});
    fresh.read(state);
    for (int i = 0; i < model->body_count(); ++i) {
      const std::size_t own = static_cast<std::size_t>(i);
      EXPECT_EQ(std::memcmp(whole.bodies().motion[own].v, fresh.bodies().motion[own].v, 3 * sizeof(float)),
                0);
      EXPECT_EQ(whole.bodies().finer_v[own], fresh.bodies().finer_v[own]);
    }
  }
}

}  // namespace
}  // namespace rigor::flight_velocities_test
