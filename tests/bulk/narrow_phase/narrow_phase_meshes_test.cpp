#include "bulk/face_preference.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
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

/// Sphere, box, capsule, a hull of 32 points, cylinder, cone, and ellipsoid.
Shape shape_of_kind(Draw& draw, int kind) {
  constexpr int kinds[] = {0, 1, 2, 7, 3, 4, 5};
  return draw.shape(kinds[kind]);
}
constexpr int kKinds = 7;

/// By how much faces of hulls and caps of solids of revolution may part the body from the ground worse than
/// something else does.
double preference_of(const Shape& shape, double distance) {
  // The ball inside is no larger than this one inside a box.
  double inner = 0;
  if (const Cylinder* const cylinder = std::get_if<Cylinder>(&shape))
    inner = std::min(cylinder->radius, cylinder->half_length);
  if (const Cone* const cone = std::get_if<Cone>(&shape)) inner = std::min(cone->radius, cone->half_length);
  const Shape known = inner > 0 ? Shape(Box{Vec3::Constant(inner)}) : shape;
  return test::face_preference(Box{Vec3(9, 9, 9)}, known, distance);
}

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

/// Points are where they say they are: gap apart along the normal, on the surface of either shape. The least
/// gap is the distance, or where a face is preferred to an edge, more by no more than the preference; nothing
/// is deeper than the deepest overlap. Balls have exactly the contacts of contact_set.
void expect_true_contacts(Ground& scene, const Pose& X_WB, float margin, const std::string& where) {
  const std::vector<Manifold> found = scene.manifolds(X_WB, margin);
  const double distance = signed_distance(scene.ground, Pose{}, scene.other, X_WB).distance;
  const double preference = preference_of(scene.other, distance);
  const bool has_caps =
      std::holds_alternative<Cylinder>(scene.other) || std::holds_alternative<Cone>(scene.other);
  double least = INFINITY;
  for (const Manifold& manifold : found) {
    EXPECT_LE(manifold.point_count, Manifold::max_points) << where;
    const Vec3 n = scene.normal(manifold);
    for (int k = 0; k < manifold.point_count; ++k) {
      const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
      const double gap = point.gap;
      // The manifold's points are relative to body A.
      const Vec3 middle =
          Vec3(point.p[0], point.p[1], point.p[2]) + (scene.is_first ? Vec3(Vec3::Zero()) : X_WB.p);
      const double above_ground = point_distance(scene.ground, Pose{}, middle - 0.5 * gap * n).distance;
      // (A ball stands for the point, since it has a distance from all shapes.)
      const Pose X_WP{Mat3::Identity(), middle + 0.5 * gap * n};
      const double above_other = signed_distance(scene.other, X_WB, Sphere{1e-9}, X_WP).distance;
      // Corners count that are beyond the border of a triangle by four roundings.
      EXPECT_NEAR(above_ground, 0, 4 * kRounding) << where;
      // A point of a capsule is at an end of its axis, and may be inside beside it. The circle about a cap
      // crosses edges where it does as seen along their normal, to a thousandth of its radius.
      const double seen = has_caps ? 1e-3 * 0.7 : 0;
      EXPECT_LE(above_other, 2 * kRounding + seen) << where;
      if (!std::holds_alternative<Capsule>(scene.other)) {
        EXPECT_GE(above_other, -2 * kRounding - seen) << where;
      }
      least = std::min(least, gap);
    }
  }
  if (distance < margin - preference - kRounding) {
    EXPECT_GE(least, distance - preference - kRounding) << where;
    EXPECT_LE(least, distance + preference + kRounding) << where;
  }
  if (!std::holds_alternative<Sphere>(scene.other)) return;
  for (const ContactPoint& contact : contact_set(scene.ground, Pose{}, scene.other, X_WB, margin)) {
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Manifold& manifold) {
      return (scene.normal(manifold) - contact.n_W).norm() < 2e-3 &&
             std::abs(least_gap(manifold) - contact.gap) < kRounding;
    })) << where;
  }
}

