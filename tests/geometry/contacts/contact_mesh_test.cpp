#include "geometry/mesh_shapes.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::contact_mesh_test {
namespace {

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].
constexpr double kRounding = 1e-13;  ///< A few rounding errors of coordinates of a few metres.
constexpr double kPi = std::numbers::pi;

Mesh make(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<TriangleMesh>(mesh));
}

Pose turned(const Vec3& axis, double angle, const Vec3& p) {
  return {rotation_matrix(rotation_exp(angle * axis.normalized())), p};
}

/// Height of a floor with a profile along x; columns `cells` to a side over [-2, 2]², inner vertices pushed
/// about at random so that no two triangles are alike.
template <typename Height>
TriangleMesh floor_mesh(int cells, const Height& height) {
  std::mt19937 engine(17);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  TriangleMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double side = 4.0 / cells;
      const bool x_is_free = i > 0 && i < cells && 2 * i != cells, y_is_free = j > 0 && j < cells;
      const double x = -2 + side * (i + (x_is_free ? shift(engine) : 0));
      const double y = -2 + side * (j + (y_is_free ? shift(engine) : 0));
      mesh.vertices.emplace_back(x, y, height(x));
    }
  }
  add_grid_triangles(cells, mesh);
  return mesh;
}

TriangleMesh flat_floor() {
  return floor_mesh(8, [](double) { return 0.0; });
}

/// The box with each face cut into 2 n² triangles.
TriangleMesh tessellated_box(const Vec3& half_extents, int n) {
  TriangleMesh mesh;
  const auto vertex = [&](const Vec3& p) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (mesh.vertices[v] == p) return static_cast<int>(v);
    }
    mesh.vertices.push_back(p);
    return static_cast<int>(mesh.vertices.size()) - 1;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const auto at = [&](int i, int j) {
        Vec3 p;
        p(axis) = sign;
        p((axis + 1) % 3) = sign * (2 * i - n) / n;
        p((axis + 2) % 3) = (2.0 * j - n) / n;
        return vertex(p.cwiseProduct(half_extents));
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
          mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
      }
    }
  }
  return mesh;
}

/// Are the points of B of the two sets the same?
void expect_same_points(const std::vector<ContactPoint>& found, const std::vector<ContactPoint>& expected,
                        double tolerance, const std::string& name) {
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (const ContactPoint& e : expected) {
    double best = 1;
    for (const ContactPoint& f : found)
      best = std::min(best, (f.p_WA - e.p_WA).norm() + (f.p_WB - e.p_WB).norm());
    EXPECT_LE(best, tolerance) << name;
  }
}

TEST(ContactSetOfMeshes, OfABoxOnATessellatedFloorIsThatOfABoxOnABox) {
  const Mesh floor = make(flat_floor());
  const Box slab{Vec3(2, 2, 0.5)}, box{Vec3(0.4, 0.3, 0.2)};
  for (int step = 0; step < 30; ++step) {
    // Sliding off the edge at x = 2 and turning, standing above, on and in the floor.
    const double gap = (step % 3 - 1) * 4e-7;
    const Pose X_WB = turned(Vec3::UnitZ(), 0.1 * step, Vec3(0.07 * step, 0.04 * step - 0.5, 0.2 + gap));
    const std::vector<ContactPoint> contacts = contact_set(floor, Pose{}, box, X_WB, kTolerance);
    const std::vector<ContactPoint> expected =
        contact_set(slab, {Mat3::Identity(), Vec3(0, 0, -0.5)}, box, X_WB, kTolerance);
    expect_same_points(contacts, expected, kRounding, "step " + std::to_string(step));
    for (const ContactPoint& contact : contacts) {
      EXPECT_EQ(contact.n_W, Vec3::UnitZ());
      EXPECT_NEAR(contact.gap, gap, kRounding);
    }
  }
}

