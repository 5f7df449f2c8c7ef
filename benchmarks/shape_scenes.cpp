// Scenes of many bodies of other shapes than boxes and balls, and on other grounds than planes.

#include "shape_scenes.hpp"
#include "scene_parts.hpp"

#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace rigor::bench {

namespace {

/// Hills over a square of 100 x 100 cells of 0.6 m, a sheet of 20,000 triangles.
Mesh make_hills() {
  constexpr int cells = 100;
  constexpr double cell = 0.6;
  TriangleMesh hills;
  for (int i = 0; i <= cells; ++i) {
    for (int k = 0; k <= cells; ++k) {
      const double x = cell * (i - 0.5 * cells), z = cell * (k - 0.5 * cells);
      hills.vertices.push_back(Vec3(x, std::sin(0.4 * x) * std::cos(0.35 * z) + 0.004 * (x * x + z * z), z));
    }
  }
  const auto number = [](int i, int k) { return i * (cells + 1) + k; };
  for (int i = 0; i < cells; ++i) {
    for (int k = 0; k < cells; ++k) {
      hills.triangles.push_back({number(i, k), number(i, k + 1), number(i + 1, k)});
      hills.triangles.push_back({number(i + 1, k), number(i, k + 1), number(i + 1, k + 1)});
    }
  }
  return make_mesh(std::make_shared<const TriangleMesh>(hills));
}

/// Bodies in layers of n x n cells, the lowest at the height `bottom`.
struct Grid {
  int n;
  double pitch, bottom;

  Vec3 place(int number) const {
    const int i = number % n, j = number / n % n, k = number / (n * n);
    return Vec3(pitch * (i - 0.5 * (n - 1)), bottom + pitch * k, pitch * (j - 0.5 * (n - 1)));
  }
};

/// A body of a doll: its place, and the joint that ties it to its parent, relative to the doll.
struct DollPart {
  const char* name;
  Shape shape;
  Vec3 p;
  const char* parent;  ///< Null: none.
  Vec3 anchor;
  bool is_hinge;
};

const std::vector<DollPart>& doll_parts() {
  static const std::vector<DollPart> parts = {
      {"torso", Box{Vec3(0.18, 0.3, 0.12)}, Vec3(0, 0, 0), nullptr, Vec3::Zero(), false},
      {"head", Sphere{0.13}, Vec3(0, 0.46, 0), "torso", Vec3(0, 0.32, 0), false},
      {"arm+", Box{Vec3(0.15, 0.06, 0.06)}, Vec3(0.36, 0.24, 0), "torso", Vec3(0.2, 0.24, 0), false},
      {"arm-", Box{Vec3(0.15, 0.06, 0.06)}, Vec3(-0.36, 0.24, 0), "torso", Vec3(-0.2, 0.24, 0), false},
      {"hand+", Box{Vec3(0.15, 0.05, 0.05)}, Vec3(0.68, 0.24, 0), "arm+", Vec3(0.52, 0.24, 0), true},
      {"hand-", Box{Vec3(0.15, 0.05, 0.05)}, Vec3(-0.68, 0.24, 0), "arm-", Vec3(-0.52, 0.24, 0), true},
      {"thigh+", Box{Vec3(0.08, 0.2, 0.08)}, Vec3(0.1, -0.53, 0), "torso", Vec3(0.1, -0.32, 0), false},
      {"thigh-", Box{Vec3(0.08, 0.2, 0.08)}, Vec3(-0.1, -0.53, 0), "torso", Vec3(-0.1, -0.32, 0), false},
      {"shin+", Box{Vec3(0.06, 0.2, 0.06)}, Vec3(0.1, -0.95, 0), "thigh+", Vec3(0.1, -0.74, 0), true},
      {"shin-", Box{Vec3(0.06, 0.2, 0.06)}, Vec3(-0.1, -0.95, 0), "thigh-", Vec3(-0.1, -0.74, 0), true}};
  return parts;
}

void add_doll(int number, const Vec3& p_W, const Quat& q_W, ModelBuilder& builder) {
  const auto name_of = [&](const char* part) { return fmt::format("{}{}", part, number); };
  for (const DollPart& part : doll_parts()) {
    add_body(name_of(part.name), part.shape, p_W + q_W * part.p, q_W, builder);
    if (part.parent == nullptr) continue;
    ModelBuilder::JointDescription joint;
    joint.name = fmt::format("{}{}joint", part.name, number);
    joint.type = part.is_hinge ? JointType::hinge : JointType::ball;
    joint.bodies = {name_of(part.parent), name_of(part.name)};
    joint.anchors = {p_W + q_W * part.anchor};
    // Knees bend about x, elbows about y; neither backwards.
    joint.axis = q_W * (part.p.y() < 0 ? Vec3::UnitX() : Vec3::UnitY());
    if (part.is_hinge) joint.axes = {JointAxis{.lower = -0.1, .upper = 2.2}};
    builder.add_joint(joint);
  }
}

}  // namespace

