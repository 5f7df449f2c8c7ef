// What touches nothing in the many-body path: steps of second order.

#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

namespace rigor::bulk_flight_test {
namespace {

constexpr double gravity = 9.81, kStep = 1.0 / 60;

Method with_substeps(double substeps) {
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  method.substeps = substeps;
  return method;
}

ModelBuilder weighty() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -gravity));
  return builder;
}

BodyDescription body_of(const std::string& name, const Vec3& p_WU, double mass, const Vec3& moments) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p_WU;
  body.inertia = GivenInertia{.mass = mass, .moments = moments};
  return body;
}

/// Kinetic energy and that of the weight [J].
double energy_of(const Model& model, const State& state) {
  double sum = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    const Vec3 w = angular_velocity(model, state, i);
    sum += 0.5 * body.mass * linear_velocity(model, state, i).squaredNorm() +
           0.5 * w.dot(state.angular_momentum(i)) - body.mass * model.g_W().dot(state.position(i));
  }
  return sum;
}

/// Advances a step at a time, calling visit(state) after each.
State advance(const std::shared_ptr<const Model>& model, const Method& method, double t,
              const std::function<void(const State&)>& visit = {}) {
  State state = make_initial_state(*model);
  const auto stepper = make_stepper(model, method, kStep, 1);
  for (int k = 1; k <= std::lround(t / kStep); ++k) {
    EXPECT_EQ(stepper->advance(state, k * kStep).reason, StopReason::reached_end);
    if (visit) visit(state);
  }
  return state;
}

/// The largest change of the energy at the ends of steps [J].
double energy_error(const std::shared_ptr<const Model>& model, const Method& method, double t) {
  const double before = energy_of(*model, make_initial_state(*model));
  double worst = 0;
  advance(model, method, t,
          [&](const State& state) { worst = std::max(worst, std::abs(energy_of(*model, state) - before)); });
  return worst;
}

/// Rods of 1 kg and 0.5 m, level at first, each held to the one before by a joint of the type.
std::shared_ptr<const Model> rods(int count, JointType type, const JointAxis& law = {}) {
  ModelBuilder builder = weighty();
  for (int i = 0; i < count; ++i) {
    const std::string name = "rod" + std::to_string(i);
    builder.add_body(body_of(name, Vec3(0.25 + 0.5 * i, 0, 0), 1, Vec3(0.001, 0.0208333, 0.0208333)));
    ModelBuilder::JointDescription joint;
    joint.name = "j" + name;
    joint.type = type;
    joint.bodies = {i == 0 ? "world" : "rod" + std::to_string(i - 1), name};
    joint.anchors = {Vec3(0.5 * i, 0, 0)};
    if (type == JointType::hinge) {
      joint.axis = Vec3::UnitY();
      joint.axes = {law};
    }
    builder.add_joint(joint);
  }
  return builder.build();
}

/// Two level rods, hinged 0.7 m above each other, and an upright one between their ends: a loop.
std::shared_ptr<const Model> four_bar() {
  ModelBuilder builder = weighty();
  const Vec3 level(0.001, 0.08, 0.08);
  builder.add_body(body_of("upper", Vec3(0.5, 0, 0.7), 1, level));
  builder.add_body(body_of("lower", Vec3(0.5, 0, 0), 1, level));
  builder.add_body(body_of("coupler", Vec3(1, 0, 0.35), 1, Vec3(0.04, 0.04, 0.001)));
  const auto hinge = [&](const std::string& a, const std::string& b, const Vec3& p) {
    builder.add_joint(
        {.name = a + b, .type = JointType::hinge, .bodies = {a, b}, .anchors = {p}, .axis = Vec3::UnitY()});
  };
  hinge("world", "upper", Vec3(0, 0, 0.7));
  hinge("world", "lower", Vec3(0, 0, 0));
  hinge("upper", "coupler", Vec3(1, 0, 0.7));
  hinge("lower", "coupler", Vec3(1, 0, 0));
  return builder.build();
}

