#include "geometry/random_pairs.hpp"
#include "geometry/solid_shapes.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

/// Contact sets on surfaces with valleys hold the place that lies deepest.
namespace rigor::contact_deepest_test {
namespace {

using test::Draw;

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].

/// A ground of square cells 0.3 to 0.6 m wide, up to 0.35 m high.
Mesh rough_ground(Draw& draw) {
  const int cells = static_cast<int>(draw.uniform(5, 9));
  HeightField field{{}, Vec2::Constant(3), 1};
  for (int i = 0; i <= cells; ++i) {
    std::vector<double>& row = field.rows.emplace_back();
    for (int k = 0; k <= cells; ++k) row.push_back(draw.uniform(0, 0.35));
  }
  return test::as_mesh(make_height_field_mesh(field));
}

/// Shapes that reach into valleys.
Shape small_shape(Draw& draw, int kind) {
  const double radius = draw.uniform(0.02, 0.08), length = draw.uniform(0.15, 0.5);
  switch (kind) {
    case 0:
      return Cone{radius, length};
    case 1:
      return Box{Vec3(radius, draw.uniform(0.02, 0.08), 0.5 * length)};
    case 2:
      return Cylinder{radius, length};
    case 3:
      return Box{0.1 * draw.sizes() + Vec3::Constant(0.06)};
    default:
      return Ellipsoid{Vec3(radius, draw.uniform(0.02, 0.08), 0.5 * length)};
  }
}

/// Minus the depth of the triangle that the shape enters deepest, each as a body of its own: no shorter
/// translation parts the two [m].
double deepest_triangle(const Mesh& mesh, const Shape& shape, const Pose& X) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.mesh->triangles) {
    std::vector<Vec3> corners;
    for (const int v : triangle) corners.push_back(mesh.mesh->vertices[at(v)]);
    least = std::min(least, convex_distance(make_points_core(corners), Pose{}, make_core(shape), X).distance);
  }
  return least;
}

double deepest_gap(const std::vector<ContactPoint>& contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : contacts) least = std::min(least, contact.gap);
  return least;
}

/// The shape moved along n until it touches the mesh.
Pose touching(const Mesh& mesh, const Shape& shape, Pose X, const Vec3& n) {
  double apart = 2, inside = 0;
  const Vec3 p = X.p;
  while (apart - inside > 1e-9) {
    const double middle = 0.5 * (apart + inside);
    X.p = p + middle * n;
    (deepest_triangle(mesh, shape, X) > 0 ? apart : inside) = middle;
  }
  return X;
}

TEST(DeepestContact, IsInTheSetOfAShapeThatFallsOverOnRoughGround) {
  Draw draw(5);
  int overlapping = 0;
  for (int k = 0; k < 60; ++k) {
    const Mesh ground = rough_ground(draw);
    const Shape shape = small_shape(draw, k % 5);
    const Vec3 start(draw.uniform(-1.4, 1.4), draw.uniform(-1.4, 1.4), -0.2);
    const Pose X = touching(ground, shape, {draw.rotation(), start}, Vec3::UnitZ());
    const DistanceResult first = signed_distance(ground, Pose{}, shape, X);
    if (first.distance < -kTolerance) continue;  // It was put inside.
    // It rotates about the point of contact, until it overlaps elsewhere.
    for (int i = 0; i < 10; ++i) {
      const double angle = std::pow(10.0, draw.uniform(-3, -1));
      const Mat3 R = rotation_matrix(rotation_exp(angle * draw.direction()));
      const Pose X_later{R * X.R, first.p_WA + R * (X.p - first.p_WA)};
      const double distance = deepest_triangle(ground, shape, X_later);
      if (distance > 0) continue;
      ++overlapping;
      // No point has moved farther than this, so that none is deeper.
      const double reach = radius_about(shape, X.R.transpose() * (first.p_WA - X.p));
      // Steps ask for all contacts within their reach.
      for (const double tolerance : {kTolerance, 1e-4, 1e-2}) {
        const double deepest = deepest_gap(contact_set(ground, Pose{}, shape, X_later, tolerance));
        EXPECT_LE(deepest, distance + kTolerance)
            << "ground " << k << ", rotation " << i << ", tolerance " << tolerance;
        EXPECT_GE(deepest, -angle * reach - kTolerance)
            << "ground " << k << ", rotation " << i << ", tolerance " << tolerance;
      }
    }
  }
  EXPECT_GT(overlapping, 200);
}

