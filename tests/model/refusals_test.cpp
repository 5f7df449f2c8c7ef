#include "model/body_samples.hpp"

#include "rigor/core/range.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace rigor::refusals_test {
namespace {

using samples::body_of;
using samples::cube_mesh;
using samples::errors_of;
using ForceDescription = ModelBuilder::ForceDescription;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Every refusal of a body.

TEST(BodyRefused, ForItsMass) {
  BodyDescription body = body_of(Sphere{1});
  for (const double mass : {0.0, -1.0, kNan, limits::infinity, 1e31}) {
    body.mass = mass;
    EXPECT_EQ(errors_of(body),
              "here: body 'ball': mass is " + number_text(mass) + " kg, must be > 0 and at most 1e+30 kg\n");
  }
  body.mass = 1;
  body.density = 2;
  EXPECT_EQ(errors_of(body), "here: body 'ball': only one of 'mass', 'density' and 'inertia' may be given\n");
  body.mass.reset();
  body.density = -1;
  EXPECT_EQ(errors_of(body), "here: body 'ball': density is -1 kg/m³, must be > 0 and at most 1e+12 kg/m³\n");
}

TEST(BodyRefused, ForItsInertia) {
  BodyDescription body;
  body.name = "b";
  EXPECT_EQ(errors_of(body),
            "here: body 'b': it has no shapes, so a dynamic body needs 'inertia' (mass, moments)\n");
  for (const Vec3& moments :
       {Vec3(1, 1, 10), Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, -1), Vec3(kNan, 1, 1)}) {
    body.inertia = GivenInertia{1, Vec3::Zero(), moments};
    EXPECT_TRUE(errors_of(body).starts_with("here: body 'b': ")) << moments.transpose();
  }
  // Positive moments with products that make one principal moment negative.
  body.inertia = GivenInertia{1, Vec3::Zero(), Vec3(1, 1, 1), Vec3(2, 0, 0)};
  EXPECT_NE(errors_of(body), "");
  body.inertia = GivenInertia{0, Vec3::Zero(), Vec3(1, 1, 1)};
  EXPECT_EQ(errors_of(body), "here: body 'b': inertia: mass is 0 kg, must be > 0 and at most 1e+30 kg\n");
}

TEST(BodyRefused, ForNumbersOutOfRange) {
  BodyDescription body = body_of(Sphere{1});
  body.p_WU.x() = 1e30;
  body.q_WU = Quat(1e-200, 0, 0, 0);
  body.angular_velocity.y() = kNan;
  body.linear_drag = -1;
  body.angular_drag = kNan;
  EXPECT_EQ(errors_of(body),
            "here: body 'ball': position is [1e+30, 0, 0] m, each number must be from -1e+09 to 1e+09 m\n"
            "here: body 'ball': orientation has norm 1e-200, must be 1 (off by at most 0.001)\n"
            "here: body 'ball': angular_velocity is [0, nan, 0] rad/s, each number must be from -1e+08 to "
            "1e+08 rad/s\n"
            "here: body 'ball': linear_drag is -1 kg/s, must be from 0 to 1e+15 kg/s\n"
            "here: body 'ball': angular_drag is nan kg m²/s, must be from 0 to 1e+15 kg m²/s\n");
}

TEST(BodyRefused, ForItsName) {
  BodyDescription body = body_of(Sphere{1}, "");
  EXPECT_EQ(errors_of(body), "here: body '': the name is empty\n");
  body.name = "world";
  EXPECT_EQ(errors_of(body), "here: body 'world': the name 'world' means the world itself, choose another\n");
  body.name = "a\nb";
  EXPECT_EQ(errors_of(body), "here: body 'a\\x0ab': the name has a control character\n");
  body.name = "\xff\xfe";
  EXPECT_EQ(errors_of(body), "here: body '\\xff\\xfe': the name is not UTF-8\n");
  body.name = std::string(201, 'x');
  EXPECT_NE(errors_of(body).find("the name has 201 bytes, must be at most 200"), std::string::npos);

  ModelBuilder builder;
  builder.add_body(body_of(Sphere{1}), "1: ");
  builder.add_body(body_of(Sphere{1}), "2: ");
  EXPECT_EQ(builder.check(),
            (std::vector<std::string>{"2: body 'ball': there is already a body of this name"}));
}

