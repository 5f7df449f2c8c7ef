#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/math/splitmix64.hpp"
#include "rigor/model/state.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

namespace rigor::scene_reader_test {
namespace {

constexpr double kPi = std::numbers::pi;

Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "scene.yaml", ".", overrides);
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    scene_of(text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// A scene with one body of these keys.
std::string with_body(const std::string& keys) {
  return "rigor: 1\nbodies:\n  - {name: ball, " + keys + "}\n";
}

const char* const kBall = "shapes: [{type: sphere, radius: 0.5}]";

const char* const kEverything = R"(
rigor: 1
name: turntable
world: {gravity: [0, 0, -10]}
run: {duration: 2, step: 0.5, output_interval: 0.25, seed: 7}
method: {scheme: event-driven, integrator: dopri5, orientation: matrix, distance: gjk, toi: ratio, impact: newton,
         simultaneous: lcp, resting: contact-space, lcp: lemke, contact_tolerance: 1e-5, time_tolerance: 1e-9,
         resting_velocity: 0.01, tolerance: 1e-8}
materials:
  - {name: steel, density: 8000, friction: 0.3, restitution: 0.9}
  - {name: ice}
pairs:
  - {between: [steel, ice], friction: 0.02}
bodies:
  - name: ball
    motion: dynamic
    position: [1, 0, 0.1]
    rpy: [0, 0, 90 deg]
    velocity: [0, 0.3, 0]
    angular_velocity: [0, 0, 5]
    mass: 2
    shapes: [{type: sphere, radius: 0.1, material: steel, position: [0, 0, 0], color: "#c33"}]
    group: 3
    mask: 5
    linear_drag: 0.1
    angular_drag: 0.2
  - name: table
    motion: static
    shapes: [{type: plane, normal: [0, 0, 2], offset: -1, material: ice}]
  - name: lift
    motion: kinematic
    shapes: [{type: box, size: [1, 2, 3]}]
    path:
      - {time: 0, position: [5, 0, 0]}
      - {time: 1, position: [5, 0, 1], axis_angle: {axis: [0, 0, 3], angle: 0.5 rad}}
forces:
  - {type: constant, body: ball, force: [1, 0, 0], point: [0, 0, 0.1]}
  - {type: torque, body: ball, torque: [0, 1, 0], frame: body}
  - {type: spring, between: [ball, world], points: [[0, 0, 0], [1, 1, 1]], stiffness: 100, damping: 1, length: 0.5}
  - {type: drag, body: ball, linear: 0.5, angular: 0.25}
exclude: [[ball, lift]]
)";

TEST(SceneReader, ReadsEveryKey) {
  const Scene scene = scene_of(kEverything);
  EXPECT_EQ(scene.name, "turntable");
  EXPECT_EQ(scene.model->name(), "turntable");
  EXPECT_EQ(scene.model->g_W(), Vec3(0, 0, -10));
  EXPECT_EQ(scene.run.duration, 2);
  EXPECT_EQ(scene.run.step, 0.5);
  EXPECT_EQ(scene.run.output_interval, 0.25);
  EXPECT_EQ(scene.run.seed, 7u);

  Method method;
  method.scheme = Scheme::event_driven;
  method.integrator = IntegratorMethod::dopri5;
  method.orientation = OrientationForm::matrix;
  method.toi = ToiMethod::ratio;
  method.impact = RestitutionLaw::newton;
  method.simultaneous = SimultaneousLaw::lcp;
  method.contact_tolerance = 1e-5;
  method.time_tolerance = 1e-9;
  method.resting = RestingMethod::contact_space;
  method.lcp = LcpMethod::lemke;
  method.resting_velocity = 0.01;
  method.tolerance = 1e-8;
  EXPECT_EQ(scene.method, method);

  // 0 default, 1 steel, 2 ice: friction of the pair is given, restitution follows the rule.
  EXPECT_EQ(scene.model->coefficients(1, 2).friction, 0.02);
  EXPECT_EQ(scene.model->coefficients(1, 2).restitution, 0.9);
  EXPECT_EQ(scene.model->materials()[1].density, 8000);
}

TEST(SceneReader, ReadsEveryKeyOfABody) {
  const Scene scene = scene_of(kEverything);
  const Body& ball = scene.model->body(0);
  EXPECT_EQ(ball.p_WB, Vec3(1, 0, 0.1));
  EXPECT_LT(rotation_angle_between(ball.q_WB, rotation_exp(Vec3(0, 0, kPi / 2))), 1e-15);
  EXPECT_EQ(ball.v_WB, Vec3(0, 0.3, 0));
  EXPECT_EQ(ball.w_WB, Vec3(0, 0, 5));
  EXPECT_EQ(ball.mass, 2);
  EXPECT_EQ(ball.group, 3u);
  EXPECT_EQ(ball.mask, 5u);
  EXPECT_EQ(ball.linear_drag, 0.1);
  EXPECT_EQ(ball.angular_drag, 0.2);
  EXPECT_EQ(ball.shapes[0].material, 1);
  EXPECT_EQ(ball.shapes[0].color, "#c33");

  const HalfSpace& plane = std::get<HalfSpace>(scene.model->body(1).shapes[0].shape);
  EXPECT_EQ(plane.normal, Vec3::UnitZ());
  EXPECT_EQ(plane.offset, -1);
  EXPECT_EQ(scene.model->body(1).motion, MotionType::fixed);

  const Body& lift = scene.model->body(2);
  EXPECT_EQ(lift.motion, MotionType::kinematic);
  EXPECT_EQ(std::get<Box>(lift.shapes[0].shape).half_extents, Vec3(0.5, 1, 1.5));
  EXPECT_EQ(prescribed_motion(lift, 0.5).p_WB, Vec3(5, 0, 0.5));
  EXPECT_NEAR(prescribed_motion(lift, 0.5).w_WB.z(), 0.5, 1e-15);
  EXPECT_FALSE(scene.model->may_collide(0, 2));
}

TEST(SceneReader, ReadsEveryForce) {
  const Scene scene = scene_of(kEverything);
  const std::vector<Force>& forces = scene.model->forces();
  ASSERT_EQ(forces.size(), 4u);
  EXPECT_EQ(std::get<ConstantForce>(forces[0]).f, Vec3(1, 0, 0));
  EXPECT_EQ(std::get<ConstantForce>(forces[0]).p_BP, Vec3(0, 0, 0.1));
  EXPECT_TRUE(std::get<ConstantTorque>(forces[1]).frame_is_body);
  EXPECT_EQ(std::get<Spring>(forces[2]).body_B, world_body);
  EXPECT_EQ(std::get<Spring>(forces[2]).p_BQ, Vec3(1, 1, 1));
  EXPECT_EQ(std::get<Spring>(forces[2]).length, 0.5);
  EXPECT_EQ(std::get<Drag>(forces[3]).angular, 0.25);
}

TEST(SceneReader, ReadsEveryShape) {
  const Scene scene = scene_of(R"(
rigor: 1
bodies:
  - name: all
    shapes:
      - {type: sphere, radius: 1}
      - {type: box, size: [2, 4, 6]}
      - {type: capsule, radius: 1, length: 4}
      - {type: cylinder, radius: 1, length: 4}
      - {type: cone, radius: 1, length: 4}
      - {type: ellipsoid, radii: [1, 2, 3]}
      - {type: convex, vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}
)");
  const std::vector<BodyShape>& shapes = scene.model->body(0).shapes;
  ASSERT_EQ(shapes.size(), 7u);
  EXPECT_EQ(std::get<Sphere>(shapes[0].shape).radius, 1);
  EXPECT_EQ(std::get<Box>(shapes[1].shape).half_extents, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<Capsule>(shapes[2].shape).half_length, 2);
  EXPECT_EQ(std::get<Cylinder>(shapes[3].shape).half_length, 2);
  EXPECT_EQ(std::get<Cone>(shapes[4].shape).half_length, 2);
  EXPECT_EQ(std::get<Ellipsoid>(shapes[5].shape).radii, Vec3(1, 2, 3));
  EXPECT_TRUE(std::get<Convex>(shapes[6].shape).hull);
}

TEST(SceneReader, TheSmallestSceneHasTheDocumentedDefaults) {
  const Scene scene = scene_of(with_body(kBall));
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.model->g_W(), Vec3(0, 0, -9.80665));
  EXPECT_EQ(scene.method, Method{});
  EXPECT_EQ(scene.run.duration, 10);
  EXPECT_EQ(scene.run.step, 0.01);
  EXPECT_EQ(scene.run.output_interval, 0.01);
  EXPECT_EQ(scene.run.seed, 1u);
  const Material& material = scene.model->materials()[0];
  EXPECT_EQ(material.density, 1000);
  EXPECT_EQ(material.friction, 0.5);
  EXPECT_EQ(material.restitution, 0);
  EXPECT_EQ(scene.model->body(0).group, 1u);
  EXPECT_EQ(scene.model->body(0).mask, 65535u);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneReader, ASceneWithoutBodiesIsAllowed) {
  EXPECT_EQ(scene_of("rigor: 1\nbodies: []\njoints: []\nsweep: {}\n").model->body_count(), 0);
}

