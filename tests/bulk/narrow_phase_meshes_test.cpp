#include "geometry/random_pairs.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rigor::narrow_phase_meshes_test {
namespace {

using test::Draw;

/// Positions of about 4 m in 32 bits, a few operations each.
constexpr double kRounding = 4e-6;

/// A ground and a body on it; either of them is the first.
struct Ground {
  Shape ground, other;
  bool is_first = true;
  std::shared_ptr<const Model> model;
  BulkBodies bodies;

  Ground(const Shape& ground_shape, const Shape& other_shape, bool ground_is_first)
      : ground(ground_shape), other(other_shape), is_first(ground_is_first) {
    ModelBuilder builder;
    for (const bool is_ground : {is_first, !is_first}) {
      BodyDescription body;
      body.name = is_ground ? "ground" : "other";
      body.motion = is_ground ? MotionType::fixed : MotionType::kinematic;
      body.shapes.push_back({is_ground ? ground : other});
      builder.add_body(body);
    }
    model = builder.build();
    bodies.x.assign(2, Vec3::Zero());
    bodies.q.assign(2, Quat::Identity());
    bodies.motion.resize(2);
    bodies.inertia.resize(2);
  }
  std::vector<Manifold> manifolds(const Pose& X_WB, float margin) {
    const std::size_t k = is_first ? 1 : 0;
    bodies.x[k] = X_WB.p;
    bodies.q[k] = Quat(X_WB.R);
    NarrowPhase narrow_phase(*model);
    ManifoldList found;
    narrow_phase.find_manifolds(bodies, {{0, 1, 0, 0, margin}}, Executor(1), found);
    std::vector<Manifold> manifolds;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].part, static_cast<int>(i));
      manifolds.push_back(found[i].manifold);
    }
    return manifolds;
  }
  /// From the ground to the body.
  Vec3 normal(const Manifold& manifold) const {
    return (is_first ? 1 : -1) * Vec3(manifold.normal[0], manifold.normal[1], manifold.normal[2]);
  }
};

double least_gap(const Manifold& manifold) {
  float least = INFINITY;
  for (int k = 0; k < manifold.point_count; ++k)
    least = std::min(least, manifold.points[static_cast<std::size_t>(k)].gap);
  return least;
}

/// Sphere, box, capsule, cylinder, and a hull of 32 points.
Shape shape_of_kind(Draw& draw, int kind) {
  constexpr int kinds[] = {0, 1, 2, 3, 7};
  return draw.shape(kinds[kind]);
}
constexpr int kKinds = 5, kCylinder = 3;

/// A field of cells of 0.5 m; `height` at x and y.
template <typename Height>
Shape field(const Height& height) {
  HeightField field{{}, Vec2(8, 8), 1};
  for (int row = 0; row <= 16; ++row) {
    field.rows.emplace_back();
    for (int column = 0; column <= 16; ++column)
      field.rows.back().push_back(height(-4 + 0.5 * column, -4 + 0.5 * row));
  }
  return make_mesh(std::make_shared<const TriangleMesh>(make_height_field_mesh(field)));
}

/// Lowest point of a shape along z [m].
double bottom(const Shape& shape, const Pose& X_WB) {
  return (X_WB * support_point(shape, X_WB.R.transpose() * -Vec3::UnitZ())).z();
}

/// Wherever a body is on a flat ground of triangles, over an inner edge or a vertex of it too, the ground is
/// a plane: one manifold, its normal upright, as deep as the body's lowest point.
TEST(NarrowPhaseMeshes, InnerEdgesOfAFlatGroundAreNotFelt) {
  Draw draw(1);
  const Shape ground = field([](double, double) { return 0.0; });
  for (int kind = 0; kind < kKinds; ++kind) {
    if (kind == kCylinder) continue;  // Its caps add contacts of their own normal where they nearly lie.
    for (int k = 0; k < 60; ++k) {
      Ground scene(ground, shape_of_kind(draw, kind), k % 2 == 0);
      Pose X_WB = draw.pose(2.5);
      if (k % 3 == 1) X_WB.p = Vec3(0.5 * std::round(2 * X_WB.p.x()), X_WB.p.y(), 0);
      if (k % 3 == 2) X_WB.p = (0.5 * (2 * X_WB.p).array().round()).matrix();
      const double gap = draw.uniform(-0.001, 0.008);
      X_WB.p.z() += gap - bottom(scene.other, X_WB);
      const std::vector<Manifold> found = scene.manifolds(X_WB, 0.01f);
      ASSERT_EQ(found.size(), 1u) << kind << " no " << k;
      EXPECT_LE((scene.normal(found[0]) - Vec3::UnitZ()).norm(), 1e-6) << kind << " no " << k;
      EXPECT_NEAR(least_gap(found[0]), gap, kRounding) << kind << " no " << k;
    }
  }
}

