#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

// Every message that a bad scene file can give, word for word: users and scripts rely on them.

namespace rigor::scene_errors_test {
namespace {

struct Mistake {
  std::string text;     ///< The scene, or the part that the test puts into one.
  std::string message;  ///< All messages, joined by line ends.
};

std::string message_of(const std::string& text) {
  try {
    parse_scene(text, "s.yaml", ".");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_each(const std::vector<Mistake>& mistakes, const std::string& before, const std::string& after) {
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(message_of(before + mistake.text + after), mistake.message) << "scene: " << mistake.text;
  }
}

TEST(SceneErrors, TheContractsExampleOfAMisspeltKey) {
  EXPECT_EQ(message_of("rigor: 1\nbodies: []\nmaterials:\n  - {name: m, freiction: 1}\n"),
            "s.yaml:4:15: unknown key 'freiction' in material 'm'; did you mean 'friction'?");
}

TEST(SceneErrors, AllOfAFileInOneGoInTheOrderOfItsLines) {
  EXPECT_EQ(message_of("rigor: 1\n"
                       "nmae: x\n"
                       "bodies:\n"
                       "  - name: a\n"
                       "    mass: -1\n"
                       "    shapes: [{type: sphere, radius: 1, material: steel}]\n"
                       "  - name: a\n"
                       "    shapes: [{type: sphere, radius: 0}]\n"
                       "run: {step: fast}\n"),
            "s.yaml:2:1: unknown key 'nmae' in the scene; did you mean 'name'?\n"
            "s.yaml:4:5: body 'a': shape 0 (sphere): unknown material 'steel'; one of: default\n"
            "s.yaml:5:11: body 'a': mass is -1 kg, must be > 0 and at most 1e+30 kg\n"
            "s.yaml:7:5: body 'a': there is already a body of this name\n"
            "s.yaml:8:37: shape 0 (sphere) of body 'a': radius is 0 m, must be from 1e-09 to 1e+09 m\n"
            "s.yaml:9:13: run: step must be a number (s), found the text 'fast'");
}

TEST(SceneErrors, OfTheTopLevel) {
  expect_each(
      {
          {"bodies: []", "s.yaml:1:1: the scene: the key 'rigor' is missing: a whole number"},
          {"rigor: 1", "s.yaml:1:1: the scene: the key 'bodies' is missing: a list"},
          {"rigor: 2\nbodies: []", "s.yaml:1:8: the scene: rigor is 2, must be 1"},
          {"rigor: '1'\nbodies: []",
           "s.yaml:1:8: the scene: rigor must be a whole number, found the text '1'; write it without "
           "quotes"},
          {"[1, 2]", "s.yaml:1:1: the scene: must be a mapping of keys, found a list of 2"},
          {"just text", "s.yaml:1:1: the scene: must be a mapping of keys, found the text 'just text'"},
          {"rigor: 1\nbodies: 5", "s.yaml:2:9: the scene: bodies must be a list, found the number '5'"},
          {"rigor: 1\nbodies: {}", "s.yaml:2:9: the scene: bodies must be a list, found a mapping"},
          {"rigor: 1\nbodies:", "s.yaml:2:1: the scene: bodies must be a list, found nothing"},
          {"rigor: 1\nbodies: []\nbodies: []",
           "s.yaml:3:1: key 'bodies' is given twice in the scene (first in line 2)"},
          {"rigor: 1\nbodies: []\nname: 5",
           "s.yaml:3:7: the scene: name must be a text, found the number '5'; put it in quotes"},
          {"rigor: 1\nbodies: []\nname: true",
           "s.yaml:3:7: the scene: name must be a text, found true; put it in quotes"},
          {"rigor: 1\nbodies: []\nfriction: 1",
           "s.yaml:3:1: unknown key 'friction' in the scene; it is a key of a material; one of: rigor, name, "
           "world, run, "
           "method, materials, pairs, bodies, exclude, forces, joints, expect, ..."},
          {"rigor: 1\nbodies: []\nworld: {gravity: [0, 0, .nan]}",
           "s.yaml:3:25: world: gravity is nan m/s², must be from -1e+06 to 1e+06 m/s²"},
          {"rigor: 1\nbodies: []\nworld: {gravity: -9.81}",
           "s.yaml:3:18: world: gravity must be 3 numbers [x, y, z] (m/s²), found the number '-9.81'"},
          {"rigor: 1\nbodies: []\nworld: [1]",
           "s.yaml:3:8: world: must be a mapping of keys, found a list of 1"},
      },
      "", "\n");
}

TEST(SceneErrors, OfKeysOfLaterVersions) {
  expect_each(
      {
          {"sweep: {a: 1}",
           "s.yaml:3:1: key 'sweep' of the scene is not available in this version; write 'study' with "
           "'kind: sweep'"},
      },
      "rigor: 1\nbodies: []\n", "\n");
}

TEST(SceneErrors, OfRunAndMethod) {
  expect_each(
      {
          {"run: {step: nan}", "s.yaml:3:13: run: step is nan s, must be from 1e-12 to 1e+09 s"},
          {"run: {step: -0.01}", "s.yaml:3:13: run: step is -0.01 s, must be from 1e-12 to 1e+09 s"},
          {"run: {step: 0}", "s.yaml:3:13: run: step is 0 s, must be from 1e-12 to 1e+09 s"},
          {"run: {duration: 0}", "s.yaml:3:17: run: duration is 0 s, must be > 0 and at most 1e+09 s"},
          {"run: {duration: 1e999}",
           "s.yaml:3:17: run: duration must be a number (s), found the text '1e999'; it is out of the range "
           "of a double"},
          {"run: {duration: 1,5}",
           "s.yaml:3:19: unknown key '5' in run; a number is written with a point, such as 1.5"},
          {"run:\n  duration: 1,5",
           "s.yaml:4:13: run: duration must be a number (s), found the text '1,5'; write 1.5"},
          {"run: {duration: 1e9, output_interval: 1e-9}",
           "s.yaml:3:39: run: duration / output_interval gives 1e+18 outputs, must be at most 100000000"},
          {"run: {seed: 1.5}", "s.yaml:3:13: run: seed is 1.5, must be a whole number"},
          {"run: {seed: -1}", "s.yaml:3:13: run: seed is -1, must be from 0 to 9007199254740992"},
          {"method: {impact: newtn}", "s.yaml:3:18: method: unknown impact 'newtn'; did you mean 'newton'?"},
          {"method: {scheme: time-steping}",
           "s.yaml:3:18: method: unknown scheme 'time-steping'; did you mean 'time-stepping'?"},
          {"method: {scheme: [a]}", "s.yaml:3:18: method: scheme must be a text, found a list of 1"},
          {"method: {orientation: matrix}",
           "s.yaml:3:9: method: orientation 'matrix' does not go with integrator 'exact', which integrates "
           "quaternions; "
           "integrators that do: euler, semi-implicit-euler, midpoint, rk4, dopri5, dop853"},
          {"method: {contact_tolerance: 0}",
           "s.yaml:3:29: method: contact_tolerance is 0 m, must be from 1e-15 to 1e+06 m"},
          {"method: {impct: newton}", "s.yaml:3:10: unknown key 'impct' in method; did you mean 'impact'?"},
      },
      "rigor: 1\nbodies: []\n", "\n");
}

TEST(SceneErrors, OfMaterialsPairsAndExclusions) {
  expect_each(
      {
          {"materials: [{friction: 1}]", "s.yaml:3:13: material 0: the key 'name' is missing: a text"},
          {"materials: [steel]",
           "s.yaml:3:13: material 0: must be a mapping of keys, found the text 'steel'"},
          {"materials: [{name: a}, {name: a}]",
           "s.yaml:3:24: material 'a': there is already a material of this name"},
          {"materials: [{name: a, friction: nan}]",
           "s.yaml:3:33: material 'a': friction is nan, must be from 0 to 1000"},
          {"materials: [{name: a, restitution: 1.5}]",
           "s.yaml:3:36: material 'a': restitution is 1.5, must be from 0 to 1"},
          {"materials: [{name: a, density: 0}]",
           "s.yaml:3:32: material 'a': density is 0 kg/m³, must be > 0 and at most 1e+12 kg/m³"},
          {"materials: [{name: a, density: 0x10}]",
           "s.yaml:3:32: material 'a': density must be a number (kg/m³), found the text '0x10'; numbers are "
           "decimal"},
          {"materials: [{name: steel}]\npairs: [{between: [steel, stel]}]",
           "s.yaml:4:9: pair 'steel', 'stel': unknown material 'stel'; did you mean 'steel'?"},
          {"pairs: [{between: [default]}]",
           "s.yaml:3:19: pair 0: between must be a list of 2 names, found a list of 1"},
          {"pairs: [{friction: 1}]", "s.yaml:3:9: pair 0: the key 'between' is missing: a list of 2 names"},
          {"pairs: [{between: [default, default]}, {between: [default, default]}]",
           "s.yaml:3:40: pair 'default', 'default': this pair is given twice"},
          {"exclude: [[a, b]]",
           "s.yaml:3:11: exclude 'a', 'b': unknown body 'a'\ns.yaml:3:11: exclude 'a', 'b': unknown body "
           "'b'"},
          {"exclude: [a, b]",
           "s.yaml:3:11: exclude must be a list of 2 names, found the text 'a'\ns.yaml:3:14: exclude must be "
           "a list of 2 "
           "names, found the text 'b'"},
      },
      "rigor: 1\nbodies: []\n", "\n");
}

TEST(SceneErrors, OfABody) {
  expect_each(
      {
          {"mass: -1", "s.yaml:3:58: body 'b': mass is -1 kg, must be > 0 and at most 1e+30 kg"},
          {"mass: 0", "s.yaml:3:58: body 'b': mass is 0 kg, must be > 0 and at most 1e+30 kg"},
          {"mass: .inf", "s.yaml:3:58: body 'b': mass is inf kg, must be > 0 and at most 1e+30 kg"},
          {"mass: '%s%s%n'", "s.yaml:3:58: body 'b': mass must be a number (kg), found the text '%s%s%n'"},
          {"mass: [1]", "s.yaml:3:58: body 'b': mass must be a number (kg), found a list of 1"},
          {"mass:", "s.yaml:3:52: body 'b': mass must be a number (kg), found nothing"},
          {"masss: 5", "s.yaml:3:52: unknown key 'masss' in body 'b'; did you mean 'mass'?"},
          {"friction: 5",
           "s.yaml:3:52: unknown key 'friction' in body 'b'; it is a key of a material; one of: name, "
           "motion, position, "
           "orientation, rpy, axis_angle, velocity, angular_velocity, mass, density, inertia, shapes, ..."},
          {"mass: 1, density: 1",
           "s.yaml:3:5: body 'b': only one of 'mass', 'density' and 'inertia' may be given"},
          {"motion: dynamc", "s.yaml:3:60: body 'b': unknown motion 'dynamc'; did you mean 'dynamic'?"},
          {"motion: static, velocity: [1, 0, 0]",
           "s.yaml:3:5: body 'b': a static body does not move, but a velocity is given; make it kinematic"},
          {"position: [1, 2]",
           "s.yaml:3:62: body 'b': position must be 3 numbers [x, y, z] (m), found a list of 2"},
          {"position: [1, 2, 3, 4]",
           "s.yaml:3:62: body 'b': position must be 3 numbers [x, y, z] (m), found a list of 4"},
          {"position: [1e30, 0, abc]",
           "s.yaml:3:63: body 'b': position is 1e+30 m, must be from -1e+09 to 1e+09 m\n"
           "s.yaml:3:72: body 'b': position must be 3 numbers [x, y, z] (m), found the text 'abc'"},
          {"velocity: [0, 0, -1e20]",
           "s.yaml:3:69: body 'b': velocity is -1e+20 m/s, must be from -1e+08 to 1e+08 m/s"},
          {"orientation: [1e-200, 0, 0, 0]",
           "s.yaml:3:65: body 'b': orientation has norm 1e-200, must be 1 (off by at most 0.001)"},
          {"orientation: [1, 0.1, 0, 0]",
           "s.yaml:3:65: body 'b': orientation has norm 1.004987562112089, must be 1 (off by at most 0.001)"},
          {"rpy: [30 dge, 0, 0]",
           "s.yaml:3:58: body 'b': rpy must be 3 angles [x, y, z]: numbers (rad) or texts such as 30 deg, "
           "found the text "
           "'30 dge'"},
          {"axis_angle: {axis: [0, 0, 0], angle: 1}",
           "s.yaml:3:71: axis_angle of body 'b': axis is [0, 0, 0], must have a direction"},
          {"axis_angle: {axis: [0, 0, 1]}",
           "s.yaml:3:64: axis_angle of body 'b': the key 'angle' is missing: an angle: a number (rad) or a "
           "text such as "
           "30 deg"},
          {"rpy: [0, 0, 0], orientation: [1, 0, 0, 0]",
           "s.yaml:3:57: body 'b': only one of 'orientation', 'rpy' and 'axis_angle' may be given"},
          {"group: 1.5", "s.yaml:3:59: body 'b': group is 1.5, must be a whole number"},
          {"mask: -1", "s.yaml:3:58: body 'b': mask is -1, must be from 0 to 4294967295"},
          {"linear_drag: -1", "s.yaml:3:65: body 'b': linear_drag is -1 kg/s, must be from 0 to 1e+15 kg/s"},
          {"path: [{time: 0}]", "s.yaml:3:5: body 'b': only a kinematic body has a 'path'"},
          {"motion: kinematic, path: [{position: [0, 0, 0]}]",
           "s.yaml:3:78: path point 0 of body 'b': the key 'time' is missing: a number (s)"},
          {"motion: kinematic, path: [{time: 1}, {time: 0}]",
           "s.yaml:3:5: body 'b': path point 1: time is 0 s, must be > 1 s, the time of the point before"},
          {"repeat: {count: [1000, 1000, 1000]}",
           "s.yaml:3:60: body 'b': with it the scene has 1000000000 bodies, must be at most 100000"},
          {"repeat: {count: [0, 1, 1]}",
           "s.yaml:3:69: repeat of body 'b': count is 0, must be from 1 to 100000"},
          {"repeat: {spacing: [0, 1, 1]}",
           "s.yaml:3:60: repeat of body 'b': the key 'count' is missing: 3 whole numbers [x, y, z]"},
          {"motion: kinematic, path: [{time: 0}], repeat: {count: [1, 1, 1]}",
           "s.yaml:3:98: body 'b': a body with a path cannot be repeated"},
      },
      "rigor: 1\nbodies:\n  - {name: b, shapes: [{type: sphere, radius: 1}], ", "}\n");
}

TEST(SceneErrors, OfNames) {
  const std::string shapes = ", shapes: [{type: sphere, radius: 1}]}\n";
  expect_each(
      {
          {"{name: ''", "s.yaml:3:5: body '': the name is empty"},
          {"{name: world",
           "s.yaml:3:5: body 'world': the name 'world' means the world itself, choose another"},
          {"{name: \"a\\nb\"", "s.yaml:3:5: body 'a\\x0ab': the name has a control character"},
          {"{name: 5", "s.yaml:3:12: body '5': name must be a text, found the number '5'; put it in quotes"},
          {"{mass: 1", "s.yaml:3:5: body 0: the key 'name' is missing: a text"},
      },
      "rigor: 1\nbodies:\n  - ", shapes);
}

TEST(SceneErrors, OfInertia) {
  expect_each(
      {
          {"{mass: 1, moments: [1, 1, 10]}",
           "s.yaml:3:5: body 'b': inertia: principal moments are 1, 1 and 10 kg m²: the largest must not "
           "exceed the sum of "
           "the other two"},
          {"{mass: 1, moments: [-1, 1, 1]}",
           "s.yaml:3:44: inertia of body 'b': moments is -1 kg m², must be from 0 to 1e+40 kg m²"},
          {"{moments: [1, 1, 1]}",
           "s.yaml:3:24: inertia of body 'b': the key 'mass' is missing: a number (kg)"},
          {"{mass: 1}",
           "s.yaml:3:24: inertia of body 'b': the key 'moments' is missing: 3 numbers [x, y, z] (kg m²)"},
          {"5", "s.yaml:3:24: inertia of body 'b': must be a mapping of keys, found the number '5'"},
      },
      "rigor: 1\nbodies:\n  - {name: b, inertia: ", "}\n");
  EXPECT_EQ(message_of("rigor: 1\nbodies: [{name: b}]\n"),
            "s.yaml:2:10: body 'b': it has no shapes, so a dynamic body needs 'inertia' (mass, moments)");
  EXPECT_TRUE(message_of("rigor: 1\nbodies: [{name: b, inertia: {mass: 1, moments: [0, 0, 0]}}]\n")
                  .starts_with("s.yaml:2:10: body 'b': inertia: "));
}

TEST(SceneErrors, OfHeightFields) {
  const std::string whose = "shape 0 (heightfield) of body 'b': ";
  expect_each(
      {
          {"{type: heightfield, size: [1, 1]}",
           "s.yaml:3:31: " + whose + "it needs either 'heights' or 'file'"},
          {"{type: heightfield, heights: [[0, 0], [0, 0]]}",
           "s.yaml:3:24: " + whose + "the key 'size' is missing: 2 numbers [x, y] (m)"},
          {"{type: heightfield, size: [1, 0], heights: [[0, 0], [0, 0]]}",
           "s.yaml:3:54: " + whose + "size is 0 m, must be from 1e-09 to 1e+09 m"},
          {"{type: heightfield, size: [1, 1, 1], heights: [[0, 0], [0, 0]]}",
           "s.yaml:3:50: " + whose + "size must be 2 numbers [x, y] (m), found a list of 3"},
          {"{type: heightfield, size: [1, 1], heights: 3}",
           "s.yaml:3:67: " + whose + "heights must be a list of rows of numbers (m), found the number '3'"},
          {"{type: heightfield, size: [1, 1], heights: [0, 1]}",
           "s.yaml:3:68: " + whose + "row 0 of heights must be a list of numbers, found the number '0'"},
          {"{type: heightfield, size: [1, 1], heights: [[0, 1], [0, 1, 2]]}",
           "s.yaml:3:76: " + whose + "row 1 of heights has 3 numbers, must have 2 as row 0"},
          {"{type: heightfield, size: [1, 1], heights: [[0, 1], [0, nan]]}",
           "s.yaml:3:80: " + whose + "heights is nan m, must be from -1e+09 to 1e+09 m"},
          {"{type: heightfield, size: [1, 1], heights: [[0, 1], [0, up]]}",
           "s.yaml:3:80: " + whose + "heights must be a list of rows of numbers (m), found the text 'up'"},
          {"{type: heightfield, size: [1, 1], heights: [[0, 1, 2]]}",
           "s.yaml:3:67: " + whose + "the heights are 1 by 3, must be at least 2 rows of 2"},
          {"{type: heightfield, size: [1, 1], base: 0, heights: [[0, 1], [0, 1]]}",
           "s.yaml:3:64: " + whose + "base is 0 m, must be from 1e-09 to 1e+09 m"},
          {"{type: heightfield, size: [1, 1], base: 1e-9, heights: [[1e9, 1e9], [1e9, 1e9]]}",
           "s.yaml:3:64: " + whose + "base is 1e-09 m, too small beside heights of 1000000000 m"},
          {"{type: heightfield, size: [1, 1], file: no.csv}",
           "s.yaml:3:64: " + whose + "there is no file 'no.csv' in the scene's folder"},
          {"{type: heightfield, size: [1, 1], heights: [[0, 1], [0, 1]], color: red}",
           "s.yaml:3:5: body 'b': shape 0 (heightfield): color is 'red', must be '#rgb' or '#rrggbb'"},
      },
      "rigor: 1\nbodies:\n  - {name: b, shapes: [", "]}\n");
}

TEST(SceneErrors, OfShapes) {
  const std::string sphere = "shape 0 (sphere) of body 'b': ", box = "shape 0 (box) of body 'b': ";
  expect_each(
      {
          {"{type: sphere}", "s.yaml:3:24: " + sphere + "the key 'radius' is missing: a number (m)"},
          {"{type: sphere, radus: 1}",
           "s.yaml:3:24: " + sphere + "the key 'radius' is missing: a number (m)\n" +
               "s.yaml:3:39: unknown key 'radus' in shape 0 (sphere) of body 'b'; did you mean 'radius'?"},
          {"{type: sphere, radius: 1e-30}",
           "s.yaml:3:47: " + sphere + "radius is 1e-30 m, must be from 1e-09 to 1e+09 m"},
          {"{type: sphere, radius: 1, length: 2}",
           "s.yaml:3:50: unknown key 'length' in shape 0 (sphere) of body 'b'; it is a key of a capsule; one "
           "of: type, "
           "radius, material, position, orientation, rpy, axis_angle, color"},
          {"{type: box, size: [0.1, 0.1, 0]}",
           "s.yaml:3:53: " + box + "size is 0 m, must be from 1e-09 to 1e+09 m"},
          {"{type: box, size: [nan, 0.1, \"0.1\"]}",
           "s.yaml:3:43: " + box + "size is nan m, must be from 1e-09 to 1e+09 m\n" + "s.yaml:3:53: " + box +
               "size must be 3 numbers [x, y, z] (m), found the text '0.1'; write it without quotes"},
          {"{type: shpere, radius: 1}",
           "s.yaml:3:31: shape 0 of body 'b': unknown type 'shpere'; did you mean 'sphere'?"},
          {"{type: [box]}", "s.yaml:3:31: shape 0 of body 'b': type must be a text, found a list of 1"},
          {"{radius: 1}",
           "s.yaml:3:24: shape 0 of body 'b': the key 'type' is missing; one of: sphere, box, capsule, "
           "cylinder, cone, "
           "ellipsoid, plane, cavity, convex, revolution, mesh, heightfield"},
          {"box", "s.yaml:3:24: shape 0 of body 'b': must be a mapping of keys, found the text 'box'"},
          {"{type: plane}",
           "s.yaml:3:5: body 'b': shape 0 (plane): a plane has no mass; only static and kinematic bodies "
           "have one"},
          {"{type: plane, normal: [0, 0, 0]}",
           "s.yaml:3:46: shape 0 (plane) of body 'b': normal is [0, 0, 0], must have a direction"},
          {"{type: sphere, radius: 1, color: red}",
           "s.yaml:3:5: body 'b': shape 0 (sphere): color is 'red', must be '#rgb' or '#rrggbb'"},
          {"{type: convex}",
           "s.yaml:3:31: shape 0 (convex) of body 'b': it needs either 'vertices' or 'file'"},
          {"{type: convex, vertices: [[0, 0]]}",
           "s.yaml:3:50: shape 0 (convex) of body 'b': vertices must be a list of points [x, y, z] (m), "
           "found a list of 2"},
          {"{type: convex, vertices: [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], scale: 2}",
           "s.yaml:3:91: shape 0 (convex) of body 'b': 'scale' is only for a file"},
          {"{type: mesh}", "s.yaml:3:24: shape 0 (mesh) of body 'b': the key 'file' is missing: a text"},
          {"{type: mesh, file: no/such.obj}",
           "s.yaml:3:43: shape 0 (mesh) of body 'b': there is no file 'no/such.obj' in the scene's folder"},
          {"{type: mesh, file: /etc/passwd}",
           "s.yaml:3:43: shape 0 (mesh) of body 'b': file is '/etc/passwd', must be a path relative to the "
           "scene's "
           "folder"},
          {"{type: mesh, file: ../../../../../../../../etc/passwd}",
           "s.yaml:3:43: shape 0 (mesh) of body 'b': file '../../../../../../../../etc/passwd' is outside of "
           "the scene's "
           "folder, must be in it or below"},
          {"{type: mesh, file: a.obj, scale: [1, -1, 1]}",
           "s.yaml:3:43: shape 0 (mesh) of body 'b': there is no file 'a.obj' in the scene's folder\n"
           "s.yaml:3:61: shape 0 (mesh) of body 'b': scale is -1, must be from 1e-09 to 1e+09"},
      },
      "rigor: 1\nbodies:\n  - {name: b, shapes: [", "]}\n");
  EXPECT_EQ(message_of("rigor: 1\nbodies:\n  - name: b\n    shapes:\n      - type: sphere\n        radius: "
                       "1\n        color: #c33\n"),
            "s.yaml:7:9: shape 0 (sphere) of body 'b': color must be a text, found nothing; '#' starts a "
            "comment, put it in "
            "quotes");
  // Points in a plane have no hull: the reason is qhull's, the place is ours.
  EXPECT_TRUE(
      message_of(
          "rigor: 1\nbodies:\n  - {name: b, shapes: [{type: convex, vertices: [[0,0,0],[1,0,0],[0,1,0]]}]}\n")
          .starts_with("s.yaml:3:49: shape 0 (convex) of body 'b': "));
}

TEST(SceneErrors, OfForces) {
  expect_each(
      {
          {"{type: drag, body: bal}", "s.yaml:5:10: drag on 'bal': unknown body 'bal'; did you mean 'ball'?"},
          {"{type: drag, body: floor}",
           "s.yaml:5:10: drag on 'floor': it moves nothing: none of its bodies is dynamic"},
          {"{type: drag, body: ball, linear: -1}",
           "s.yaml:5:43: force 0 (drag): linear is -1 kg/s, must be from 0 to 1e+15 kg/s"},
          {"{type: drag}", "s.yaml:5:10: force 0 (drag): the key 'body' is missing: a text"},
          {"{type: torque, body: ball}",
           "s.yaml:5:10: force 0 (torque): the key 'torque' is missing: 3 numbers [x, y, z] (N m)"},
          {"{type: torque, body: ball, torque: [0, 0, 1], frame: bdy}",
           "s.yaml:5:63: force 0 (torque): unknown frame 'bdy'; did you mean 'body'?"},
          {"{type: constant, body: ball, force: [0, 0, 1e20]}",
           "s.yaml:5:53: force 0 (constant): force is 1e+20 N, must be from -1e+15 to 1e+15 N"},
          {"{type: spring, between: [ball, ball]}",
           "s.yaml:5:10: spring on 'ball': both ends are on the same body"},
          {"{type: spring, between: [ball]}",
           "s.yaml:5:34: force 0 (spring): between must be a list of 2 names, found a list of 1"},
          {"{type: spring, between: [ball, world], points: [[0, 0, 0]]}",
           "s.yaml:5:57: force 0 (spring): points has 1 points, must have 2"},
          {"{type: sprin}", "s.yaml:5:17: force 0: unknown type 'sprin'; did you mean 'spring'?"},
          {"5", "s.yaml:5:10: force 0: must be a mapping of keys, found the number '5'"},
      },
      "rigor: 1\nbodies:\n  - {name: ball, shapes: [{type: sphere, radius: 1}]}\n"
      "  - {name: floor, motion: static, shapes: [{type: plane}]}\nforces: [",
      "]\n");
}

TEST(SceneErrors, NoneFollowsFromAnother) {
  // One misspelt word each: nothing else is said of what depends on it.
  EXPECT_EQ(message_of("rigor: 1\nbodies:\n  - {name: a, shapes: [{type: shpere, radius: 1}]}\n"
                       "forces: [{type: drag, body: a}]\n"),
            "s.yaml:3:31: shape 0 of body 'a': unknown type 'shpere'; did you mean 'sphere'?");
  EXPECT_EQ(message_of("rigor: 1\nmaterials: [{name: m, density: x}]\n"
                       "bodies:\n  - {name: a, shapes: [{type: sphere, radius: 1, material: m}]}\n"),
            "s.yaml:2:32: material 'm': density must be a number (kg/m³), found the text 'x'");
}

TEST(SceneErrors, AreShownUpToTwenty) {
  std::string text = "rigor: 1\nbodies: []\n";
  for (int i = 0; i < 50000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  try {
    parse_scene(text, "s.yaml", ".");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.messages().size(), 21u);
    EXPECT_EQ(error.messages().back(), "these are the first 20 mistakes; there may be more");
  }
}

TEST(SceneErrors, OfLongTextsShowTheirStart) {
  const std::string text = "rigor: 1\nbodies: [{name: b, mass: \"" + std::string(1000000, 'x') + "\"}]\n";
  EXPECT_LT(message_of(text).size(), 400u);
}

}  // namespace
}  // namespace rigor::scene_errors_test