TEST(NarrowPhaseMeshes, HillsAreTouchedWhereTheyAre) {
  Draw draw(2);
  int touching = 0, several = 0;
  // Gentle and steep hills.
  std::vector<Shape> grounds;
  for (const double steepness : {0.02, 0.1, 0.3, 0.5})
    grounds.push_back(
        field([&](double x, double y) { return steepness * std::sin(1.7 * x) * std::cos(1.3 * y); }));
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int k = 0; k < 60; ++k) {
      const Shape& ground = grounds[static_cast<std::size_t>(k) % grounds.size()];
      Ground scene(ground, shape_of_kind(draw, kind), k % 2 == 0);
      Pose X_WB = draw.pose(2.5);
      X_WB.p.z() += 1;
      const double gap = draw.uniform(-0.005, 0.012);
      for (int step = 0; step < 20; ++step)
        X_WB.p.z() += gap - signed_distance(ground, Pose{}, scene.other, X_WB).distance;
      expect_true_contacts(scene, X_WB, 0.01f, std::to_string(kind) + " no " + std::to_string(k));
      const std::size_t count = scene.manifolds(X_WB, 0.01f).size();
      touching += count > 0;
      several += count > 1;
    }
  }
  // Valleys hold bodies at more than one slope.
  EXPECT_GT(touching, 150);
  EXPECT_GT(several, 20);
}

/// A solid of many triangles with corners and edges that bend both ways: a cross of two beams.
Shape beam_cross() {
  const double a = 0.3, b = 1.2, c = 0.25;
  const std::vector<Vec2> outline = {{a, a},   {b, a},   {b, -a}, {a, -a}, {a, -b}, {-a, -b},
                                     {-a, -a}, {-b, -a}, {-b, a}, {-a, a}, {-a, b}, {a, b}};
  const int n = static_cast<int>(outline.size());
  PolygonMesh solid;
  for (const double z : {-c, c})
    for (const Vec2& p : outline) solid.vertices.push_back(Vec3(p.x(), p.y(), z));
  std::vector<int> top, bottom;
  // The outline runs clockwise.
  for (int k = 0; k < n; ++k) {
    bottom.push_back(k);
    top.push_back(n + n - 1 - k);
    solid.faces.push_back({n + k, n + (k + 1) % n, (k + 1) % n, k});
  }
  solid.faces.push_back(bottom);
  solid.faces.push_back(top);
  return make_mesh(std::make_shared<const TriangleMesh>(triangulated(solid)));
}

/// Bodies about a solid with sharp edges, that bend outwards and inwards, and corners.
TEST(NarrowPhaseMeshes, EdgesAndCornersAreTouchedWhereTheyAre) {
  Draw draw(77);
  const Shape ground = beam_cross();
  int touching = 0;
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int k = 0; k < 1500; ++k) {
      Ground scene(ground, shape_of_kind(draw, kind), k % 2 == 0);
      Pose X_WB{draw.rotation(), 2.5 * draw.direction()};
      const Vec3 inwards = -X_WB.p.normalized();
      const double gap = draw.uniform(-0.005, 0.012);
      for (int step = 0; step < 30; ++step) {
        const double distance = signed_distance(ground, Pose{}, scene.other, X_WB).distance;
        X_WB.p += 0.9 * (distance - gap) * inwards;
      }
      expect_true_contacts(scene, X_WB, 0.01f, std::to_string(kind) + " no " + std::to_string(k));
      touching += scene.manifolds(X_WB, 0.01f).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(touching, 8000);
}