/// A box that slides over a flat ground stands on its four corners everywhere.
TEST(NarrowPhaseMeshes, ABoxStandsOnItsCornersWhereverItSlides) {
  const Shape ground = field([](double, double) { return 0.0; });
  Ground scene(ground, Box{Vec3(0.5, 0.3, 0.2)}, true);
  for (int k = 0; k <= 100; ++k) {
    const Vec3 p(-1.3 + 0.027 * k, 0.4 - 0.011 * k, 0.199);
    const Quat q = rotation_exp(0.02 * k * Vec3::UnitZ());
    const std::vector<Manifold> found = scene.manifolds({q.toRotationMatrix(), p}, 0.01f);
    ASSERT_EQ(found.size(), 1u) << k;
    ASSERT_EQ(found[0].point_count, 4) << k;
    for (const ManifoldPoint& point : found[0].points) {
      EXPECT_NEAR(point.gap, -0.001, kRounding) << k;
      const Vec3 local = q.conjugate() * (Vec3(point.p[0], point.p[1], point.p[2]) - p);
      EXPECT_NEAR(std::abs(local.x()), 0.5, kRounding) << k;
      EXPECT_NEAR(std::abs(local.y()), 0.3, kRounding) << k;
    }
  }
}

/// Each contact of contact_set is in a manifold of its normal that is at least as deep, and each manifold is
/// of such contacts.
void expect_contact_set(Ground& scene, const Pose& X_WB, float margin, const std::string& where) {
  const std::vector<Manifold> found = scene.manifolds(X_WB, margin);
  const Pose ground_pose;
  const std::vector<ContactPoint> contacts =
      scene.is_first ? contact_set(scene.ground, ground_pose, scene.other, X_WB, margin)
                     : contact_set(scene.other, X_WB, scene.ground, ground_pose, margin);
  const auto normal_of = [](const Manifold& m) { return Vec3(m.normal[0], m.normal[1], m.normal[2]); };
  constexpr double angle = 2e-3;  // Contacts of normals within a milliradian are one manifold.
  std::vector<double> deepest(found.size(), INFINITY);
  for (const ContactPoint& contact : contacts) {
    bool is_there = false;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if ((normal_of(found[k]) - contact.n_W).norm() > angle) continue;
      is_there = is_there || least_gap(found[k]) <= contact.gap + kRounding;
      deepest[k] = std::min(deepest[k], contact.gap);
    }
    EXPECT_TRUE(is_there) << where;
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(least_gap(found[k]), deepest[k], kRounding) << where << " manifold " << k;
    EXPECT_LE(found[k].point_count, Manifold::max_points) << where;
  }
}

TEST(NarrowPhaseMeshes, HillsHaveTheContactsOfContactSet) {
  Draw draw(2);
  const auto height = [](double x, double y) { return 0.3 * std::sin(1.7 * x) * std::cos(1.3 * y); };
  const Shape ground = field(height);
  int touching = 0, several = 0;
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int k = 0; k < 60; ++k) {
      Ground scene(ground, shape_of_kind(draw, kind), k % 2 == 0);
      Pose X_WB = draw.pose(2.5);
      X_WB.p.z() += 1;
      const double gap = draw.uniform(-0.005, 0.012);
      for (int step = 0; step < 20; ++step)
        X_WB.p.z() += gap - signed_distance(ground, Pose{}, scene.other, X_WB).distance;
      expect_contact_set(scene, X_WB, 0.01f, std::to_string(kind) + " no " + std::to_string(k));
      const std::size_t count = scene.manifolds(X_WB, 0.01f).size();
      touching += count > 0;
      several += count > 1;
    }
  }
  // Valleys hold bodies at more than one slope.
  EXPECT_GT(touching, 150);
  EXPECT_GT(several, 20);
}

/// In a valley of two slopes a ball touches both, and nothing but them.
TEST(NarrowPhaseMeshes, ABallInAValleyTouchesItsTwoSlopes) {
  const Shape ground = field([](double x, double) { return std::abs(x); });
  Ground scene(ground, Sphere{0.3}, true);
  Draw draw(3);
  for (int k = 0; k < 50; ++k) {
    // The slopes of 45 degrees are at the distance z / √2 from the ball's centre.
    const double gap = draw.uniform(-0.01, 0.004);
    const Vec3 p(0, draw.uniform(-2, 2), (0.3 + gap) * std::numbers::sqrt2);
    std::vector<Manifold> found = scene.manifolds({Mat3::Identity(), p}, 0.01f);
    ASSERT_EQ(found.size(), 2u) << k;
    for (const Manifold& manifold : found) {
      const Vec3 n = scene.normal(manifold);
      EXPECT_NEAR(std::abs(n.x()), 1 / std::numbers::sqrt2, 1e-6);
      EXPECT_NEAR(n.z(), 1 / std::numbers::sqrt2, 1e-6);
      EXPECT_EQ(manifold.point_count, 1);
      EXPECT_NEAR(manifold.points[0].gap, gap, kRounding);
    }
    EXPECT_LT(scene.normal(found[0]).x() * scene.normal(found[1]).x(), 0);
  }
}

}  // namespace
}  // namespace rigor::narrow_phase_meshes_test
