#include "rigor/model/carried_state.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace rigor::carried_state_test {
namespace {

BodyDescription ball(const std::string& name, double x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = Vec3(x, 0, 0);
  body.mass = 1;
  body.shapes.push_back({Sphere{0.1}});
  return body;
}

ManifoldMemory manifold(int a, int b) {
  ManifoldMemory memory;
  memory.body_A = a;
  memory.body_B = b;
  memory.shape_A = memory.shape_B = 0;
  memory.point_count = 1;
  memory.normal_impulse[0] = static_cast<float>(10 * a + b);
  return memory;
}

constexpr float kAsleep = std::numeric_limits<float>::infinity();

/// Balls a to d, moving, of which a touches b and c touches d; all sleep.
struct Sample {
  Sample() {
    for (const char* name : {"a", "b", "c", "d"}) builder.add_body(ball(name, name[0] - 'a'));
    model = builder.build();
    state = make_initial_state(*model);
    state.t = 3;
    for (int i = 0; i < 4; ++i)
      state.set_body(i, Vec3(i, 1.0 / 3, 0.1), Quat(0.5, 0.5, 0.5, 0.5), Vec3(0.1 * i, 2, 3), Vec3(0, i, 1));
    state.manifolds = {manifold(0, 1), manifold(2, 3)};
    state.quiet_time.assign(4, kAsleep);
  }
  ModelBuilder builder;
  std::shared_ptr<const Model> model;
  State state;
};

TEST(CarriedState, OfTheSameModelIsTheSame) {
  const Sample sample;
  EXPECT_EQ(carried_state(*sample.model, sample.state, *sample.builder.build()), sample.state);
}

TEST(CarriedState, BodiesAndContactsGoOnUnderTheirNewNumbers) {
  Sample sample;
  EXPECT_TRUE(sample.builder.remove_body("b"));
  sample.builder.add_body(ball("e", 7));
  const std::shared_ptr<const Model> next = sample.builder.build();
  const State carried = carried_state(*sample.model, sample.state, *next);
  EXPECT_EQ(carried.t, 3);
  ASSERT_EQ(carried.body_count(), 4);
  for (const auto& [body, old] : {std::pair(0, 0), std::pair(1, 2), std::pair(2, 3)}) {
    EXPECT_EQ(carried.position(body), sample.state.position(old));
    EXPECT_EQ(carried.linear_momentum(body), sample.state.linear_momentum(old));
    EXPECT_EQ(carried.angular_momentum(body), sample.state.angular_momentum(old));
  }
  EXPECT_EQ(carried.position(3), Vec3(7, 0, 0));
  EXPECT_EQ(carried.epoch[3], 3);
  // c and d touch; who has lost a neighbour is awake, and so is who is new.
  ASSERT_EQ(carried.manifolds.size(), 1u);
  ManifoldMemory expected = manifold(1, 2);
  expected.normal_impulse[0] = 23;
  EXPECT_EQ(carried.manifolds[0], expected);
  EXPECT_EQ(carried.quiet_time, (std::vector<float>{0, kAsleep, kAsleep, 0}));
}

TEST(CarriedState, OrderOfBodiesMayChangeAndContactsStaySorted) {
  const Sample sample;
  ModelBuilder builder;
  for (const char* name : {"c", "d", "a", "b"}) builder.add_body(ball(name, 0));
  const State carried = carried_state(*sample.model, sample.state, *builder.build());
  ASSERT_EQ(carried.manifolds.size(), 2u);
  EXPECT_EQ(carried.manifolds[0].key(), (ContactKey{0, 1, 0, 0, 0}));
  EXPECT_EQ(carried.manifolds[0].normal_impulse[0], 23);
  EXPECT_EQ(carried.manifolds[1].key(), (ContactKey{2, 3, 0, 0, 0}));
}

TEST(CarriedState, BodyOfAnotherShapeKeepsItsPlaceAndVelocities) {
  Sample sample;
  sample.builder.remove_body("a");
  BodyDescription other = ball("a", 0);
  other.shapes[0].p_US = Vec3(0.2, 0, 0);
  other.mass = 5;
  sample.builder.add_body(other);
  const std::shared_ptr<const Model> next = sample.builder.build();
  const int body = *next->find_body("a");
  const State carried = carried_state(*sample.model, sample.state, *next);
  const Pose X_WU =
      Pose{rotation_matrix(carried.orientation(body)), carried.position(body)} * next->body(body).X_BU;
  EXPECT_LT((X_WU.p - sample.state.position(0)).norm(), 1e-15);
  const Vec3 w = angular_velocity(*sample.model, sample.state, 0);
  EXPECT_LT((angular_velocity(*next, carried, body) - w).norm(), 1e-13 * w.norm());
  const Vec3 v = linear_velocity(*sample.model, sample.state, 0) +
                 w.cross(carried.position(body) - sample.state.position(0));
  EXPECT_LT((linear_velocity(*next, carried, body) - v).norm(), 1e-13 * v.norm());
  EXPECT_EQ(carried.quiet_time[static_cast<std::size_t>(body)], 0);
}

TEST(CarriedState, OtherGravityWakesAll) {
  Sample sample;
  sample.builder.set_gravity(Vec3(0, 0, -1));
  const State carried = carried_state(*sample.model, sample.state, *sample.builder.build());
  EXPECT_EQ(carried.quiet_time, std::vector<float>(4, 0));
  EXPECT_EQ(carried.manifolds, sample.state.manifolds);
}

TEST(ModelBuilder, BodyThatIsRemovedTakesWhatNamesItAlong) {
  ModelBuilder builder;
  for (const char* name : {"a", "b", "c"}) builder.add_body(ball(name, 2 * (name[0] - 'a')));
  builder.exclude_pair("a", "b");
  builder.exclude_pair("a", "c");
  ModelBuilder::ForceDescription drag{ModelBuilder::ForceDescription::Type::drag, {"b"}};
  drag.linear = 1;
  builder.add_force(drag);
  for (const auto& [name, other] : {std::pair("first", "a"), std::pair("second", "b")}) {
    ModelBuilder::JointDescription hinge;
    hinge.name = name;
    hinge.type = JointType::hinge;
    hinge.bodies = {"world", other};
    hinge.anchors = {Vec3::Zero()};
    builder.add_joint(hinge);
  }
  ModelBuilder::JointDescription gear;
  gear.name = "gear";
  gear.type = JointType::gear;
  gear.joints = {"first", "second"};
  gear.parameter = 2;
  builder.add_joint(gear);
  ASSERT_EQ(builder.check(), std::vector<std::string>{});
  EXPECT_FALSE(builder.remove_body("d"));
  EXPECT_TRUE(builder.remove_body("b"));
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_EQ(model->body_count(), 2);
  EXPECT_EQ(model->joints().size(), 1u);
  EXPECT_TRUE(model->forces().empty());
  EXPECT_EQ(model->excluded_pairs(), (std::vector<std::pair<int, int>>{{0, 1}}));
}

}  // namespace
}  // namespace rigor::carried_state_test
