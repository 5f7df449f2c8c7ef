#include "model/body_samples.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/range.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor::model_builder_test {
namespace {

using samples::body_of;
using samples::cube_mesh;
using samples::errors_of;
using ForceDescription = ModelBuilder::ForceDescription;

constexpr double kPi = std::numbers::pi;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const Model> model_of(const BodyDescription& body) {
  ModelBuilder builder;
  builder.add_body(body);
  return builder.build();
}

// Mass properties.

TEST(BodyMass, ComesFromTheMaterialsDensityByDefault) {
  ModelBuilder builder;
  builder.add_material({.name = "steel", .density = 7850});
  BodyDescription ball = body_of(Sphere{0.1});
  ball.shapes[0].material = "steel";
  builder.add_body(ball);
  const Body body = builder.build()->body(0);
  const double mass = 7850 * 4.0 / 3 * kPi * 1e-3;
  EXPECT_NEAR(body.mass, mass, 1e-14 * mass);
  EXPECT_NEAR(body.moments.x(), 0.4 * mass * 0.01, 1e-14 * mass);
}

TEST(BodyMass, DensityOfTheBodyOverridesTheMaterials) {
  BodyDescription ball = body_of(Box{Vec3(0.5, 0.5, 0.5)});
  ball.density = 3;
  EXPECT_NEAR(model_of(ball)->body(0).mass, 3, 1e-15);
}

TEST(BodyMass, MassScalesTheInertiaOfTheShapes) {
  BodyDescription box = body_of(Box{Vec3(0.5, 1, 1.5)});
  box.mass = 12;
  const Body body = model_of(box)->body(0);
  EXPECT_EQ(body.mass, 12);
  // m (b² + c²) / 12 with full lengths 1, 2, 3.
  EXPECT_LT((body.moments - Vec3(13, 10, 5)).norm(), 1e-14);
}

TEST(BodyMass, SeveralShapesByParallelAxes) {
  // A dumbbell of two balls of radius 1 at x = -3 and x = 5 in L.
  BodyDescription body = body_of(Sphere{1});
  body.shapes.push_back({Sphere{1}});
  body.shapes[0].p_US = Vec3(-3, 0, 0);
  body.shapes[1].p_US = Vec3(5, 0, 0);
  body.mass = 2;
  body.p_WU = Vec3(0, 7, 0);
  const Body dumbbell = model_of(body)->body(0);
  EXPECT_LT((dumbbell.moments - Vec3(0.8, 0.8 + 2 * 16, 0.8 + 2 * 16)).norm(), 1e-13);
  EXPECT_EQ(dumbbell.p_WB, Vec3(1, 7, 0));
  EXPECT_EQ(dumbbell.X_BU.p, Vec3(-1, 0, 0));
  EXPECT_EQ(dumbbell.shapes[0].X_BS.p, Vec3(-4, 0, 0));
  EXPECT_EQ(dumbbell.bounding_radius, 5);
  EXPECT_EQ(dumbbell.shapes[1].radius, 1);
}

TEST(BodyMass, ConeKeepsTheUsersFrameAtHalfHeight) {
  BodyDescription body = body_of(Cone{1, 2});
  body.p_WU = Vec3(0, 0, 10);
  const Body cone = model_of(body)->body(0);
  // The centre of mass lies at a quarter of the height 4 above the base at z = -2.
  EXPECT_NEAR(cone.p_WB.z(), 9, 1e-15);
  EXPECT_NEAR(cone.X_BU.p.z(), 1, 1e-15);
}

TEST(BodyMass, BodyFrameHasThePrincipalAxesAndTheShapeStaysWhereItWas) {
  BodyDescription body = body_of(Box{Vec3(0.5, 1, 1.5)});
  body.mass = 12;
  body.shapes[0].q_US = rotation_exp(Vec3(0.2, -0.5, 0.4));
  body.shapes[0].p_US = Vec3(1, 2, 3);
  body.q_WU = rotation_exp(Vec3(-1, 0.3, 0.2));
  body.p_WU = Vec3(-2, 0, 1);
  const Body built = model_of(body)->body(0);
  std::vector<double> moments(built.moments.begin(), built.moments.end());
  std::sort(moments.begin(), moments.end());
  EXPECT_NEAR(moments[0], 5, 1e-13);
  EXPECT_NEAR(moments[1], 10, 1e-13);
  EXPECT_NEAR(moments[2], 13, 1e-13);

  const Pose X_WU{rotation_matrix(body.q_WU), body.p_WU};
  const Pose X_WB{rotation_matrix(built.q_WB), built.p_WB};
  const Pose X_WS = X_WU * Pose{rotation_matrix(body.shapes[0].q_US), body.shapes[0].p_US};
  const Pose by_body = X_WB * built.shapes[0].X_BS;
  EXPECT_LT((by_body.R - X_WS.R).norm(), 1e-14);
  EXPECT_LT((by_body.p - X_WS.p).norm(), 1e-14);
  const Pose L_again = X_WB * built.X_BU;
  EXPECT_LT((L_again.p - body.p_WU).norm(), 1e-14);
  EXPECT_NEAR(built.q_WB.norm(), 1, 1e-15);
}

TEST(BodyMass, AxesOfTheUserAreKeptWhenTheyArePrincipal) {
  BodyDescription body = body_of(Box{Vec3(1, 0.5, 2)});
  body.q_WU = Quat(0, 0, 0, 1);
  const Body built = model_of(body)->body(0);
  EXPECT_EQ(built.X_BU.R, Mat3::Identity());
  EXPECT_EQ(built.q_WB.coeffs(), body.q_WU.coeffs());
}

TEST(BodyMass, GivenInertiaWithProducts) {
  BodyDescription body;
  body.name = "rod";
  body.inertia = GivenInertia{2, Vec3(0, 0, 1), Vec3(2, 2, 3), Vec3(0.5, 0, 0)};
  const Body built = model_of(body)->body(0);
  EXPECT_EQ(built.mass, 2);
  // Eigenvalues of [[2, 1/2], [1/2, 2]] are 3/2 and 5/2.
  EXPECT_NEAR(built.moments.head<2>().minCoeff(), 1.5, 1e-15);
  EXPECT_NEAR(built.moments.head<2>().maxCoeff(), 2.5, 1e-15);
  EXPECT_EQ(built.moments.z(), 3);
  const Mat3 R_UB = built.X_BU.R.transpose();
  Mat3 I_L;
  I_L << 2, 0.5, 0, 0.5, 2, 0, 0, 0, 3;
  EXPECT_LT((R_UB * built.moments.asDiagonal() * R_UB.transpose() - I_L).norm(), 1e-15);
}

TEST(BodyMass, FlatBodiesAreAllowedAndTheirRoundingToo) {
  BodyDescription body;
  body.name = "plate";
  body.inertia = GivenInertia{1, Vec3::Zero(), Vec3(1, 2, 3)};
  EXPECT_EQ(errors_of(body), "");
  body.inertia->moments.z() = 3 * (1 + 1e-10);
  EXPECT_EQ(errors_of(body), "");
  body.inertia->moments.z() = 3 * (1 + 1e-6);
  EXPECT_NE(errors_of(body), "");
}

TEST(BodyMass, MeshCubeIsABox) {
  BodyDescription body = body_of(cube_mesh());
  body.density = 6;
  const Body built = model_of(body)->body(0);
  EXPECT_NEAR(built.mass, 6, 1e-14);
  EXPECT_LT((built.moments - Vec3(1, 1, 1)).norm(), 1e-14);
  EXPECT_TRUE(std::get<Mesh>(built.shapes[0].shape).tree);
}

TEST(BodyMass, SharedHullGivesTheSameMassEachTime) {
  const auto hull = std::make_shared<const ConvexHull>(make_box_hull(Vec3(0.5, 1, 1.5)));
  ModelBuilder builder;
  for (const double density : {1.0, 2.0}) {
    BodyDescription body = body_of(Convex{hull}, "b" + number_text(density));
    body.density = density;
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_NEAR(model->body(0).mass, 6, 1e-14);
  EXPECT_EQ(model->body(1).mass, 2 * model->body(0).mass);
  EXPECT_EQ(model->body(1).moments, 2 * model->body(0).moments);
}

TEST(BodyMass, ScalesByPowersOfTwoBitForBit) {
  // Lengths × 2, densities kept: mass × 8, inertia × 32.
  BodyDescription small = body_of(Cylinder{0.3, 0.7});
  small.shapes.emplace_back(Box{Vec3(0.1, 0.2, 0.3)}, Vec3(1, 0.1, -0.4), rotation_exp(Vec3(0.1, 0.2, 0.3)));
  BodyDescription large = body_of(Cylinder{0.6, 1.4});
  large.shapes.emplace_back(Box{Vec3(0.2, 0.4, 0.6)}, Vec3(2, 0.2, -0.8), small.shapes[1].q_US);
  const Body a = model_of(small)->body(0), b = model_of(large)->body(0);
  EXPECT_EQ(b.mass, 8 * a.mass);
  EXPECT_EQ(b.moments, 32 * a.moments);
  EXPECT_EQ(b.p_WB, 2 * a.p_WB);
  EXPECT_EQ(b.q_WB.coeffs(), a.q_WB.coeffs());
}

TEST(BodyMass, StaticAndKinematicBodiesHaveNoneAndKeepTheirFrame) {
  BodyDescription body = body_of(Cone{1, 2});
  body.motion = MotionType::fixed;
  body.mass = 5;
  const Body built = model_of(body)->body(0);
  EXPECT_EQ(built.mass, 0);
  EXPECT_EQ(built.moments, Vec3::Zero());
  EXPECT_EQ(built.X_BU.p, Vec3::Zero());
  EXPECT_EQ(built.p_WB, Vec3::Zero());
}

TEST(BodyMass, PlaneHasAnInfiniteRadiusAndDoesNotSetTheScale) {
  ModelBuilder builder;
  BodyDescription floor = body_of(HalfSpace{Vec3::UnitZ(), 0}, "floor");
  floor.motion = MotionType::fixed;
  builder.add_body(floor);
  EXPECT_EQ(builder.build()->length_scale(), 1);
  builder.add_body(body_of(Sphere{0.25}));
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_EQ(model->body(0).bounding_radius, std::numeric_limits<double>::infinity());
  EXPECT_EQ(model->length_scale(), 0.25);
}

// Materials, pairs, collisions.

TEST(Coefficients, CombineAsRootAndMaximumUnlessAPairOverrides) {
  ModelBuilder builder;
  builder.add_material({.name = "a", .friction = 0.2, .restitution = 0.1});
  builder.add_material({.name = "b", .friction = 0.8, .restitution = 0.6});
  builder.add_material({.name = "c", .friction = 0.3, .restitution = 0});
  builder.set_pair("c", "a", {0.01, 0.99});
  const std::shared_ptr<const Model> model = builder.build();
  // Index 0 is the default material.
  EXPECT_EQ(model->materials()[0].name, "default");
  EXPECT_NEAR(model->coefficients(1, 2).friction, 0.4, 1e-16);
  EXPECT_EQ(model->coefficients(1, 2).restitution, 0.6);
  EXPECT_EQ(model->coefficients(3, 3).friction, 0.3);
  EXPECT_EQ(model->coefficients(1, 3).friction, 0.01);
  EXPECT_EQ(model->coefficients(3, 1).restitution, 0.99);
}

TEST(Materials, OneNamedDefaultReplacesTheDefault) {
  ModelBuilder builder;
  builder.add_material({.name = "default", .density = 2});
  builder.add_body(body_of(Box{Vec3(0.5, 0.5, 0.5)}));
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_EQ(model->materials().size(), 1u);
  EXPECT_NEAR(model->body(0).mass, 2, 1e-15);
}

TEST(MayCollide, FollowsMotionGroupsMasksShapesAndExclusions) {
  ModelBuilder builder;
  for (const char* name : {"a", "b", "c"}) builder.add_body(body_of(Sphere{1}, name));
  BodyDescription floor = body_of(HalfSpace{Vec3::UnitZ(), 0}, "floor"), wall = floor, shapeless;
  floor.motion = wall.motion = MotionType::fixed;
  wall.name = "wall";
  builder.add_body(floor);
  builder.add_body(wall);
  shapeless.name = "shapeless";
  shapeless.inertia = GivenInertia{1, Vec3::Zero(), Vec3(1, 1, 1)};
  builder.add_body(shapeless);
  builder.exclude_pair("c", "a");
  BodyDescription masked = body_of(Sphere{1}, "odd");
  masked.group = 2;
  masked.mask = 2;
  builder.add_body(masked);
  const std::shared_ptr<const Model> model = builder.build();
  const auto collide = [&](const char* a, const char* b) {
    return model->may_collide(*model->find_body(a), *model->find_body(b));
  };
  EXPECT_TRUE(collide("a", "b"));
  EXPECT_TRUE(collide("a", "floor"));
  EXPECT_TRUE(collide("floor", "a"));
  EXPECT_FALSE(collide("a", "a"));
  EXPECT_FALSE(collide("floor", "wall"));
  EXPECT_FALSE(collide("a", "shapeless"));
  EXPECT_FALSE(collide("a", "c"));
  EXPECT_FALSE(collide("c", "a"));
  // "a" would take "odd", but not the other way round: both must agree, in either order.
  EXPECT_FALSE(collide("a", "odd"));
  EXPECT_FALSE(collide("odd", "a"));
  EXPECT_FALSE(model->find_body("nobody"));
}

// Forces.

TEST(Forces, PointsAndVectorsAreTakenToTheBodyFrame) {
  ModelBuilder builder;
  BodyDescription cone = body_of(Cone{1, 2}, "cone");  // Centre of mass at z = -1 of L.
  cone.p_WU = Vec3(0, 0, 5);
  builder.add_body(cone);
  ForceDescription push{ForceDescription::Type::constant, {"cone"}};
  push.vector = Vec3(1, 2, 3);
  builder.add_force(push);
  push.points = {Vec3(0, 0, 2)};
  builder.add_force(push);
  ForceDescription spring{ForceDescription::Type::spring, {"world", "cone"}};
  spring.stiffness = 10;
  builder.add_force(spring);
  const std::shared_ptr<const Model> model = builder.build();
  ASSERT_EQ(model->forces().size(), 3u);
  EXPECT_EQ(std::get<ConstantForce>(model->forces()[0]).p_BP, Vec3::Zero());
  EXPECT_NEAR(std::get<ConstantForce>(model->forces()[1]).p_BP.z(), 3, 1e-15);
  const Spring& built = std::get<Spring>(model->forces()[2]);
  EXPECT_EQ(built.body_A, world_body);
  EXPECT_EQ(built.body_B, 0);
  EXPECT_NEAR(built.p_BQ.z(), 1, 1e-15);
  EXPECT_NEAR(built.length, 5, 1e-15);
}

TEST(Forces, AVectorOfTheBodyTurnsIntoThePrincipalFrame) {
  ModelBuilder builder;
  BodyDescription body = body_of(Box{Vec3(0.5, 1, 1.5)}, "box");
  body.shapes[0].q_US = rotation_exp(Vec3(0.3, 0.1, 0.2));
  builder.add_body(body);
  ForceDescription torque{ForceDescription::Type::torque, {"box"}};
  torque.vector = Vec3(1, 2, 3);
  torque.frame_is_body = true;
  builder.add_force(torque);
  const std::shared_ptr<const Model> model = builder.build();
  const ConstantTorque& built = std::get<ConstantTorque>(model->forces()[0]);
  const Vec3 tau_L = model->body(0).X_BU.R.transpose() * built.tau;
  EXPECT_LT((tau_L - Vec3(1, 2, 3)).norm(), 1e-14);
}

// The builder itself.

TEST(ModelBuilderTest, ACopyDoesNotChangeWithItsOriginal) {
  ModelBuilder builder;
  builder.add_body(body_of(Sphere{1}, "a"));
  ModelBuilder copy = builder;
  builder.add_body(body_of(Sphere{1}, "b"));
  EXPECT_EQ(copy.build()->body_count(), 1);
  EXPECT_EQ(builder.build()->body_count(), 2);
}

TEST(ModelBuilderTest, TellsAllMistakesAtOnceEachWithItsPlace) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, kNan), "g: ");
  builder.add_material({.name = "m", .density = -1, .friction = kNan}, "m: ");
  BodyDescription body = body_of(Sphere{-1});
  body.velocity.x() = 1e20;
  builder.add_body(body, "b: ");
  try {
    builder.build();
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(
        error.messages(),
        (std::vector<std::string>{
            "g: world: gravity is [0, 0, nan] m/s², each number must be from -1e+06 to 1e+06 m/s²",
            "m: material 'm': density is -1 kg/m³, must be > 0 and at most 1e+12 kg/m³",
            "m: material 'm': friction is nan, must be from 0 to 1000",
            "b: body 'ball': velocity is [1e+20, 0, 0] m/s, each number must be from -1e+08 to 1e+08 m/s",
            "b: body 'ball': shape 0 (sphere): radius is -1 m, must be from 1e-09 to 1e+09 m"}));
  }
}

TEST(ModelBuilderTest, BodiesFromOnePlaceTellTheirMistakeOnce) {
  ModelBuilder builder;
  for (int i = 0; i < 1000; ++i)
    builder.add_body(body_of(Sphere{-1}, "ball" + std::to_string(i)), "scene.yaml:3:1: ");
  EXPECT_EQ(builder.check().size(), 1u);
}

}  // namespace
}  // namespace rigor::model_builder_test
