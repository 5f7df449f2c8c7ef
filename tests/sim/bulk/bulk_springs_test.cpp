// Springs and dampers between points of bodies on the many-body path.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/report/energy.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace rigor::bulk_springs_test {
namespace {

BodyDescription springy_body(const std::string& name, const Shape& shape, double mass) {
  BodyDescription body;
  body.name = name;
  body.mass = mass;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

/// From a point of `A`, which may be the world, to a point of `B`.
ModelBuilder::ForceDescription spring_between(const std::string& A, const std::string& B, const Vec3& p_A,
                                              const Vec3& p_B) {
  ModelBuilder::ForceDescription spring;
  spring.type = ModelBuilder::ForceDescription::Type::spring;
  spring.bodies = {A, B};
  spring.points = {p_A, p_B};
  return spring;
}

/// A ball of 2 kg that is let go 0.1 m from rest on a spring of these numbers that ends far above.
struct Swinger {
  double rate, damping;  ///< √(k/m) [rad/s], d [kg/s].

  std::shared_ptr<const Model> model(double g) const {
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -g));
    builder.add_material({"m", 1000, 0.3, 0});
    BodyDescription ball = springy_body("ball", Sphere{0.1}, 2);
    ball.p_WU = Vec3(0, 0, g > 0 ? 0 : -0.1);
    builder.add_body(ball);
    ModelBuilder::ForceDescription spring = spring_between("world", "ball", Vec3(0, 0, 1), Vec3::Zero());
    spring.stiffness = 2 * rate * rate;
    spring.damping = damping;
    spring.length = 1;
    builder.add_force(spring);
    return builder.build();
  }
};

/// Turning points of the ball, against the period 2π/ω and a motion that neither grows nor dies.
TEST(BulkSprings, ASoftOneKeepsItsPeriodAndItsEnergy) {
  test::Random random(3);
  for (int n = 0; n < 40; ++n) {
    const double h = std::pow(10, random.uniform(-3, -1.5)), swing = random.uniform(0.01, 0.3);  // h ω
    const Swinger swinger{swing / h, 0};
    const std::shared_ptr<const Model> model = swinger.model(0);
    BulkWorld world(model, BulkSettings{});
    State state = make_initial_state(*model);
    world.read(state);
    // Ten periods, counted by the instants at which it comes through the middle.
    double first = 0, last = 0, z = -0.1, highest = 0;
    int crossings = 0;
    while (crossings < 21) {
      world.step(h);
      world.write(state);
      const double now = state.position(0).z();
      if ((z < 0) != (now < 0)) {
        last = world.time() - h * now / (now - z);
        if (crossings++ == 0) first = last;
      }
      z = now;
      if (crossings > 18) highest = std::max(highest, std::abs(z));
    }
    const double period = (last - first) / 10, true_period = 2 * std::numbers::pi / swinger.rate;
    EXPECT_NEAR(period, true_period, (1e-4 + 0.12 * swing * swing) * true_period) << "h ω = " << swing;
    EXPECT_LT(highest, 0.1 * (1 + 0.05 * swing * swing + 1e-5)) << "h ω = " << swing;
    EXPECT_GT(highest, 0.1 * std::exp(-6 * swing * swing * swing) * (1 - 0.2 * swing * swing - 1e-4))
        << "h ω = " << swing;
  }
}

/// Whatever the stiffness is, the weight hangs where the spring holds it.
TEST(BulkSprings, HoldAWeightWhereItHangs) {
  for (const double rate : {5.0, 30.0, 300.0, 1e5}) {
    const Swinger swinger{rate, 4 * rate};
    const std::shared_ptr<const Model> model = swinger.model(9.81);
    BulkWorld world(model, BulkSettings{});
    State state = make_initial_state(*model);
    world.read(state);
    for (int n = 0; n < 600; ++n) world.step(0.01);
    world.write(state);
    const double sag = 9.81 / (rate * rate);
    EXPECT_NEAR(state.position(0).z(), -sag, 1e-4 * sag + 1e-10) << rate;
  }
}

/// Springs to 1e15 on bodies of 1e-6 to 1e6 kg, one alone and two between bodies whose masses differ by up to
/// a hundred times. Of medium stiffness they take and give back some of the energy, at most as much again.
TEST(BulkSprings, OfAnyStiffnessDoNotDriveWhatTheyHold) {
  // Light bodies between heavy ones on stiff springs, that touch, may gain: 1 in 300 of 3,600 draws.
  test::Random random(8);
  int driven = 0;
  for (int n = 0; n < 300; ++n) {
    const double size = std::pow(10, random.uniform(-2, 0)), h = std::pow(10, random.uniform(-3, -1.7));
    const int count = 1 + n / 4 % 2;
    const double mass = std::pow(10, random.uniform(-6, 6));
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 1000, 0.3, 0});
    for (int i = 0; i < count; ++i) {
      BodyDescription body = springy_body("b" + std::to_string(i), Box{size * Vec3(0.3, 0.2, 0.4)},
                                          mass * std::pow(10, random.uniform(-1, 1)));
      body.p_WU = Vec3(3 * size * i, 0, 0);
      body.velocity = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      builder.add_body(body);
      const bool is_damped = random.uniform(0, 1) < 0.5;
      const Vec3 there = i == 0 ? Vec3(0, 0, 2 * size) : Vec3(Vec3::Zero());
      ModelBuilder::ForceDescription spring =
          spring_between(i == 0 ? "world" : "b" + std::to_string(i - 1), body.name, there,
                         0.5 * size * Vec3(n % 2, 0, n / 2 % 2));
      spring.stiffness = std::pow(10, random.uniform(0, 15));
      spring.damping = is_damped ? std::pow(10, random.uniform(-2, 15)) : 0;
      spring.length = size * random.uniform(1, 4);
      builder.add_force(spring);
    }
    const std::shared_ptr<const Model> model = builder.build();
    BulkWorld world(model, BulkSettings{});
    State state = make_initial_state(*model);
    world.read(state);
    const Environment environment(*model);
    const double begin = mechanical_energy(*model, environment, state).total();
    for (int k = 0; k < 100; ++k) world.step(h);
    world.write(state);
    const double end = mechanical_energy(*model, environment, state).total();
    EXPECT_TRUE(std::isfinite(end)) << n;
    if (!(end <= 2 * begin)) ++driven;
  }
  EXPECT_LE(driven, 2);
}

}  // namespace
}  // namespace rigor::bulk_springs_test