/// A solid that flies at a plate far wider than itself looks ahead by more than its size. The planes of the
/// faces behind it cut the plate, far under them: none of that is an overlap.
TEST(NarrowPhaseMeshes, FacesFarFromAWidePlateDoNotOverlapIt) {
  Draw draw(78);
  const Shape solid = beam_cross();
  int ahead = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 half(draw.uniform(5, 20), draw.uniform(5, 20), 0.01);
    Ground scene(solid, Box{half}, k % 2 == 0);
    // The cross stays where it is, and the plate is moved to it along its own normal.
    Pose X_WB{draw.rotation(), Vec3::Zero()};
    X_WB.p = X_WB.R * Vec3(draw.uniform(-3, 3), draw.uniform(-3, 3), -3);
    const double gap = k % 4 == 0 ? draw.uniform(-0.002, 0) : draw.uniform(0, 1.2);
    const double distance = signed_distance(solid, Pose{}, scene.other, X_WB).distance;
    X_WB.p += (distance - gap) * X_WB.R.col(2);
    double least = INFINITY;
    for (const Manifold& manifold : scene.manifolds(X_WB, 1.5f)) least = std::min(least, least_gap(manifold));
    // Positions in 32 bits, as far as the plate goes from the cross.
    const double rounding = 2 * static_cast<double>(kCollisionRounding) * (2 * half.norm() + X_WB.p.norm());
    const double preference = test::face_preference(Box{Vec3(9, 9, 9)}, scene.other, gap);
    EXPECT_NEAR(least, gap, preference + rounding) << k;
    ahead += gap > 0 ? 1 : 0;
  }
  EXPECT_GT(ahead, 700);
}

/// A thin plate beside a solid with inner corners, or a little in it, at any angle. Its big faces cross the
/// planes of facets that it does not touch, deep below them, also where it lies over them: none of that is an
/// overlap. (A plate that is in it by more than half its thickness is another matter.)
TEST(NarrowPhaseMeshes, AThinPlateOverlapsAConcaveSolidByNoMoreThanItDoes) {
  Draw draw(79);
  const Shape solid = beam_cross();
  int apart = 0, overlapping = 0;
  for (int k = 0; k < 1600; ++k) {
    const double half_thickness = draw.uniform(0.02, 0.1);
    const Vec3 half(draw.uniform(5, 40), draw.uniform(1, 4), half_thickness);
    Ground scene(solid, Box{half}, k % 2 == 0);
    Pose X_WB{draw.rotation(), Vec3::Zero()};
    X_WB.p = X_WB.R * Vec3(draw.uniform(-0.9, 0.9) * half.x(), draw.uniform(-0.9, 0.9) * half.y(), -4);
    const double gap = k % 2 == 0 ? draw.uniform(0, 0.8) : draw.uniform(-0.9 * half_thickness, 0);
    for (int step = 0; step < 15; ++step)
      X_WB.p += (signed_distance(solid, Pose{}, scene.other, X_WB).distance - gap) * X_WB.R.col(2);
    const float margin = k % 4 < 2 ? 0.05f : 1.5f;
    double least = INFINITY;
    for (const Manifold& manifold : scene.manifolds(X_WB, margin))
      least = std::min(least, least_gap(manifold));
    const double rounding = 2 * static_cast<double>(kCollisionRounding) * (2 * half.norm() + X_WB.p.norm());
    const double slack = test::face_preference(Box{Vec3(9, 9, 9)}, scene.other, gap) + rounding;
    EXPECT_GE(least, gap - slack) << k;
    if (gap < static_cast<double>(margin) - slack) {
      EXPECT_LE(least, gap + slack) << k;
    }
    ++(gap > 0 ? apart : overlapping);
  }
  EXPECT_GT(std::min(apart, overlapping), 780);
}

/// What is inside a closed mesh, touching none of its triangles, is shown the way out.
TEST(NarrowPhaseMeshes, WhatIsInsideIsShownTheWayOut) {
  const Shape ground = field([](double, double) { return 0.0; });
  Ground scene(ground, Sphere{0.1}, true);
  const std::vector<Manifold> found = scene.manifolds({Mat3::Identity(), Vec3(0.1, 0.2, -0.3)}, 0.01f);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(scene.normal(found[0]).z(), 1, 1e-6);
  EXPECT_NEAR(least_gap(found[0]), -0.4, kRounding);
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