std::shared_ptr<const Model> make_terrain() {
  ModelBuilder builder = scene_builder("terrain");
  SceneDraws draws;
  const std::vector<Convex> hulls = draw_hulls(0.5, draws);
  add_fixed("hills", make_hills(), Vec3::Zero(), Quat::Identity(), builder);
  const Grid grid{25, 1.6, 6};
  for (int k = 0; k < 2000; ++k)
    add_body(fmt::format("hull{}", k), hulls[static_cast<std::size_t>(k) % hulls.size()], grid.place(k),
             draw_rotation(draws), builder);
  return builder.build();
}

namespace {

/// A thousand of these shapes, drawn one by one, fall into a pen.
std::shared_ptr<const Model> crowd_in_pen(const std::string& name, const std::string& body,
                                          const std::function<Shape(SceneDraws&)>& draw_shape) {
  ModelBuilder builder = scene_builder(name);
  SceneDraws draws;
  add_ground(builder);
  add_walls(6, 20, builder);
  const Grid grid{10, 1.15, 1};
  for (int k = 0; k < 1000; ++k) {
    const Shape shape = draw_shape(draws);
    add_body(fmt::format("{}{}", body, k), shape, grid.place(k), draw_rotation(draws), builder);
  }
  return builder.build();
}

}  // namespace

std::shared_ptr<const Model> make_cylinders() {
  return crowd_in_pen("cylinders", "cylinder", [](SceneDraws& draws) {
    return Cylinder{draws.between(0.25, 0.4), draws.between(0.2, 0.45)};
  });
}

std::shared_ptr<const Model> make_ellipsoids() {
  return crowd_in_pen("ellipsoids", "ellipsoid", [](SceneDraws& draws) {
    const double x = draws.between(0.25, 0.4), y = draws.between(0.2, 0.45), z = draws.between(0.2, 0.45);
    return Ellipsoid{Vec3(x, y, z)};
  });
}

std::shared_ptr<const Model> make_round_on_mesh() {
  ModelBuilder builder = scene_builder("round_mesh");
  SceneDraws draws;
  add_fixed("hills", make_hills(), Vec3::Zero(), Quat::Identity(), builder);
  const Grid grid{16, 1.6, 6};
  for (int k = 0; k < 1000; ++k) {
    const double r = draws.between(0.25, 0.4), half = draws.between(0.2, 0.45);
    const std::array<Shape, 4> shapes = {Ellipsoid{Vec3(r, half, draws.between(0.2, 0.45))},
                                         Cylinder{r, half}, Cone{r, half}, Capsule{0.6 * r, half}};
    add_body(fmt::format("body{}", k), shapes[static_cast<std::size_t>(k % 4)], grid.place(k),
             draw_rotation(draws), builder);
  }
  return builder.build();
}

std::shared_ptr<const Model> make_bin() {
  ModelBuilder builder = scene_builder("bin");
  SceneDraws draws;
  const std::vector<Convex> hulls = draw_hulls(0.45, draws);
  add_ground(builder);
  add_walls(8, 24, builder);
  const Grid grid{14, 1.12, 1};
  const std::array<Shape, 3> shapes = {Sphere{0.45}, Box{Vec3(0.4, 0.3, 0.35)}, Capsule{0.25, 0.25}};
  for (int k = 0; k < 3000; ++k) {
    const std::size_t kind = static_cast<std::size_t>(k % 4);
    const Shape shape = kind < 3 ? shapes[kind] : Shape(hulls[static_cast<std::size_t>(k) % hulls.size()]);
    add_body(fmt::format("body{}", k), shape, grid.place(k), draw_rotation(draws), builder);
  }
  return builder.build();
}

std::shared_ptr<const Model> make_dolls() {
  ModelBuilder builder = scene_builder("dolls");
  SceneDraws draws;
  add_ground(builder);
  // Twenty steps, 0.4 m high and 1.2 m deep, up along x.
  for (int k = 0; k < 20; ++k)
    add_fixed(fmt::format("step{}", k), Box{Vec3(0.6, 0.2 * (k + 1), 20)},
              Vec3(1.2 * (k - 9.5), 0.2 * (k + 1), 0), Quat::Identity(), builder);
  for (int k = 0; k < 400; ++k) {
    const int i = k % 10, j = k / 10 % 10, layer = k / 100;
    const double x = 2.2 * (i - 4.5), z = 3.2 * (j - 4.5);
    const double under = 0.4 * (x / 1.2 + 10);
    add_doll(k, Vec3(x, under + 2.5 + 2.4 * layer, z), draw_rotation(draws), builder);
  }
  return builder.build();
}

}  // namespace rigor::bench