/// A floor over [-1, 1]² with its top at z = 0 and a pillar over [-0.2, 0.2]², 0.8 m high, on it.
TriangleMesh floor_with_pillar() {
  PolygonMesh mesh;
  const std::vector<double> borders{-1, -0.2, 0.2, 1};
  for (const double z : {-0.3, 0.0}) {
    for (const double y : borders) {
      for (const double x : borders) mesh.vertices.emplace_back(x, y, z);
    }
  }
  const auto below = [](int i, int k) { return 4 * k + i; };
  const auto floor = [](int i, int k) { return 16 + 4 * k + i; };
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      mesh.faces.push_back({below(i, k), below(i, k + 1), below(i + 1, k + 1), below(i + 1, k)});
      if (i == 1 && k == 1) continue;
      mesh.faces.push_back({floor(i, k), floor(i + 1, k), floor(i + 1, k + 1), floor(i, k + 1)});
    }
    mesh.faces.push_back({below(k, 0), below(k + 1, 0), floor(k + 1, 0), floor(k, 0)});
    mesh.faces.push_back({below(k + 1, 3), below(k, 3), floor(k, 3), floor(k + 1, 3)});
    mesh.faces.push_back({below(3, k), below(3, k + 1), floor(3, k + 1), floor(3, k)});
    mesh.faces.push_back({below(0, k + 1), below(0, k), floor(0, k), floor(0, k + 1)});
  }
  // The pillar: its walls stand on the border of the middle cell.
  const std::vector<int> foot{floor(1, 1), floor(2, 1), floor(2, 2), floor(1, 2)};
  for (const int v : foot)
    mesh.vertices.emplace_back(mesh.vertices[static_cast<std::size_t>(v)] + Vec3(0, 0, 0.8));
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t next = (side + 1) % 4;
    mesh.faces.push_back({foot[side], foot[next], 32 + static_cast<int>(next), 32 + static_cast<int>(side)});
  }
  mesh.faces.push_back({32, 33, 34, 35});
  return triangulated(mesh);
}

TEST(ContactSetOfMeshes, ReachesDownToTheFootOfAWall) {
  // A box that stands on the floor: flat against a wall, wider or narrower than it; a corner of it at a wall;
  // and the corner of the pillar at a side of it. Of the wall it touches what it touches of a pillar by
  // itself, down to the floor, and on the floor it stands as without one.
  const Mesh mesh = make(floor_with_pillar());
  ASSERT_TRUE(mesh.tree->is_closed);
  const Box pillar{Vec3(0.2, 0.2, 0.4)};
  std::mt19937 engine(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int k = 0; k < 60; ++k) {
    const Box box{Vec3(uniform(0.05, 0.2), uniform(0.05, 0.3), uniform(0.03, 0.5))};
    const double angle = k % 3 == 0 ? 0 : uniform(0.2, 1.3);
    const Vec3 m(std::cos(angle), std::sin(angle), 0), along(-m.y(), m.x(), 0);
    Vec3 p(0, 0, box.half_extents.z());
    if (k % 3 == 2) {
      p += Vec3(-0.2, -0.2, 0) - box.half_extents.x() * m + uniform(-0.04, 0.04) * along;
    } else {
      // Its corner that is farthest in x, somewhere before the wall.
      const Vec3 corner = box.half_extents.x() * m - box.half_extents.y() * along;
      p.x() = -0.2 - corner.x();
      p.y() = uniform(-0.15, 0.15) - (k % 3 == 0 ? 0 : corner.y());
    }
    const Pose X_WB = turned(Vec3::UnitZ(), angle, p);
    std::vector<ContactPoint> of_wall, of_floor;
    for (const ContactPoint& contact : contact_set(mesh, Pose{}, box, X_WB, kTolerance))
      (std::abs(contact.n_W.z()) < 0.5 ? of_wall : of_floor).push_back(contact);
    expect_same_points(of_wall,
                       contact_set(pillar, {Mat3::Identity(), Vec3(0, 0, 0.4)}, box, X_WB, kTolerance),
                       10 * kRounding, "at the wall, " + std::to_string(k));
    EXPECT_GE(of_floor.size(), 3u);
    for (const ContactPoint& contact : of_floor) EXPECT_NEAR(contact.n_W.z(), 1, kRounding);
  }

  // What is about to meet a wide wall askew will do so down to the foot, too.
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const ContactReach within{kTolerance, 0.02};
    const Box box{Vec3(uniform(0.05, 0.2), uniform(0.05, 0.1), uniform(0.03, 0.3))};
    const double angle = uniform(-0.05, 0.05);
    const Vec3 m(std::cos(angle), std::sin(angle), 0);
    const double before = uniform(0.001, 0.015) + box.half_extents.y() * std::abs(m.y());
    const Pose X_WB =
        turned(Vec3::UnitZ(), angle,
               Vec3(-0.2 - before - box.half_extents.x() * m.x(), uniform(-0.1, 0.1), box.half_extents.z()));
    std::vector<ContactPoint> of_wall;
    for (const ContactPoint& contact : contact_set(mesh, Pose{}, box, X_WB, within)) {
      if (std::abs(contact.n_W.z()) < 0.5) of_wall.push_back(contact);
    }
    const Pose X_WP{Mat3::Identity(), Vec3(0, 0, 0.4)};
    const std::vector<ContactPoint> expected = contact_set(pillar, X_WP, box, X_WB, within);
    EXPECT_GE(expected.size(), 2u);
    expect_same_points(of_wall, expected, 10 * kRounding, "before the wall");
  }
}

