#include "rigor/sim/work_estimate.hpp"

#include "rigor/model/model_builder.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::work_estimate_test {
namespace {

/// Bricks of 0.2 by 0.1 by 0.1 m on a floor: so many layers, each of two that lie across those below.
std::shared_ptr<const Model> crossed_bricks(int layers) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& p, MotionType motion) {
    BodyDescription body;
    body.name = name;
    body.motion = motion;
    body.p_WU = p;
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), MotionType::fixed);
  for (int layer = 0; layer < layers; ++layer) {
    for (const double side : {-0.05, 0.05}) {
      const bool is_along_x = layer % 2 == 0;
      const Vec3 half = is_along_x ? Vec3(0.1, 0.045, 0.05) : Vec3(0.045, 0.1, 0.05);
      const Vec3 p(is_along_x ? 0 : side, is_along_x ? side : 0, 0.05 + 0.1 * layer);
      add("b" + std::to_string(2 * layer + (side > 0 ? 1 : 0)), Box{half}, p, MotionType::dynamic);
    }
  }
  return builder.build();
}

WorkEstimate estimate(const std::shared_ptr<const Model>& model, Scheme scheme, double duration) {
  Method method;
  method.scheme = scheme;
  RunSettings settings;
  settings.duration = duration;
  return estimate_work(model, method, settings, make_initial_state(*model));
}

TEST(WorkEstimate, OfOneLayerIsLittleAndOfATowerMuch) {
  EXPECT_LT(estimate(crossed_bricks(1), Scheme::impulse_based, 2).seconds, 10);
  EXPECT_GT(estimate(crossed_bricks(4), Scheme::impulse_based, 2).seconds, 60);
}

/// Rods of 0.2 m in a row, 2 mm above a floor, each tied to the next by a ball joint or not.
std::shared_ptr<const Model> row_of_rods(int rods, bool is_tied) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  for (int i = 0; i < rods; ++i) {
    BodyDescription rod;
    rod.name = "rod" + std::to_string(i);
    rod.p_WU = Vec3(0.2 * i, 0, 0.022);
    rod.shapes.push_back({Box{Vec3(0.08, 0.02, 0.02)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(rod);
    if (i == 0 || !is_tied) continue;
    ModelBuilder::JointDescription joint;
    joint.type = JointType::ball;
    joint.name = "joint" + std::to_string(i);
    joint.bodies = {"rod" + std::to_string(i - 1), rod.name};
    joint.anchors = {Vec3(0.2 * i - 0.1, 0, 0.022)};
    builder.add_joint(joint);
  }
  return builder.build();
}

TEST(WorkEstimate, JointsCostWhatTheirEquationsTake) {
  // The same rods without joints cost a small part of it.
  for (const Scheme scheme : {Scheme::impulse_based, Scheme::penalty}) {
    const double tied = estimate(row_of_rods(5, true), scheme, 1).seconds;
    const double alone = estimate(row_of_rods(5, false), scheme, 1).seconds;
    EXPECT_GT(tied, 0.05) << scheme_name(scheme);
    EXPECT_GT(tied, 1.5 * alone) << scheme_name(scheme);
  }
}

TEST(WorkEstimate, GrowsWithTheLengthOfTheRun) {
  const auto model = crossed_bricks(1);
  const double once = estimate(model, Scheme::penalty, 1).amount;
  EXPECT_GT(once, 0);
  EXPECT_NEAR(estimate(model, Scheme::penalty, 10).amount, 10 * once, 5 * once);
}

TEST(WorkEstimate, IsTheSameEachTimeAndNothingForOtherSchemes) {
  const auto model = crossed_bricks(1);
  EXPECT_EQ(estimate(model, Scheme::impulse_based, 1).amount,
            estimate(model, Scheme::impulse_based, 1).amount);
  EXPECT_EQ(estimate(model, Scheme::time_stepping, 1).amount, 0);
  EXPECT_EQ(estimate(model, Scheme::automatic, 1).amount, 0);
}

}  // namespace
}  // namespace rigor::work_estimate_test
