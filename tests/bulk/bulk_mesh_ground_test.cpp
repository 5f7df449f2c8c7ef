// Bodies on grounds of triangles, on the many-body path.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rigor::bulk_mesh_ground_test {
namespace {

/// A sheet of 2 n² triangles over a square of 8 m, at the height of each place.
Shape sheet(int n, const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) {
      const double x = 8.0 * i / n - 4, y = 8.0 * k / n - 4;
      mesh.vertices.push_back(Vec3(x, y, height(x, y)));
    }
  }
  const auto number = [n](int i, int k) { return i * (n + 1) + k; };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i, k + 1)});
      mesh.triangles.push_back({number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)});
    }
  }
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}

BodyDescription body_of(const std::string& name, const Shape& shape, const Vec3& p, MotionType motion) {
  BodyDescription body;
  body.name = name;
  body.motion = motion;
  body.p_WU = p;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

struct Scene {
  std::shared_ptr<const Model> model;
  std::unique_ptr<BulkWorld> world;

  explicit Scene(const std::vector<BodyDescription>& bodies) {
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    builder.add_material({"m", 1000, 0.2, 0});
    for (const BodyDescription& body : bodies) builder.add_body(body);
    model = builder.build();
    world = std::make_unique<BulkWorld>(model, BulkSettings{});
    world->read(make_initial_state(*model));
  }
  void step(int count) {
    for (int k = 0; k < count; ++k) world->step(1.0 / 60);
  }
  const Vec3& x(std::size_t i) const { return world->bodies().x[i]; }
  const Quat& q(std::size_t i) const { return world->bodies().q[i]; }
};

/// What slides and rolls over a flat sheet of 800 triangles does so as over a plane, whether it moves or not:
/// its inner edges are not felt.
void expect_a_plane(const Vec3& velocity) {
  const auto ground_of = [&](const Shape& shape) {
    const MotionType motion = velocity.isZero(0) ? MotionType::fixed : MotionType::kinematic;
    BodyDescription ground = body_of("ground", shape, Vec3::Zero(), motion);
    ground.velocity = velocity;
    return ground;
  };
  // Where each stands on the ground: the capsule and the first cylinder lie along y and roll, the second
  // stands, the cone lies on its side, and the ellipsoid rocks.
  const Quat along_y(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
  const Cone cone{0.2, 0.3};
  const double apex = std::atan2(cone.radius, 2 * cone.half_length);
  const Quat on_side(Eigen::AngleAxisd(M_PI / 2 + apex, Vec3::UnitX()));
  // From the middle of the axis to the line on the side.
  const double over_side = cone.half_length * std::sin(apex);
  const Quat askew(Eigen::AngleAxisd(0.5, Vec3(1, 2, 0).normalized()));
  const struct {
    Shape shape;
    double height;
    Quat q;
  } sliders[] = {
      {Sphere{0.2}, 0.2, Quat::Identity()},          {Box{Vec3(0.3, 0.2, 0.1)}, 0.1, Quat::Identity()},
      {Capsule{0.15, 0.2}, 0.15, along_y},           {Cylinder{0.2, 0.3}, 0.2, along_y},
      {Cylinder{0.3, 0.1}, 0.1, Quat::Identity()},   {cone, over_side, on_side},
      {Ellipsoid{Vec3(0.3, 0.2, 0.25)}, 0.26, askew}};
  const Shape flat = sheet(20, [](double, double) { return 0.0; });
  for (const auto& [shape, height, q] : sliders) {
    BodyDescription slider = body_of("slider", shape, Vec3(-2, -1, height), MotionType::dynamic);
    slider.q_WU = q;
    slider.velocity = Vec3(2.5, 1.1, 0);
    Scene on_sheet({ground_of(flat), slider});
    Scene on_plane({ground_of(HalfSpace{Vec3::UnitZ(), 0}), slider});
    for (int k = 0; k < 60; ++k) {
      on_sheet.step(1);
      on_plane.step(1);
      // A cone and an ellipsoid turn as they roll, so that the rounding of heights, 5e-7 m in each step,
      // changes where they go.
      const bool turns = std::holds_alternative<Cone>(shape) || std::holds_alternative<Ellipsoid>(shape);
      // What rolls keeps the rounding of its speed, 1.5e-7 m/s in each of 360 substeps, which walk by 1.6e-6
      // m.
      const bool rolls = q.isApprox(along_y);
      const double rounding = turns ? 3e-5 : rolls ? 3e-6 : 1e-6;
      ASSERT_LE((on_sheet.x(1) - on_plane.x(1)).norm(), rounding) << shape_type_name(shape) << " step " << k;
      ASSERT_LE(on_sheet.q(1).angularDistance(on_plane.q(1)), 10 * rounding)
          << shape_type_name(shape) << " step " << k;
    }
    EXPECT_GT((on_plane.x(1) - slider.p_WU).norm(), 1) << shape_type_name(shape);
  }
}
TEST(BulkMeshGround, AFlatSheetIsAPlane) {
  expect_a_plane(Vec3::Zero());
}
TEST(BulkMeshGround, AFlatSheetThatMovesIsAPlane) {
  expect_a_plane(Vec3(0.4, -0.3, 0));
}

/// Bodies in a dish that moves at a constant velocity do what they do in one at rest.
TEST(BulkMeshGround, ADishThatMovesIsADishAtRest) {
  const Shape dish = sheet(24, [](double x, double y) { return 0.1 * (x * x + y * y); });
  const Vec3 v(1.5, -0.5, 0.25);
  std::vector<BodyDescription> bodies = {body_of("dish", dish, Vec3::Zero(), MotionType::kinematic)};
  bodies.push_back(body_of("ball", Sphere{0.2}, Vec3(1.2, 0.3, 0.6), MotionType::dynamic));
  bodies.push_back(body_of("box", Box{Vec3(0.3, 0.2, 0.1)}, Vec3(-1, -0.8, 0.6), MotionType::dynamic));
  Scene at_rest(bodies);
  for (BodyDescription& body : bodies) body.velocity = v;
  Scene moving(bodies);
  for (int k = 1; k <= 60; ++k) {
    at_rest.step(1);
    moving.step(1);
    for (std::size_t i = 1; i < 3; ++i)
      ASSERT_LE((moving.x(i) - (k / 60.0) * v - at_rest.x(i)).norm(), 1e-3) << "body " << i << " step " << k;
  }
}

/// Bodies thrown on hills, one on the other, stay over them.
TEST(BulkMeshGround, NothingFallsThroughHills) {
  const Shape hills = sheet(24, [](double x, double y) {
    return 0.2 * std::sin(2 * x) * std::cos(1.7 * y) + 0.05 * (x * x + y * y);
  });
  std::vector<BodyDescription> bodies = {body_of("hills", hills, Vec3::Zero(), MotionType::fixed)};
  for (int k = 0; k < 72; ++k) {
    const Vec3 p(0.7 * (k % 4) - 1, 0.7 * (k / 4 % 4) - 1, 1.5 + 0.8 * (k / 16));
    const std::array<Shape, 6> shapes = {Sphere{0.2},       Box{Vec3(0.25, 0.15, 0.1)},
                                         Capsule{0.1, 0.2}, Cylinder{0.2, 0.15},
                                         Cone{0.2, 0.2},    Ellipsoid{Vec3(0.25, 0.15, 0.1)}};
    const Shape& shape = shapes[static_cast<std::size_t>(k % 6)];
    BodyDescription body = body_of("body" + std::to_string(k), shape, p, MotionType::dynamic);
    body.velocity = Vec3(0, 0, -10);
    bodies.push_back(body);
  }
  Scene scene(bodies);
  scene.step(60);
  // A fresh world goes on with the same bits.
  State state = make_initial_state(*scene.model);
  scene.world->write(state);
  BulkWorld fresh(scene.model, BulkSettings{.threads = 2});
  fresh.read(state);
  for (int k = 0; k < 60; ++k) {
    scene.step(1);
    fresh.step(1.0 / 60);
  }
  for (std::size_t k = 1; k <= 72; ++k) {
    EXPECT_GT(scene.x(k).z(), -0.3) << "body " << k;
    EXPECT_EQ(scene.x(k), fresh.bodies().x[k]) << "body " << k;
    EXPECT_EQ(scene.q(k).coeffs(), fresh.bodies().q[k].coeffs()) << "body " << k;
  }
}

}  // namespace
}  // namespace rigor::bulk_mesh_ground_test