TEST(ContactSetOfMeshes, OfEdgesCornersAndRoundShapesOnATessellatedFloorHasNoGhosts) {
  const Mesh floor = make(flat_floor());
  const double quarter = kPi / 4;
  const Mat3 on_corner = frame_with_z(Vec3(1, 1, 1).normalized()).transpose();
  const Mat3 lying = rotation_matrix(rotation_exp(Vec3(0, kPi / 2, 0)));
  struct Case {
    Shape shape;
    Mat3 R;
    double height;
    std::size_t count;
  };
  const std::vector<Case> cases = {
      {Sphere{0.2}, Mat3::Identity(), 0.2, 1},
      {Ellipsoid{Vec3(0.1, 0.2, 0.3)}, Mat3::Identity(), 0.3, 1},
      {Box{Vec3::Constant(0.3)}, rotation_matrix(rotation_exp(Vec3(quarter, 0, 0))), 0.3 * std::sqrt(2.0), 2},
      {Box{Vec3::Constant(0.3)}, on_corner, 0.3 * std::sqrt(3.0), 1},
      {Capsule{0.1, 0.6}, lying, 0.1, 2},
      {Capsule{0.1, 0.6}, Mat3::Identity(), 0.7, 1},
      {Cylinder{0.4, 0.2}, Mat3::Identity(), 0.2, 4},
      {Cylinder{0.2, 0.6}, lying, 0.2, 2},
      {Cone{0.4, 0.3}, Mat3::Identity(), 0.3, 4},
  };
  for (const Case& c : cases) {
    for (int step = 0; step < 16; ++step) {
      const Mat3 spin = rotation_matrix(rotation_exp(Vec3(0, 0, 0.1 * step)));
      const double gap = (step % 4 - 2) * 3e-7;
      const Pose X_WB{spin * c.R, Vec3(0.07 * step - 0.6, 0.05 * step - 0.4, c.height + gap)};
      const std::vector<ContactPoint> contacts = contact_set(floor, Pose{}, c.shape, X_WB, kTolerance);
      ASSERT_EQ(contacts.size(), c.count) << shape_type_name(c.shape) << ", step " << step;
      for (const ContactPoint& contact : contacts) {
        EXPECT_NEAR((contact.n_W - Vec3::UnitZ()).norm(), 0, kRounding) << shape_type_name(c.shape);
        EXPECT_NEAR(contact.gap, gap, 1e-12) << shape_type_name(c.shape);
      }
    }
  }
}