TEST(BodyRefused, ForItsShapes) {
  const auto message = [](const Shape& shape) { return errors_of(body_of(shape)); };
  const std::string front = "here: body 'ball': shape 0 ", range = " m, must be from 1e-09 to 1e+09 m\n";
  EXPECT_EQ(message(Sphere{1e-30}), front + "(sphere): radius is 1e-30" + range);
  EXPECT_EQ(message(Capsule{1, -0.5}), front + "(capsule): length is -1 m, must be from 0 to 1e+09 m\n");
  EXPECT_EQ(message(Cylinder{1, 0}), front + "(cylinder): length is 0" + range);
  EXPECT_EQ(message(Cone{kNan, 1}), front + "(cone): radius is nan" + range);
  EXPECT_EQ(message(Box{Vec3(0.1, 0.1, 0)}),
            front + "(box): size is [0.2, 0.2, 0] m, each number must be from 1e-09 to 1e+09 m\n");
  EXPECT_EQ(message(Ellipsoid{Vec3(1, 2, -3)}),
            front + "(ellipsoid): radii is [1, 2, -3] m, each number must be from 1e-09 to 1e+09 m\n");
  EXPECT_EQ(message(HalfSpace{Vec3(0, 0, 2), 0}),
            front + "(plane): normal is [0, 0, 2], must have length 1\n");
  EXPECT_EQ(message(HalfSpace{Vec3::UnitZ(), 0}),
            front + "(plane): a plane has no mass; only static and kinematic bodies have one\n");
  EXPECT_EQ(message(Convex{}), front + "(convex): it has no hull\n");
  EXPECT_EQ(message(Mesh{}), front + "(mesh): it has no triangles\n");
  EXPECT_NE(message(cube_mesh(false)), "");

  BodyDescription body = body_of(Sphere{1});
  body.shapes[0].color = "red";
  body.shapes[0].material = "sten";
  EXPECT_EQ(errors_of(body), front + "(sphere): color is 'red', must be '#rgb' or '#rrggbb'\n" + front +
                                 "(sphere): unknown material 'sten'; one of: default\n");
}

TEST(BodyRefused, OpenMeshOnlyIfItIsDynamic) {
  BodyDescription body = body_of(cube_mesh(false));
  body.motion = MotionType::fixed;
  EXPECT_EQ(errors_of(body), "");
}

TEST(BodyRefused, ForItsMotion) {
  BodyDescription body = body_of(Sphere{1});
  body.motion = MotionType::fixed;
  body.velocity.x() = 1;
  EXPECT_EQ(errors_of(body),
            "here: body 'ball': a static body does not move, but a velocity is given; make it kinematic\n");
  body.velocity.x() = 0;
  body.path = {{0, Vec3::Zero(), Quat::Identity()}};
  EXPECT_EQ(errors_of(body), "here: body 'ball': only a kinematic body has a 'path'\n");
  body.motion = MotionType::kinematic;
  EXPECT_EQ(errors_of(body), "");
  body.p_WU.x() = 1;
  EXPECT_EQ(errors_of(body),
            "here: body 'ball': its path gives position and velocities, so they may not be given as well\n");
}

TEST(BodyRefused, ForItsPath) {
  BodyDescription body = body_of(Sphere{1});
  body.motion = MotionType::kinematic;
  body.path = {{1, Vec3::Zero(), Quat::Identity()}, {1, Vec3::Zero(), Quat::Identity()}};
  EXPECT_EQ(errors_of(body),
            "here: body 'ball': path point 1: time is 1 s, must be > 1 s, the time of the point before\n");
  body.path[1] = {2, Vec3::Zero(), Quat(0, 0, 0, 1)};
  EXPECT_EQ(errors_of(body),
            "here: body 'ball': path point 1: it is half a turn from the point before, which may go either "
            "way; put a "
            "point between\n");
  body.path[1] = {kNan, Vec3(0, 1e10, 0), Quat(0, 0, 0, 0)};
  EXPECT_EQ(errors_of(body),
            "here: body 'ball': path point 1: time is nan s, must be from -1e+09 to 1e+09 s\n"
            "here: body 'ball': path point 1: position is [0, 10000000000, 0] m, each number must be from "
            "-1e+09 to "
            "1e+09 m\n"
            "here: body 'ball': path point 1: orientation has norm 0, must be 1 (off by at most 0.001)\n");
}