TEST(DeepestContact, OfAShapeThatBarelyTouchesRoughGroundIsNotDeep) {
  Draw draw(11);
  for (int k = 0; k < 100; ++k) {
    const Mesh ground = rough_ground(draw);
    for (int i = 0; i < 3; ++i) {
      const Shape shape = small_shape(draw, 3);
      const Vec3 start(draw.uniform(-1.4, 1.4), draw.uniform(-1.4, 1.4), 0);
      Pose X = touching(ground, shape, {draw.rotation(), start}, Vec3::UnitZ());
      if (signed_distance(ground, Pose{}, shape, X).distance < -kTolerance) continue;  // It was put inside.
      // It goes down by a little, so that nothing is deeper than that.
      const double depth = draw.uniform(0.3, 3) * kTolerance;
      X.p.z() -= depth;
      const std::vector<ContactPoint> contacts = contact_set(ground, Pose{}, shape, X, kTolerance);
      EXPECT_FALSE(contacts.empty()) << "ground " << k;
      EXPECT_GE(deepest_gap(contacts), -1.01 * depth) << "ground " << k;
    }
  }
}

TEST(DeepestContact, OfABoxOnARidgeIsNotBelowTheNextValley) {
  // Three corners of the box are below the plane of a face beyond the valley, but not in the ground.
  const HeightField field{.rows = {{0.1959, 0.3202, 0.0408, 0.0110, 0.0154, 0.0632, 0.0227, 0.1322},
                                   {0.2267, 0.4526, 0.4481, 0.3962, 0.1773, 0.3900, 0.2270, 0.2936},
                                   {0.4317, 0.3892, 0.4170, 0.5303, 0.4538, 0.5108, 0.4875, 0.5872},
                                   {0.6463, 0.5179, 0.6953, 0.5016, 0.5772, 0.4565, 0.5531, 0.4268}},
                          .size = {3, 9.0 / 7},
                          .base_depth = 0.3};
  const Mesh ground = test::as_mesh(make_height_field_mesh(field));
  const Eigen::Quaterniond q(0.819621658011769, 0.233930155060139, 0.00713106829653059, 0.522920804841927);
  const Box box{0.5 * Vec3(0.141944251779, 0.326224845245, 0.13999059718)};
  // The four rows are the first of eight over 3 m.
  const Pose X{q.toRotationMatrix(),
               Vec3(-0.084155168768886, -1.07825646540648 + 1.5 - 4.5 / 7, 0.434461275674548)};
  const std::vector<ContactPoint> contacts = contact_set(ground, Pose{}, box, X, kTolerance);
  ASSERT_FALSE(contacts.empty());
  EXPECT_GE(deepest_gap(contacts), -kTolerance);
}

TEST(DeepestContact, OfARimOnARidgeIsThereWithinAnyReach) {
  // A rim of the cylinder overlaps a ridge by 2 mm; another one touches a face half a metre away.
  const HeightField field{.rows = {{0.2111, 0.1780, 0.1330, 0.0428, 0.2505, 0.1240, 0.2920},
                                   {0.2036, 0.4114, 0.2673, 0.2339, 0.2232, 0.4432, 0.1369},
                                   {0.5571, 0.2554, 0.3177, 0.5055, 0.5018, 0.4159, 0.3995},
                                   {0.3995, 0.4911, 0.4198, 0.6825, 0.3716, 0.4339, 0.5810},
                                   {0.7338, 0.5617, 0.6979, 0.7231, 0.5733, 0.4847, 0.7907},
                                   {0.9495, 0.6416, 0.7534, 0.8184, 0.7020, 0.8872, 0.8722},
                                   {0.9946, 0.8671, 0.7719, 0.8269, 0.9152, 0.8148, 0.9236}},
                          .size = {3, 3},
                          .base_depth = 0.3};
  const Mesh ground = test::as_mesh(make_height_field_mesh(field));
  const Cylinder cylinder{0.165171894, 0.5 * 0.140272247};
  const Eigen::Quaterniond q(0.8168901434073067, 0.0930057962752037, 0.0787824663983318, -0.5637674506845893);
  const Pose X{q.toRotationMatrix(), Vec3(0.88366224608139654, 0.20715177772514384, 0.56006477164597179)};
  const double distance = deepest_triangle(ground, cylinder, X);
  EXPECT_LT(distance, -1e-4);
  for (const double tolerance : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
    EXPECT_LE(deepest_gap(contact_set(ground, Pose{}, cylinder, X, tolerance)), distance + 1e-9) << tolerance;
}

TEST(DeepestContact, OfAFaceAlmostAlongARidgeHasTheNormalOfTheFace) {
  // Ridges along y. The face of the shape is tilted against one by less than a micrometre over its width, so
  // that its normal is a little outside the cone of the ridge's.
  const std::vector<double> heights = {0, 0.3, 0.05, 0.3, 0};
  const HeightField field{.rows = {heights, heights}, .size = {3, 3}, .base_depth = 0.3};
  const Mesh ground = test::as_mesh(make_height_field_mesh(field));
  Draw draw(23);
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(k);
    const double radius = draw.uniform(0.05, 0.2), half_length = draw.uniform(0.03, 0.2);
    const Shape shape = k % 2 == 0 ? Shape(Cylinder{radius, half_length})
                                   : Shape(Box{Vec3(radius, draw.uniform(0.05, 0.2), half_length)});
    const double depth = draw.uniform(0.1, 1) * kTolerance;
    const double tilt = draw.uniform(-1, 1) * kTolerance / radius;
    const Mat3 R = rotation_matrix(rotation_exp(tilt * Vec3::UnitX())) *
                   rotation_matrix(rotation_exp(draw.uniform(-0.25, 0.25) * Vec3::UnitY())) *
                   rotation_matrix(rotation_exp(draw.uniform(0, 3) * Vec3::UnitZ()));
    const Vec3 n = R.col(2), on_ridge(-0.75, draw.uniform(-1, 1), 0.3);
    const Vec3 aside = draw.uniform(-0.03, 0.03) * Vec3::UnitY().cross(n);
    const Pose X{R, on_ridge + aside + (half_length - depth) * n};

    const std::vector<ContactPoint> contacts = contact_set(ground, Pose{}, shape, X, kTolerance);
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(deepest_gap(contacts), deepest_triangle(ground, shape, X), 1e-9);
    for (const ContactPoint& contact : contacts) EXPECT_LT((contact.n_W - n).norm(), 1e-4);
  }
}

