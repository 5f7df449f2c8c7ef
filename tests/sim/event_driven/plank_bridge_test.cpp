// A barrel on planks that hang on distance joints or hinges: near the straight line a small error along the
// chain is a large motion across it, so that putting joints back after a step pushed the planks into the
// barrel.

#include "random_vectors.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "sim/taut_bridges.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace rigor::plank_bridge_test {
namespace {

/// A random bridge of planks between two banks at height 0, with a barrel just above it.
class Bridge {
 public:
  explicit Bridge(test::Random& random)
      : random_(random),
        count_(static_cast<int>(random.uniform(3, 5.999))),
        pitch_(random.uniform(0.2, 0.4)),
        plank_(random.uniform(0.7, 0.85) * pitch_),
        sag_(random.uniform(0.03, 0.12) * count_ * pitch_) {}

  std::shared_ptr<const Model> build() {
    builder_.set_gravity(Vec3(0, 0, -9.81));
    builder_.add_material({"m", random_.uniform(200, 2000), random_.uniform(0.2, 0.8), 0});
    for (int i = 0; i < count_; ++i) add_plank(i);
    for (int i = 0; i <= count_; ++i) add_ropes(i);
    add_barrel();
    return builder_.build();
  }

 private:
  static constexpr double half_thickness = 0.015;

  double height(double x) const {
    const double part = x / (count_ * pitch_);
    return -4 * sag_ * part * (1 - part);
  }
  Vec3 middle(int i) const {
    return {(i + 0.5) * pitch_, 0, 0.5 * (height(i * pitch_) + height((i + 1) * pitch_))};
  }
  double slope(int i) const { return std::atan2(height((i + 1) * pitch_) - height(i * pitch_), pitch_); }
  /// The front (1) or back (-1) edge of a plank, at the ropes of one side.
  Vec3 edge(int i, double end, double y) const {
    return middle(i) +
           Vec3(0.5 * end * plank_ * std::cos(slope(i)), y, 0.5 * end * plank_ * std::sin(slope(i)));
  }
  static std::string plank(int i) { return "plank" + std::to_string(i); }

  void add_plank(int i) {
    BodyDescription body =
        test::stepping_body(plank(i), Box{Vec3(0.5 * plank_, 0.4, half_thickness)}, middle(i));
    body.mass = {};
    body.q_WU = Eigen::AngleAxisd(-slope(i), Vec3::UnitY());
    builder_.add_body(body);
  }

  void add_ropes(int i) {
    const double gap = pitch_ - plank_;
    for (const double y : {-0.36, 0.36}) {
      ModelBuilder::JointDescription rope;
      rope.name = "rope" + std::to_string(i) + (y < 0 ? "right" : "left");
      rope.type = JointType::distance;
      rope.bodies = {i == 0 ? "world" : plank(i - 1), i == count_ ? "world" : plank(i)};
      rope.anchors = {i == 0 ? Vec3(-gap, y, 0) : edge(i - 1, 1, y),
                      i == count_ ? Vec3(count_ * pitch_ + gap, y, 0) : edge(i, -1, y)};
      builder_.add_joint(rope);
    }
  }

  void add_barrel() {
    const int on = count_ / 2;
    const double radius = random_.uniform(0.12, 0.3);
    const double above = (half_thickness + radius) / std::cos(slope(on));
    const Vec3 across(random_.uniform(-0.2, 0.2) * plank_, 0.1 * random_.uniform(-1, 1), above + 0.01);
    BodyDescription body =
        test::stepping_body("barrel", Cylinder{radius, 0.5 * random_.uniform(0.3, 0.6)}, middle(on) + across);
    body.mass = {};
    body.q_WU = Eigen::AngleAxisd(random_.uniform(-0.1, 0.1), Vec3::UnitZ()) *
                Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX());
    body.velocity = Vec3(random_.uniform(-1.5, 1.5), 0, 0);
    builder_.add_body(body);
  }

  ModelBuilder builder_;
  test::Random& random_;
  int count_;
  double pitch_, plank_, sag_;  ///< Of the planks, their length, of the bridge [m].
};

/// The barrel meets the planks within 0.15 s, and none is pushed into it.
void expect_nothing_pushed(const std::shared_ptr<const Model>& model, double step) {
  State state = make_initial_state(*model);
  const Method method;
  EventDrivenStepper stepper(model, method, step);
  const AdvanceReport report = stepper.advance(state, 0.15);
  ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
  EXPECT_GT(report.impacts, 0);
  EXPECT_LE(report.max_penetration, 0.5 * method.contact_tolerance);
}

TEST(PlankBridge, JointsThatArePutBackPushNothingIntoTheBarrel) {
  test::Random random(18);
  for (int k = 0; k < 2; ++k) {
    SCOPED_TRACE(k);
    expect_nothing_pushed(Bridge(random).build(), 0.01);
  }
}

/// A random bridge of eight planks in hinges, with a sag of a hundredth of its length, under a barrel that
/// falls on it.
std::shared_ptr<const Model> hinged_bridge(test::Random& random) {
  const auto near = [&](double value) { return value * random.uniform(0.8, 1.2); };
  constexpr int count = 8;
  const double pitch = near(0.3), width = near(0.5), sag = near(0.02);
  ModelBuilder builder = test::stepping_builder(0, near(0.5), Vec3(0, 0, -9.81));
  test::add_hinged_planks(
      {count, pitch, sag, 1, Vec3(0.425 * pitch, 0.5 * width, 0.015)}, [] { return std::nullopt; }, builder);
  BodyDescription barrel =
      test::stepping_body("barrel", Cylinder{near(0.2), 0.4 * width}, Vec3(near(1.2), 0, 1.3));
  barrel.mass = {};
  barrel.q_WU = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX());
  barrel.velocity = Vec3(near(0.3), 0, -near(2));
  builder.add_body(barrel);
  return builder.build();
}

TEST(PlankBridge, WhatHingesPushIsPartedUntilNothingIsLeft) {
  test::Random random(3);
  for (int k = 0; k < 5; ++k) {
    SCOPED_TRACE(k);
    expect_nothing_pushed(hinged_bridge(random), 0.005);
  }
}

}  // namespace
}  // namespace rigor::plank_bridge_test