TEST(BulkFlight, TheEnergyOfWhatSwingsIsOffInTheSecondOrder) {
  // With whole kicks before displacements the energy oscillates by h g v m/2: 2 % of m g l for a rod of 0.5
  // m.
  const auto hold = [](const char* name, const std::shared_ptr<const Model>& model, double scale,
                       double t = 1.5) {
    const double coarse = energy_error(model, with_substeps(3), t),
                 fine = energy_error(model, with_substeps(6), t);
    EXPECT_LT(coarse, 6e-3 * scale) << name;
    // A quarter of it, and 32 bits.
    EXPECT_LT(fine, 0.35 * coarse + 2e-5 * scale) << name;
  };
  const double weight = gravity * 0.25;
  hold("a rod on a ball joint", rods(1, JointType::ball), weight);
  hold("a rod on a hinge", rods(1, JointType::hinge), weight);
  hold("two rods on hinges", rods(2, JointType::hinge), 4 * weight);
  hold("a rod that has not come to its limit", rods(1, JointType::hinge, {.lower = -2.4, .upper = 2.4}),
       weight, 0.4);
  hold("a loop", four_bar(), gravity * 2);
}

TEST(BulkFlight, BodiesTurnAsEulersEquationsSay) {
  // Random moments and spins; the exact scheme integrates Euler's equations to its tolerance.
  ModelBuilder builder = weighty();
  test::Random random(5);
  const int count = 24;
  for (int i = 0; i < count; ++i) {
    // Moments of a body of three extents; every fourth is one of revolution.
    Vec3 extents = Vec3(1.2, 1.2, 1.2) + random.vector();
    if (i % 4 == 0) extents.y() = extents.z();
    const Vec3 squares = extents.cwiseAbs2();
    BodyDescription body =
        body_of("b" + std::to_string(i), Vec3(5 * i, 0, 0), 1,
                Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()));
    body.q_WU = rotation_exp(3 * random.vector());
    body.velocity = 3 * random.vector();
    body.angular_velocity = 6 * random.vector();
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  const State exact = advance(model, Method{}, 1), bulk = advance(model, with_substeps(6), 1);
  for (int i = 0; i < count; ++i) {
    // (h ω)² / 12 t ω at most, some 1e-3 for the fastest; with whole changes before displacements up to 0.06.
    const double angle =
        2 * std::acos(std::min(1.0, std::abs(exact.orientation(i).dot(bulk.orientation(i)))));
    EXPECT_LT(angle, 1e-3) << i;
    EXPECT_LT((exact.position(i) - bulk.position(i)).norm(), 2e-5) << i;
  }
}

TEST(BulkFlight, ATopKeepsItsEnergy) {
  // Tops on a point, of any three moments, at spins of up to 20 revolutions a second: the torque that turns
  // them is that in the middle of each kick. (Of that before it the energy grew or fell by some per cent in a
  // second.)
  test::Random random(11);
  for (int k = 0; k < 12; ++k) {
    ModelBuilder builder = weighty();
    const double across = 0.02 + 0.01 * k;
    BodyDescription top = body_of("top", Vec3::Zero(), 1, Vec3::Zero());
    top.inertia = GivenInertia{
        .mass = 1, .center = Vec3(0, 0, 0.3), .moments = Vec3(across, (k % 3 == 0 ? 0.9 : 1) * across, 0.02)};
    top.q_WU = rotation_exp(Vec3(0.6, 0, 0));
    top.angular_velocity = top.q_WU * Vec3(0.5 * random.number(), 0, 30 + 8 * k);
    builder.add_body(top);
    ModelBuilder::JointDescription joint;
    joint.name = "point";
    joint.type = JointType::ball;
    joint.bodies = {"world", "top"};
    joint.anchors = {Vec3::Zero()};
    builder.add_joint(joint);
    const std::shared_ptr<const Model> model = builder.build();
    const double kinetic = 0.5 * 0.02 * std::pow(30 + 8 * k, 2);
    EXPECT_LT(energy_error(model, with_substeps(12), 1), 5e-3 * kinetic) << k;
  }
}

TEST(BulkFlight, WhatJointsHoldAtRestIsAtRest) {
  // Friction and a limit hold a level arm: its velocity at the end of a step is none, not that of half a
  // kick.
  const std::shared_ptr<const Model> on_limit = rods(1, JointType::hinge, {.upper = 0}),
                                     by_friction = rods(1, JointType::hinge, {.friction = 5});
  for (const auto& model : {on_limit, by_friction}) {
    const State state = advance(model, with_substeps(6), 0.5);
    EXPECT_LT(angular_velocity(*model, state, 0).norm(), 1e-5);
    EXPECT_LT((state.position(0) - Vec3(0.25, 0, 0)).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace rigor::bulk_flight_test
