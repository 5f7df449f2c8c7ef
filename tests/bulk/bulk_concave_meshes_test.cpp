// Solids that bend inwards, given as meshes, against each other and on the ground, on the many-body path.

#include "random_vectors.hpp"
#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/narrow_phase/collide_exactly.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rigor::bulk_concave_meshes_test {
namespace {

/// A star of so many tips [m].
Shape star(int tips, double radius, double inner_radius, double half_height) {
  TriangleMesh mesh;
  const int n = 2 * tips;
  for (const double z : {-half_height, half_height}) {
    for (int i = 0; i < n; ++i) {
      const double r = i % 2 == 0 ? radius : inner_radius, angle = M_PI * i / tips;
      mesh.vertices.push_back(Vec3(r * std::cos(angle), r * std::sin(angle), z));
    }
  }
  mesh.vertices.push_back(Vec3(0, 0, -half_height));
  mesh.vertices.push_back(Vec3(0, 0, half_height));
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    mesh.triangles.push_back({2 * n, j, i});
    mesh.triangles.push_back({2 * n + 1, n + i, n + j});
  }
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}

Shape random_star(test::Random& random) {
  const double radius = random.uniform(0.03, 0.08);
  const int tips = 4 + static_cast<int>(random.uniform(0, 4));
  return star(tips, radius, random.uniform(0.4, 0.7) * radius, random.uniform(0.2, 0.5) * radius);
}

/// Within a margin as wide as they are, contacts are listed that are nearer than the faces at their backs.
TEST(BulkConcaveMeshes, WhatIsApartOverlapsNowhere) {
  test::Random random(11);
  constexpr double margin = 0.1, tolerance = 1e-4;
  int apart = 0;
  for (int k = 0; k < 300; ++k) {
    const Shape a = random_star(random), b = random_star(random);
    const Pose X_OA{rotation_matrix(rotation_exp(3 * random.vector())), Vec3::Zero()},
        X_OB{rotation_matrix(rotation_exp(3 * random.vector())), 0.1 * random.vector()};
    const double distance = signed_distance(a, X_OA, b, X_OB).distance;
    if (distance <= 1e-3) continue;
    ++apart;
    ManifoldList manifolds;
    add_exact_manifolds(a, X_OA, b, X_OB, static_cast<float>(tolerance), static_cast<float>(margin), 0,
                        manifolds);
    for (std::size_t m = 0; m < manifolds.size(); ++m) {
      const ManifoldView view = manifolds.view(m);
      // A contact lies along its normal between both surfaces, up to the tolerance.
      for (int i = 0; i < view.point_count; ++i)
        EXPECT_GE(static_cast<double>(view.points[i].gap), distance - 2 * tolerance) << "pair " << k;
    }
  }
  EXPECT_GT(apart, 50);
}

/// The share of the thinner one's thickness by which two bodies overlap at most within a second.
double deepest_share(const std::vector<BodyDescription>& bodies, double step) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.4, 0});
  BodyDescription ground;
  ground.name = "ground";
  ground.motion = MotionType::fixed;
  ground.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(ground);
  for (const BodyDescription& body : bodies) builder.add_body(body);
  const std::shared_ptr<const Model> model = builder.build();
  BulkWorld world(model, BulkSettings{});
  world.read(make_initial_state(*model));
  double deepest = 0;
  for (double t = 0; t < 1; t += step) deepest = std::max(deepest, world.step(step).worst_share);
  return deepest;
}

BodyDescription falling(const std::string& name, const Shape& shape, const Vec3& p, test::Random& random) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p;
  body.q_WU = rotation_exp(3 * random.vector()).normalized();
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

/// A quarter is what the audit allows: what tumbles comes down on one tip after the other within a step.
TEST(BulkConcaveMeshes, StarsThatTumbleStandOnAnyOfTheirTips) {
  test::Random random(21);
  for (int k = 0; k < 24; ++k) {
    const Shape shape = random_star(random);
    BodyDescription body = falling("star", shape, Vec3(0, 0, random.uniform(0.2, 0.5)), random);
    body.angular_velocity = 15 * random.vector();
    EXPECT_LE(deepest_share({body}, k % 2 == 0 ? 0.01 : 1.0 / 60), 0.25) << "star " << k;
  }
}

TEST(BulkConcaveMeshes, HeapsOfStarsDoNotGoIntoEachOther) {
  test::Random random(31);
  int deep = 0;
  for (int k = 0; k < 12; ++k) {
    std::vector<BodyDescription> bodies;
    for (int i = 0; i < 5; ++i) {
      const Shape shape = random_star(random);
      const double x = 0.05 * random.number(), y = 0.05 * random.number();
      bodies.push_back(falling("star" + std::to_string(i), shape, Vec3(x, y, 0.2 + 0.2 * i), random));
    }
    deep += deepest_share(bodies, 0.01) > 0.25 ? 1 : 0;
  }
  EXPECT_EQ(deep, 0);
}

}  // namespace
}  // namespace rigor::bulk_concave_meshes_test