TEST(SceneReader, JsonGivesTheSameScene) {
  const std::string json = R"({"rigor": 1, "bodies": [
	{"name": "ball 😀", "position": [1, 2, 3e-1], "motion": "dynamic", "mass": 2.5,
	 "shapes": [{"type": "sphere", "radius": 0.5, "color": "#112233"}]}]})";
  const std::string yaml =
      "rigor: 1\nbodies:\n  - name: ball 😀\n    position: [1, 2, 0.3]\n    mass: 2.5\n    shapes:\n      - "
      "type: "
      "sphere\n        radius: 0.5\n        color: '#112233'\n";
  const State a = make_initial_state(*scene_of(json).model), b = make_initial_state(*scene_of(yaml).model);
  EXPECT_EQ(a, b);
  EXPECT_EQ(scene_of(json).model->body(0).name, scene_of(yaml).model->body(0).name);
}

TEST(SceneReader, AliasesMayBeUsed) {
  const Scene scene = scene_of(
      "rigor: 1\nbodies:\n  - {name: a, shapes: &s [{type: sphere, radius: 2}]}\n  - {name: b, shapes: "
      "*s}\n");
  EXPECT_EQ(std::get<Sphere>(scene.model->body(1).shapes[0].shape).radius, 2);
}

// Orientations.

