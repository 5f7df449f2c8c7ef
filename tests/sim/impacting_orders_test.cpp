// Orders of convergence of the schemes through an impact: a ball that falls with drag, bounces once and
// rises.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace rigor::impacting_orders_test {
namespace {

constexpr double g = 9.81, drag = 1.5, restitution = 0.7, radius = 0.1, duration = 0.5;

/// Height and velocity of a mass of 1 kg under gravity and linear drag, v' = -g - c v, after a time t.
struct Fall {
  double z, v;
};
Fall fall(const Fall& start, double t) {
  const double decay = std::exp(-drag * t), excess = start.v + g / drag;
  return {start.z + excess * (1 - decay) / drag - g / drag * t, excess * decay - g / drag};
}

/// Height of the centre at the end, from a fall of this height: one bounce, at the root of the first flight.
double exact_height(double height) {
  const Fall start{height, 0};
  double t = std::sqrt(2 * height / g);
  for (int iteration = 0; iteration < 50; ++iteration) t -= fall(start, t).z / fall(start, t).v;
  const Fall rise{0, -restitution * fall(start, t).v};
  return radius + fall(rise, duration - t).z;
}

std::shared_ptr<const Model> falling_ball(double height, double drag_of_model, double e) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({"m", 1000, 0, e});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  BodyDescription ball;
  ball.name = "ball";
  ball.mass = 1;
  ball.p_WU = Vec3(0, 0, radius + height);
  ball.shapes.push_back({Sphere{radius}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(ball);
  if (drag_of_model > 0) {
    ModelBuilder::ForceDescription force{ModelBuilder::ForceDescription::Type::drag, {"ball"}, {}};
    force.linear = drag_of_model;
    builder.add_force(force);
  }
  return builder.build();
}

double end_height(const std::shared_ptr<const Model>& model, const Method& method, double step) {
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, step);
  State state = make_initial_state(*model);
  EXPECT_EQ(stepper->advance(state, duration).reason, StopReason::reached_end);
  return state.position(1).z();
}

/// Root of the mean square error of falls from several heights: where in its step the impact lies differs.
double rms_error(const Method& method, double step) {
  constexpr int falls = 8;
  double sum = 0;
  for (int k = 0; k < falls; ++k) {
    const double height = 0.4 + 0.0173 * k;
    const double error =
        end_height(falling_ball(height, drag, restitution), method, step) - exact_height(height);
    sum += error * error;
  }
  return std::sqrt(sum / falls);
}

/// The order that a step and a quarter of it show.
double order_of(const Method& method, double step) {
  return std::log2(rms_error(method, step) / rms_error(method, 0.25 * step)) / 2;
}

Method method_of(Scheme scheme, IntegratorMethod integrator) {
  Method method;
  method.scheme = scheme;
  method.integrator = integrator;
  // The impulse-based scheme's impacts are half of this late.
  method.contact_tolerance = 1e-10;
  return method;
}

TEST(ImpactingOrders, SchemesThatLocateImpactsKeepTheOrderOfTheirIntegrator) {
  for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based}) {
    const int name = static_cast<int>(scheme);
    EXPECT_NEAR(order_of(method_of(scheme, IntegratorMethod::euler), 0.01), 1, 0.1) << name;
    EXPECT_NEAR(order_of(method_of(scheme, IntegratorMethod::midpoint), 0.01), 2, 0.1) << name;
    // Down to 1e-10 m, where the envelope of 1e-10 m counts.
    EXPECT_NEAR(order_of(method_of(scheme, IntegratorMethod::rk4), 0.02), 4, 0.2) << name;
  }
}

TEST(ImpactingOrders, TimeSteppingIsOfFirstOrder) {
  // The impact is at the begin of its step. (Longer steps are split at it, since the ball moves far in them.)
  EXPECT_NEAR(order_of(method_of(Scheme::time_stepping, IntegratorMethod::exact), 0.01), 1, 0.2);
}

/// Height at the end after an elastic bounce without drag.
double elastic_height(PenaltyMethod form, double depth) {
  Method method = method_of(Scheme::penalty, IntegratorMethod::exact);
  method.penalty = form;
  method.penalty_depth = depth;
  return end_height(falling_ball(0.5, 0, 1), method, 0.01);
}

TEST(ImpactingOrders, PenaltyIsOfFirstOrderInItsDepth) {
  // An impact at v takes half a period of the spring, π d / v, and all that follows is late by it. What the
  // sub-steps miss of the energy does not depend on d; that is a few hundredths of this way.
  const double speed = std::sqrt(2 * g * 0.5), end_speed = speed - g * (duration - speed / g);
  const double expected = -std::numbers::pi / speed * end_speed;
  for (const PenaltyMethod form : {PenaltyMethod::local, PenaltyMethod::global}) {
    const double slope = (elastic_height(form, 2e-4) - elastic_height(form, 1e-4)) / 1e-4;
    EXPECT_NEAR(slope, expected, 0.03 * std::abs(expected)) << static_cast<int>(form);
  }
}

}  // namespace
}  // namespace rigor::impacting_orders_test