/// A valley along y between two slopes, its bottom the y axis; the slopes are the angles of its sides.
Mesh valley(double left, double right) {
  return test::as_mesh(
      moved(make_prism({{-1, -2}, {1, -2}, {1, std::tan(right)}, {0, 0}, {-1, std::tan(left)}}, 2),
            {rotation_matrix(rotation_exp(0.5 * std::numbers::pi * Vec3::UnitX())), Vec3(0, 1, 0)}));
}

/// A pyramid with its tip at the origin, upwards.
Shape pyramid(double radius, double height) {
  std::vector<Vec3> points = {Vec3::Zero()};
  for (const double x : {-radius, radius}) {
    for (const double y : {-radius, radius}) points.emplace_back(x, y, height);
  }
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

TEST(DeepestContact, OfATipInAValleyAreThoseOfBothSlopes) {
  Draw draw(7);
  for (int k = 0; k < 400; ++k) {
    const double left = draw.uniform(0.2, 1.1), right = draw.uniform(0.2, 1.1);
    const Mesh ground = valley(left, right);
    const double height = draw.uniform(0.1, 0.5), radius = height * draw.uniform(0.05, 0.3);
    const bool is_cone = k % 2 == 0;
    const Shape shape = is_cone ? Shape(Cone{radius, 0.5 * height}) : pyramid(radius, height);
    const Mat3 upright =
        is_cone ? rotation_matrix(rotation_exp(std::numbers::pi * Vec3::UnitX())) : Mat3::Identity();
    const double depth = std::pow(10.0, draw.uniform(-5, -2.5));
    const Vec3 tip = Vec3(draw.uniform(-1, 1) * depth, draw.uniform(-0.5, 0.5), -depth);
    const Pose X{upright, tip + (is_cone ? 0.5 * height : 0) * Vec3::UnitZ()};
    const std::vector<ContactPoint> contacts = contact_set(ground, Pose{}, shape, X, kTolerance);
    // The tip is the lowest point along both normals, and below the slope on whose side it is.
    const Vec3 n_left(std::sin(left), 0, std::cos(left)), n_right(-std::sin(right), 0, std::cos(right));
    bool is_held = false;
    for (const ContactPoint& contact : contacts) {
      const Vec3& n = contact.n_W.x() > 0 ? n_left : n_right;
      EXPECT_LT((contact.n_W - n).norm(), 1e-9) << "valley " << k;
      EXPECT_NEAR(contact.gap, n.dot(tip), 1e-12) << "valley " << k;
      is_held = is_held || (contact.n_W.x() > 0) == (tip.x() < 0);
    }
    const double gap = (tip.x() < 0 ? n_left : n_right).dot(tip);
    EXPECT_TRUE(is_held || gap > kTolerance)
        << "valley " << k << ", " << contacts.size() << " contacts, gap " << gap;
  }
}

}  // namespace
}  // namespace rigor::contact_deepest_test