Quat orientation_of(const std::string& keys) {
  return scene_of(with_body(std::string(kBall) + ", " + keys)).model->body(0).q_WB;
}

TEST(Orientation, IsNormalisedOnReading) {
  const Quat q = orientation_of("orientation: [0.7071, 0, 0, 0.7071]");
  EXPECT_NEAR(q.norm(), 1, 2e-16);
  EXPECT_NEAR(q.z(), std::sqrt(0.5), 1e-16);
}

TEST(Orientation, AnglesInDegreesAndRadiansAreTheSame) {
  EXPECT_EQ(orientation_of("axis_angle: {axis: [1, 2, 3], angle: 180 deg}").coeffs(),
            orientation_of("axis_angle: {axis: [2, 4, 6], angle: 3.141592653589793}").coeffs());
  EXPECT_EQ(orientation_of("rpy: [30 deg, 0, 0.5 rad]").coeffs(),
            orientation_of("rpy: [0.5235987755982988, 0, 0.5]").coeffs());
}

TEST(Orientation, RpyTurnsAboutTheFixedAxesXThenYThenZ) {
  const Mat3 R = rotation_matrix(orientation_of("rpy: [90 deg, 0, 90 deg]"));
  // y goes to z by the first turn and stays there; z goes to -y, then to x.
  EXPECT_LT((R * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((R * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-15);
}

// Repeated bodies.

std::string grid(int x, int y, int z, const std::string& jitter, int seed = 1) {
  return "rigor: 1\nrun: {seed: " + std::to_string(seed) +
         "}\nbodies:\n  - {name: ball, position: [10, 0, 0], " + kBall + ", repeat: {count: [" +
         std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) +
         "], spacing: [1, 2, 4], jitter: " + jitter + "}}\n";
}

TEST(Repeat, MakesAGridWithNames) {
  const std::shared_ptr<const Model> model = scene_of(grid(2, 3, 2, "0")).model;
  ASSERT_EQ(model->body_count(), 12);
  EXPECT_EQ(model->body(0).name, "ball[0,0,0]");
  EXPECT_EQ(model->body(1).name, "ball[0,0,1]");
  EXPECT_EQ(model->body(11).name, "ball[1,2,1]");
  EXPECT_EQ(model->body(11).p_WB, Vec3(11, 4, 4));
  EXPECT_EQ(model->body(*model->find_body("ball[1,0,1]")).p_WB, Vec3(11, 0, 4));
}

TEST(Repeat, JitterIsBoundedReproducibleAndFollowsTheSeed) {
  const std::shared_ptr<const Model> model = scene_of(grid(4, 4, 4, "0.25")).model;
  std::set<double> shifts;
  for (int i = 0; i < model->body_count(); ++i) {
    const Vec3 grid_point(10 + i / 16, 2 * (i / 4 % 4), 4 * (i % 4));
    const Vec3 shift = model->body(i).p_WB - grid_point;
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), 0.25);
    shifts.insert(shift.x());
  }
  EXPECT_EQ(shifts.size(), 64u);
  EXPECT_LT(*shifts.begin(), -0.15);
  EXPECT_GT(*shifts.rbegin(), 0.15);
  const State state = make_initial_state(*model);
  EXPECT_EQ(state, make_initial_state(*scene_of(grid(4, 4, 4, "0.25")).model));
  EXPECT_NE(state, make_initial_state(*scene_of(grid(4, 4, 4, "0.25", 2)).model));
}