// Every refusal of the rest.

TEST(Refused, MaterialsAndPairs) {
  ModelBuilder builder;
  builder.add_material({.name = "a", .restitution = 1.5});
  builder.add_material({.name = "a"});
  builder.add_material({.name = "b", .rolling_friction = -0.1, .torsional_friction = 2e9});
  builder.set_pair("a", "stel", {-1, 0});
  builder.set_pair("a", "b", {0, 0});
  builder.set_pair("b", "a", {0, 2});
  EXPECT_EQ(builder.check(),
            (std::vector<std::string>{
                "material 'a': restitution is 1.5, must be from 0 to 1",
                "material 'a': there is already a material of this name",
                "material 'b': rolling_friction is -0.1 m, must be from 0 to 1e+09 m",
                "material 'b': torsional_friction is 2000000000 m, must be from 0 to 1e+09 m",
                "pair 'a', 'stel': friction is -1, must be from 0 to 1000",
                "pair 'a', 'stel': unknown material 'stel'; one of: a, b, default",
                "pair 'b', 'a': restitution is 2, must be from 0 to 1",
                "pair 'b', 'a': this pair is given twice",
            }));
}

TEST(Refused, ExclusionsAndForces) {
  ModelBuilder builder;
  builder.add_body(body_of(Sphere{1}, "ball"));
  BodyDescription floor = body_of(HalfSpace{Vec3::UnitZ(), 0}, "floor");
  floor.motion = MotionType::fixed;
  builder.add_body(floor);
  builder.exclude_pair("ball", "flor");
  builder.exclude_pair("ball", "ball");
  ForceDescription drag{ForceDescription::Type::drag, {"floor"}};
  builder.add_force(drag);
  drag.bodies = {"bal"};
  builder.add_force(drag);
  drag.bodies = {"ball"};
  drag.linear = -1;
  builder.add_force(drag);
  ForceDescription spring{ForceDescription::Type::spring, {"ball", "ball"}};
  builder.add_force(spring);
  spring.bodies = {"ball"};
  builder.add_force(spring);
  spring.bodies = {"ball", "world"};
  spring.length = -1;
  spring.damping = kNan;
  builder.add_force(spring);
  ForceDescription push{ForceDescription::Type::constant, {"world"}};
  builder.add_force(push);
  EXPECT_EQ(builder.check(), (std::vector<std::string>{
                                 "exclude 'ball', 'flor': unknown body 'flor'; did you mean 'floor'?",
                                 "exclude 'ball', 'ball': a body never collides with itself",
                                 "drag on 'floor': it moves nothing: none of its bodies is dynamic",
                                 "drag on 'bal': unknown body 'bal'; did you mean 'ball'?",
                                 "drag on 'ball': linear is -1 kg/s, must be from 0 to 1e+15 kg/s",
                                 "spring on 'ball': both ends are on the same body",
                                 "spring on 'ball': it names 1 bodies, must name 2",
                                 "spring on 'ball': damping is nan N s/m, must be from 0 to 1e+15 N s/m",
                                 "spring on 'ball': length is -1 m, must be from 0 to 1e+09 m",
                                 "constant force on 'world': it moves nothing: none of its bodies is dynamic",
                             }));
}

TEST(Refused, NotManyBodies) {
  // Files have a limit of bodies, scenes that are built in C++ have none.
  ModelBuilder builder;
  BodyDescription body;
  body.motion = MotionType::fixed;
  for (std::size_t i = 0; i <= limits::body_count; ++i) {
    body.name = std::to_string(i);
    builder.add_body(body);
  }
  EXPECT_EQ(builder.build()->body_count(), 100001);
}

}  // namespace
}  // namespace rigor::refusals_test
