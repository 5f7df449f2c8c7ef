#include "rigor/model/model_changes.hpp"

#include "model/joint_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

namespace rigor::model_changes_test {
namespace {

std::shared_ptr<const Model> two_materials() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -10));
  builder.add_material({.name = "steel", .friction = 0.25, .restitution = 0.5});
  builder.add_material({.name = "ice", .friction = 0, .restitution = 0});
  builder.set_pair("steel", "ice", {.friction = 0.125, .restitution = 0.75});
  return builder.build();
}

TEST(ModelChanges, ReplaceGravityAndSurfacesOfACopy) {
  const std::shared_ptr<const Model> model = two_materials();
  ModelChanges changes = unchanged(*model);
  changes.g_W = Vec3(1, 0, 0);
  changes.surfaces[1] = {.friction = 1, .restitution = 0.25};
  changes.added_forces = {Drag{.body = 0, .linear = 1, .angular = 0}};
  const std::shared_ptr<const Model> changed = changed_model(*model, changes);
  EXPECT_EQ(changed->g_W(), Vec3(1, 0, 0));
  EXPECT_EQ(changed->coefficients(1, 1).friction, 1);
  EXPECT_EQ(changed->coefficients(1, 1).restitution, 0.25);
  EXPECT_EQ(changed->coefficients(1, 2).friction, 0.125) << "a pair with its own values keeps them";
  EXPECT_EQ(changed->forces().size(), 1u);
  EXPECT_EQ(model->g_W(), Vec3(0, 0, -10));
  EXPECT_EQ(model->coefficients(1, 1).friction, 0.25);
}

TEST(ModelChanges, KeepTheJoints) {
  ModelBuilder builder = samples::jointed_bodies();
  builder.add_joint(samples::joint_of(JointType::hinge));
  const std::shared_ptr<const Model> model = builder.build();
  const std::shared_ptr<const Model> changed = changed_model(*model, unchanged(*model));
  ASSERT_EQ(changed->joints().size(), 1u);
  EXPECT_EQ(changed->joint(0).name, "j");
  EXPECT_FALSE(changed->may_collide(0, 1));
}

TEST(ModelChanges, ValuesOutsideTheirLimitsAreRefusedAllAtOnce) {
  const std::shared_ptr<const Model> model = two_materials();
  ModelChanges changes = unchanged(*model);
  changes.g_W.x() = 1e9;
  changes.surfaces[1] = {.friction = -1, .restitution = 2};
  try {
    changed_model(*model, changes);
    FAIL() << "these values make no sense";
  } catch (const InputError& error) {
    ASSERT_EQ(error.messages().size(), 3u);
    EXPECT_EQ(error.messages()[1].substr(0, 35), "material 'steel': friction is -1, m");
  }
}

}  // namespace
}  // namespace rigor::model_changes_test