TEST(Repeat, GeneratorIsThePublishedOne) {
  // First outputs of SplitMix64 for the seed 1234567, as published with many implementations.
  SplitMix64 random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(Repeat, TheLimitIsCheckedBeforeAnythingIsMade) {
  EXPECT_EQ(message_of(grid(1000, 1000, 1000, "0")).substr(0, 16), "scene.yaml:4:87:");
  EXPECT_NE(message_of(grid(1000, 1000, 1000, "0"))
                .find("with it the scene has 1000000000 bodies, must be at most 100000"),
            std::string::npos);
  EXPECT_NE(message_of(grid(1000000000, 1, 1, "0")).find("count is 1000000000, must be from 1 to 100000"),
            std::string::npos);
}

// Overrides.

TEST(Overrides, ChangeAddAndAreChecked) {
  const std::string text = kEverything;
  EXPECT_EQ(scene_of(text, {"bodies.ball.velocity=[0, 0, 1]"}).model->body(0).v_WB, Vec3(0, 0, 1));
  EXPECT_EQ(scene_of(text, {"materials.steel.restitution=0.25"}).model->materials()[1].restitution, 0.25);
  EXPECT_EQ(scene_of(text, {"bodies.ball.shapes.0.radius=0.5"}).model->body(0).bounding_radius, 0.5);
  EXPECT_EQ(scene_of(text, {"bodies[0].shapes[0].radius=0.5"}).model->body(0).bounding_radius, 0.5);
  EXPECT_EQ(scene_of(text, {"bodies.ball.position.2=7"}).model->body(0).p_WB, Vec3(1, 0, 7));
  EXPECT_EQ(scene_of(text, {"run.duration=3", "run.duration=4"}).run.duration, 4);
  EXPECT_EQ(scene_of(with_body(kBall), {"method.integrator=rk4"}).method.integrator, IntegratorMethod::rk4);
  EXPECT_EQ(scene_of(with_body(kBall), {"name=a=b"}).name, "a=b");
}

TEST(Overrides, NamesMayHoldPointsAndBrackets) {
  const std::string text =
      "rigor: 1\nbodies:\n  - {name: a, shapes: &s [{type: sphere, radius: 1}]}\n"
      "  - {name: a.b, shapes: *s}\n  - {name: \"c[1]\", shapes: *s}\n";
  const std::shared_ptr<const Model> model =
      scene_of(text, {"bodies.a.b.mass=2", "bodies.a.mass=3", "bodies.c[1].mass=4"}).model;
  EXPECT_EQ(model->body(0).mass, 3);
  EXPECT_EQ(model->body(1).mass, 2);
  EXPECT_EQ(model->body(2).mass, 4);
}

TEST(Overrides, DoNotReachThroughAliases) {
  const std::string text =
      "rigor: 1\nbodies:\n  - {name: a, shapes: &s [{type: sphere, radius: 2}]}\n  - {name: b, shapes: *s}\n";
  const std::shared_ptr<const Model> model = scene_of(text, {"bodies.a.shapes.0.radius=1"}).model;
  EXPECT_EQ(model->body(0).bounding_radius, 1);
  EXPECT_EQ(model->body(1).bounding_radius, 2);
}

TEST(Overrides, TellTheirMistakes) {
  const std::string text = kEverything;
  const auto message = [&](const std::string& override_text) { return message_of(text, {override_text}); };
  EXPECT_EQ(message("run.duration"), "--set run.duration: must be KEY=VALUE");
  EXPECT_EQ(message("=1"), "--set =1: must be KEY=VALUE");
  EXPECT_EQ(message("run.duraton=1"),
            "--set run.duraton=1: unknown key 'duraton' in run; did you mean 'duration'?");
  EXPECT_EQ(message("rnu.duration=1"),
            "--set rnu.duration=1: unknown key 'rnu' in the scene; did you mean 'run'?");
  EXPECT_EQ(message("run.duration=-1"),
            "--set run.duration=-1: run: duration is -1 s, must be > 0 and at most 1e+09 s");
  EXPECT_EQ(message("bodies.bal.mass=1"),
            "--set bodies.bal.mass=1: there is no 'bal' in the list; did you mean 'ball'?");
  EXPECT_EQ(message("bodies.9.mass=1"),
            "--set bodies.9.mass=1: index 9, but the list has 3 entries (the first is 0)");
  EXPECT_EQ(message("bodies.ball.mass.x=1"), "--set bodies.ball.mass.x=1: there is nothing below '2'");
  EXPECT_EQ(message("bodies..mass=1"),
            "--set bodies..mass=1: there is no '' in the list; one of: ball, table, lift");
  EXPECT_EQ(message("run..x=1"), "--set run..x=1: a key is empty");
  EXPECT_EQ(message("run.duration=[1"),
            "--set run.duration=[1: a key that is not plain text, or a bracket that is not closed");
  EXPECT_EQ(message("run.duration="), "--set run.duration=: it is empty");
  EXPECT_EQ(message("bodies.ball.mass=nan"),
            "--set bodies.ball.mass=nan: body 'ball': mass is nan kg, must be > 0 and at most 1e+30 kg");
  std::string deep = "a";
  for (int i = 0; i < 60000; ++i) deep += ".a";
  EXPECT_NE(message(deep + "=1").find("the key has too many parts"), std::string::npos);
}

TEST(Overrides, TheLastOnesMayBeCalledVary) {
  const auto message = [](std::size_t varied) -> std::string {
    try {
      parse_scene(kEverything, "scene.yaml", ".", {"run.duration=-1", "run.step=-2"}, varied);
    } catch (const InputError& error) {
      return error.messages()[0] + "\n" + error.messages()[1];
    }
    return "";
  };
  const std::string duration = "run.duration=-1: run: duration is -1 s, must be > 0 and at most 1e+09 s\n";
  const std::string step = "run.step=-2: run: step is -2 s, must be from 1e-12 to 1e+09 s";
  EXPECT_EQ(message(0), "--set " + duration + "--set " + step);
  EXPECT_EQ(message(1), "--set " + duration + "--vary " + step);
  EXPECT_EQ(message(2), "--vary " + duration + "--vary " + step);
}

TEST(Overrides, MistakesOfTheModelNameThePlaceInTheFile) {
  EXPECT_EQ(message_of(with_body(kBall), {"bodies.ball.mass=1", "bodies.ball.density=2"}),
            "scene.yaml:3:5: body 'ball': only one of 'mass', 'density' and 'inertia' may be given");
}

// Files.

class SceneFiles : public testing::Test {
 protected:
  SceneFiles() : root_(std::filesystem::path(testing::TempDir()) / unique_name()), folder_(root_ / "scene") {
    std::filesystem::create_directories(folder_ / "meshes");
    write(folder_ / "meshes" / "cube.obj", kCube);
    write(root_ / "secret.obj", kCube);
  }
  ~SceneFiles() override { std::filesystem::remove_all(root_); }

  static std::string unique_name() {
    return std::string("rigor_scene_") + testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  static void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path) << text;
  }

  Scene scene_with(const std::string& shape, const std::string& motion = "dynamic") const {
    write(folder_ / "s.yaml",
          "rigor: 1\nbodies:\n  - {name: m, motion: " + motion + ", density: 1, shapes: [" + shape + "]}\n");
    return read_scene(folder_ / "s.yaml");
  }
  std::string message(const std::string& shape, const std::string& motion = "dynamic") const {
    try {
      scene_with(shape, motion);
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string name = (folder_ / "s.yaml").string();
      return text.starts_with(name) ? text.substr(name.size()) : text;
    }
    return "accepted";
  }

  /// Cube of edge 2 about the origin.
  static constexpr const char* kCube =
      "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
      "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  std::filesystem::path root_, folder_;
};