TEST(ContactSetOfMeshes, OfABallOverAVertexOfTheTessellationIsOnePoint) {
  const TriangleMesh triangles = flat_floor();
  const Mesh floor = make(triangles);
  for (const Vec3& v : triangles.vertices) {
    if (v.cwiseAbs().maxCoeff() > 1.9) continue;
    EXPECT_EQ(
        contact_set(floor, Pose{}, Sphere{0.3}, {Mat3::Identity(), v + Vec3(0, 0, 0.3)}, kTolerance).size(),
        1u);
  }
}

TEST(ContactSetOfMeshes, ABallInAValleyTouchesBothSidesAndOnARidgeOnlyTheRidge) {
  // Slopes of 45°: in the valley z = |x| the ball of radius r touches at a height of r/√2 on both sides.
  const Mesh valley = make(floor_mesh(6, [](double x) { return std::abs(x); }));
  const std::vector<ContactPoint> in_valley = contact_set(
      valley, Pose{}, Sphere{0.2}, {Mat3::Identity(), Vec3(0, 0.1, 0.2 * std::sqrt(2.0))}, kTolerance);
  ASSERT_EQ(in_valley.size(), 2u);
  for (const ContactPoint& contact : in_valley) {
    const double side = contact.p_WA.x() > 0 ? 1 : -1;
    EXPECT_NEAR((contact.n_W - Vec3(-side, 0, 1).normalized()).norm(), 0, kRounding);
    EXPECT_NEAR(contact.gap, 0, kRounding);
  }
  const Mesh ridge = make(floor_mesh(6, [](double x) { return -std::abs(x); }));
  const std::vector<ContactPoint> on_ridge =
      contact_set(ridge, Pose{}, Sphere{0.2}, {Mat3::Identity(), Vec3(0, 0.1, 0.2)}, kTolerance);
  ASSERT_EQ(on_ridge.size(), 1u);
  EXPECT_NEAR((on_ridge[0].n_W - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_EQ(on_ridge[0].curvature_A.flat_count, 1);
}

TEST(ContactSetOfMeshes, OfABoxFlatOnARidgeIsTheTwoEndsOfTheRidgeUnderIt) {
  const Mesh ridge = make(floor_mesh(6, [](double x) { return -0.3 * std::abs(x); }));
  const std::vector<ContactPoint> contacts = contact_set(ridge, Pose{}, Box{Vec3(0.5, 0.9, 0.2)},
                                                         {Mat3::Identity(), Vec3(0.1, 0.2, 0.2)}, kTolerance);
  ASSERT_EQ(contacts.size(), 2u);
  for (const ContactPoint& contact : contacts) {
    EXPECT_NEAR((contact.n_W - Vec3::UnitZ()).norm(), 0, kRounding);
    EXPECT_NEAR(contact.p_WA.x(), 0, kRounding);
    EXPECT_NEAR(std::abs(contact.p_WA.y() - 0.2), 0.9, kRounding);
    EXPECT_EQ(contact.curvature_B.flat_count, 2);
  }
}

TEST(ContactSetOfMeshes, OfATessellatedBoxOnAPlaneIsItsCorners) {
  const Mesh mesh = make(tessellated_box(Vec3(0.5, 0.4, 0.3), 4));
  const HalfSpace plane{Vec3::UnitZ(), 0};
  const std::vector<ContactPoint> contacts =
      contact_set(plane, Pose{}, mesh, turned(Vec3::UnitZ(), 0.4, Vec3(1, 2, 0.3)), kTolerance);
  ASSERT_EQ(contacts.size(), 4u);
  for (const ContactPoint& contact : contacts) {
    EXPECT_EQ(contact.n_W, Vec3::UnitZ());
    EXPECT_NEAR(contact.gap, 0, kRounding);
    EXPECT_EQ(contact.curvature_A.flat_count, 2);
    EXPECT_EQ(contact.curvature_B.flat_count, 0);
  }
}

TEST(ContactSetOfMeshes, OfATessellatedBoxIsThatOfTheBox) {
  // Random shapes brought to touch; corners without distance have no certain normal and are compared by their
  // points.
  const Vec3 half_extents(0.5, 0.4, 0.3);
  const Mesh mesh = make(tessellated_box(half_extents, 3));
  ASSERT_TRUE(mesh.tree->is_closed);
  std::mt19937 engine(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::vector<Shape> shapes = {Sphere{0.3},       Box{Vec3(0.3, 0.2, 0.4)},
                                     Capsule{0.1, 0.4}, Cylinder{0.2, 0.3},
                                     Cone{0.3, 0.3},    Ellipsoid{Vec3(0.2, 0.3, 0.5)}};
  for (int trial = 0; trial < 24; ++trial) {
    const Vec3 phi(uniform(engine), uniform(engine), uniform(engine));
    const Pose X_WA = turned(phi, 3 * uniform(engine), Vec3(uniform(engine), 0, 1));
    for (const Shape& shape : shapes) {
      const bool is_square = trial % 2 == 0;
      Pose X_WB = X_WA;
      if (!is_square)
        X_WB.R = rotation_matrix(rotation_exp(3 * Vec3(uniform(engine), uniform(engine), uniform(engine))));
      Vec3 offset = 0.3 * Vec3(uniform(engine), uniform(engine), uniform(engine));
      offset(trial % 3) = 2;
      X_WB.p += X_WA.R * offset;
      const DistanceResult d = signed_distance(Box{half_extents}, X_WA, shape, X_WB);
      X_WB.p -= (d.distance - 5e-7) * d.n_W;
      const std::string name = std::string(shape_type_name(shape)) + ", trial " + std::to_string(trial);
      const std::vector<ContactPoint> of_mesh = contact_set(mesh, X_WA, shape, X_WB, kTolerance);
      expect_same_points(of_mesh, contact_set(Box{half_extents}, X_WA, shape, X_WB, kTolerance), 1e-9, name);
      const std::vector<ContactPoint> exchanged = contact_set(shape, X_WB, mesh, X_WA, kTolerance);
      ASSERT_EQ(exchanged.size(), of_mesh.size()) << name;
      for (std::size_t k = 1; k < exchanged.size(); ++k)
        EXPECT_LE(exchanged[k - 1].feature, exchanged[k].feature);
    }
  }
}

TEST(ContactSetOfMeshes, OfTwoCornersWithoutDistanceIsNotEmpty) {
  // A box stands with its corner on the corner of the mesh, tilted more each step.
  const Mesh mesh = make(tessellated_box(Vec3::Constant(0.5), 3));
  const Mat3 R = frame_with_z(Vec3(1, 1, 1).normalized()).transpose();
  for (int step = 0; step < 7; ++step) {
    const Mat3 tilt = rotation_matrix(rotation_exp(0.1 * step * Vec3(0.3, 0.5, 0.1)));
    const Pose X_WB{tilt * R, Vec3::Constant(0.5) - tilt * R * Vec3::Constant(-0.5)};
    const std::vector<ContactPoint> contacts =
        contact_set(mesh, Pose{}, Box{Vec3::Constant(0.5)}, X_WB, 1e-9);
    ASSERT_FALSE(contacts.empty());
    for (const ContactPoint& contact : contacts) {
      EXPECT_NEAR((contact.p_WA - Vec3::Constant(0.5)).norm(), 0, 1e-9);
      EXPECT_GE(contact.n_W.minCoeff(), -1e-9);  // In the octant of normals of the corner.
    }
  }
}

TEST(ContactSetOfMeshes, KeepsItsFeaturesWhileABoxTurnsOnTheFloor) {
  const Mesh floor = make(flat_floor());
  std::vector<std::uint64_t> features;
  for (int step = 0; step < 40; ++step) {
    const Pose X_WB = turned(Vec3::UnitZ(), 0.02 * step, Vec3(0.02 * step, 0, 0.2));
    std::vector<std::uint64_t> now;
    for (const ContactPoint& c : contact_set(floor, Pose{}, Box{Vec3(0.4, 0.3, 0.2)}, X_WB, kTolerance)) {
      now.push_back(c.feature);
    }
    if (step == 0) features = now;
    EXPECT_EQ(now, features);
  }
}

}  // namespace
}  // namespace rigor::contact_mesh_test