TEST_F(SceneFiles, MeshAndConvexAreReadAndScaled) {
  const Scene mesh = scene_with("{type: mesh, file: meshes/cube.obj, scale: 0.5}");
  EXPECT_NEAR(mesh.model->body(0).mass, 1, 1e-15);
  const Scene stretched = scene_with("{type: convex, file: meshes/../meshes/cube.obj, scale: [0.5, 1, 2]}");
  EXPECT_NEAR(stretched.model->body(0).mass, 8, 1e-14);
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST_F(SceneFiles, EachFileIsReadOnceForAllBodiesAndScales) {
  const Scene scene = scene_with(
      "{type: mesh, file: meshes/cube.obj}, {type: mesh, file: meshes/cube.obj}, {type: mesh, file: "
      "meshes/cube.obj, scale: 2}");
  const std::vector<BodyShape>& shapes = scene.model->body(0).shapes;
  EXPECT_EQ(std::get<Mesh>(shapes[0].shape).mesh, std::get<Mesh>(shapes[1].shape).mesh);
  EXPECT_NE(std::get<Mesh>(shapes[0].shape).mesh, std::get<Mesh>(shapes[2].shape).mesh);
}

TEST_F(SceneFiles, OutsideOfTheSceneFolderIsRefused) {
  const std::string outside = " is outside of the scene's folder, must be in it or below";
  const auto mesh = [&](const std::string& file) { return message("{type: mesh, file: '" + file + "'}"); };
  const std::string front = ":3:72: shape 0 (mesh) of body 'm': file ";
  EXPECT_EQ(mesh("../secret.obj"), front + "'../secret.obj'" + outside);
  EXPECT_EQ(mesh("../../../../../../etc/passwd"), front + "'../../../../../../etc/passwd'" + outside);
  EXPECT_EQ(mesh("meshes/../../secret.obj"), front + "'meshes/../../secret.obj'" + outside);
  EXPECT_EQ(mesh("../scene2/x.obj"), front + "'../scene2/x.obj'" + outside);
  EXPECT_EQ(mesh("/etc/passwd"), front + "is '/etc/passwd', must be a path relative to the scene's folder");
  EXPECT_EQ(mesh(""), front + "is '', must be a path relative to the scene's folder");
  std::filesystem::create_symlink(root_ / "secret.obj", folder_ / "link.obj");
  EXPECT_EQ(mesh("link.obj"), front + "'link.obj'" + outside);
}

TEST_F(SceneFiles, WhatIsNoMeshFileIsRefused) {
  const std::string front = ":3:72: shape 0 (mesh) of body 'm': ";
  EXPECT_EQ(message("{type: mesh, file: nothing.obj}"),
            front + "there is no file 'nothing.obj' in the scene's folder");
  EXPECT_EQ(message("{type: mesh, file: meshes}"),
            front + "file 'meshes' is a directory or a device, must be a file");
  write(folder_ / "bad.obj", "v 1 2\n");
  EXPECT_TRUE(message("{type: mesh, file: bad.obj}").starts_with(front + "bad.obj:1"));
}

TEST_F(SceneFiles, OpenMeshOnlyOnBodiesThatNeedNoMass) {
  std::string open = kCube;
  write(folder_ / "open.obj", open.substr(0, open.rfind("f 2")));
  EXPECT_EQ(message("{type: mesh, file: open.obj}", "static"), "accepted");
  EXPECT_TRUE(message("{type: mesh, file: open.obj}").starts_with(":3:5: body 'm': shape 0 (mesh): "));
}

TEST_F(SceneFiles, MeshesAreFoundBesideTheSceneWhateverTheCurrentFolder) {
  EXPECT_EQ(message("{type: mesh, file: ./meshes/cube.obj}"), "accepted");
}

TEST(ReadScene, RefusesWhatIsNoFile) {
  EXPECT_THROW(read_scene("no/such/scene.yaml"), InputError);
  EXPECT_THROW(read_scene(std::filesystem::temp_directory_path()), InputError);
}

// Warnings.

TEST(Warnings, TellWhatIsProbablyNotMeant) {
  const Scene scene = scene_of("rigor: 1\nbodies:\n  - {name: a, motion: static, mass: 1}\n");
  EXPECT_EQ(scene.warnings,
            (std::vector<std::string>{"scene.yaml:3:5: body 'a': it is not dynamic, so its mass is not used",
                                      "scene.yaml:3:5: body 'a': it has no shapes, so it touches nothing"}));
}

}  // namespace
}  // namespace rigor::scene_reader_test
