#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace rigor::mesh_pair_contacts_test {
namespace {

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].
constexpr double kRounding = 1e-13;  ///< A few rounding errors of coordinates of a few metres.

Mesh make(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<TriangleMesh>(mesh));
}
Mesh make_box(const Vec3& half_extents) {
  return make(triangulated(make_box_mesh(-half_extents, half_extents)));
}
Mesh make_prism_mesh(const std::vector<Vec2>& loop, double height) {
  return make(triangulated(make_prism(loop, height)));
}

/// Floor of n × n squares over [-2, 2]² at z = 0 with a block below it: closed.
Mesh tiled_block(int n) {
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) mesh.vertices.emplace_back(-2 + 4.0 * i / n, -2 + 4.0 * j / n, 0);
  }
  const int base = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, -2);
  const auto vertex = [&](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
    mesh.triangles.push_back({vertex(i + 1, 0), vertex(i, 0), base});
    mesh.triangles.push_back({vertex(i, n), vertex(i + 1, n), base});
    mesh.triangles.push_back({vertex(0, i), vertex(0, i + 1), base});
    mesh.triangles.push_back({vertex(n, i + 1), vertex(n, i), base});
  }
  return make(mesh);
}

Pose turned(const Vec3& phi, const Vec3& p) {
  return {rotation_matrix(rotation_exp(phi)), p};
}

TEST(ContactSetOfTwoMeshes, OfTwoCubesFaceToFaceIsFourPoints) {
  const Mesh cube = make_box(Vec3::Constant(0.5));
  for (const double gap : {-5e-7, 0.0, 5e-7}) {
    for (const Vec3& offset : {Vec3(0, 0, 1 + gap), Vec3(0.3, 0.2, 1 + gap), Vec3(0.3, 0, 1 + gap)}) {
      const Pose X_WB{Mat3::Identity(), offset};
      const std::vector<ContactPoint> contacts = contact_set(cube, Pose{}, cube, X_WB, kTolerance);
      ASSERT_EQ(contacts.size(), 4u) << gap << " at " << offset.transpose();
      for (const ContactPoint& contact : contacts) {
        EXPECT_EQ(contact.n_W, Vec3::UnitZ());
        EXPECT_NEAR(contact.gap, gap, kRounding);
        // The corners of the rectangle in which the faces lie on each other.
        EXPECT_NEAR(contact.p_WA.z(), 0.5, kRounding);
        for (int axis = 0; axis < 2; ++axis) {
          const double low = offset[axis] - 0.5, x = contact.p_WA[axis];
          EXPECT_LE(std::min(std::abs(x - low), std::abs(x - 0.5)), kRounding);
        }
        EXPECT_FALSE(contact.degenerate);
      }
    }
  }
}

TEST(ContactSetOfTwoMeshes, OfTwoBoxesIsThatOfTheBoxes) {
  const Vec3 half_a(0.5, 0.4, 0.3), half_b(0.3, 0.2, 0.4);
  const Mesh a = make_box(half_a), b = make_box(half_b);
  std::mt19937 engine(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 phi = 3 * Vec3(uniform(engine), uniform(engine), uniform(engine));
    const Pose X_WA = turned(phi, Vec3(uniform(engine), 0, 1));
    Pose X_WB = X_WA;
    if (trial % 2 == 1) X_WB.R = turned(3 * Vec3(uniform(engine), uniform(engine), 1), Vec3::Zero()).R;
    if (trial % 4 == 2) X_WB.R = X_WA.R * turned(Vec3(0, 0, uniform(engine)), Vec3::Zero()).R;
    Vec3 offset = 0.3 * Vec3(uniform(engine), uniform(engine), uniform(engine));
    offset(trial % 4 == 2 ? 2 : trial % 3) = 2;
    X_WB.p += X_WA.R * offset;
    const DistanceResult d = signed_distance(Box{half_a}, X_WA, Box{half_b}, X_WB);
    X_WB.p -= (d.distance - (trial % 5 - 2) * 3e-7) * d.n_W;
    const std::vector<ContactPoint> found = contact_set(a, X_WA, b, X_WB, kTolerance);
    const std::vector<ContactPoint> expected = contact_set(Box{half_a}, X_WA, Box{half_b}, X_WB, kTolerance);
    // Where a corner meets an edge or a corner, the normal is one of many.
    if (std::ranges::any_of(found, [](const ContactPoint& c) { return c.degenerate; })) continue;
    ++compared;
    ASSERT_EQ(found.size(), expected.size()) << "trial " << trial;
    for (const ContactPoint& e : expected) {
      const bool is_there = std::ranges::any_of(found, [&](const ContactPoint& f) {
        const double places = (f.p_WA - e.p_WA).norm() + (f.p_WB - e.p_WB).norm();
        return places + (f.n_W - e.n_W).norm() < 1e-9;
      });
      EXPECT_TRUE(is_there) << "trial " << trial << " " << e.p_WA.transpose();
    }
  }
  EXPECT_GE(compared, 150);
}

TEST(ContactSetOfTwoMeshes, ExchangesWithTheMeshes) {
  const Mesh a = make_box(Vec3(0.5, 0.4, 0.3)), b = make_box(Vec3(0.3, 0.2, 0.4));
  const Pose X_WA = turned(Vec3(0.3, 0.2, 0.1), Vec3(1, 2, 3));
  for (const Mesh& second : {a, b}) {
    Pose X_WB{X_WA.R * turned(Vec3(0, 0, 0.4), Vec3::Zero()).R, X_WA * Vec3(0.1, 0.05, 0.8)};
    const DistanceResult d = signed_distance(a, X_WA, second, X_WB);
    X_WB.p -= d.distance * d.n_W;
    const std::vector<ContactPoint> forward = contact_set(a, X_WA, second, X_WB, kTolerance);
    const std::vector<ContactPoint> backward = contact_set(second, X_WB, a, X_WA, kTolerance);
    ASSERT_GE(forward.size(), 4u);
    ASSERT_EQ(forward.size(), backward.size());
    for (const ContactPoint& f : forward) {
      const bool is_there = std::ranges::any_of(backward, [&](const ContactPoint& g) {
        return f.p_WA == g.p_WB && f.p_WB == g.p_WA && f.n_W == -g.n_W && f.gap == g.gap;
      });
      EXPECT_TRUE(is_there);
    }
  }
}

TEST(ContactSetOfTwoMeshes, HasNoGhostsOnATessellatedFloorAndKeepsItsFeatures) {
  const Mesh floor = tiled_block(9), box = make_box(Vec3(0.4, 0.3, 0.2));
  for (int step = 0; step < 40; ++step) {
    const double gap = (step % 3 - 1) * 4e-7;
    const Pose X_WB = turned(Vec3(0, 0, 0.1 * step), Vec3(0.02 * step - 0.4, 0.03 * step - 0.6, 0.2 + gap));
    const std::vector<ContactPoint> contacts = contact_set(floor, Pose{}, box, X_WB, kTolerance);
    ASSERT_EQ(contacts.size(), 4u) << step;
    for (const ContactPoint& contact : contacts) {
      EXPECT_NEAR((contact.n_W - Vec3::UnitZ()).norm(), 0, kRounding);
      EXPECT_NEAR(contact.gap, gap, kRounding);
      EXPECT_EQ(contact.curvature_A.flat_count, 2);
    }
    const std::vector<ContactPoint> again = contact_set(floor, Pose{}, box, X_WB, kTolerance);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(again[k].feature, contacts[k].feature);
  }
}

TEST(ContactSetOfTwoMeshes, OfABoxInAGrooveIsItsTwoLowerFaces) {
  // A V-shaped groove along y, its walls at 45°, holds a box turned by 45°: each wall a rectangle of contact.
  const Mesh groove = make_prism_mesh({Vec2(-2, -1), Vec2(2, -1), Vec2(2, 2), Vec2(0, 0), Vec2(-2, 2)}, 6);
  const Mesh box = make_box(Vec3(0.3, 0.3, 0.5));
  const Pose X_WB{turned(Vec3(0, 0, std::numbers::pi / 4), Vec3::Zero()).R,
                  Vec3(0, 0.3 * std::sqrt(2.0) + 3e-7, 3)};
  const std::vector<ContactPoint> contacts = contact_set(groove, Pose{}, box, X_WB, kTolerance);
  ASSERT_EQ(contacts.size(), 8u);
  for (const double side : {-1.0, 1.0}) {
    const long count = std::ranges::count_if(contacts, [side](const ContactPoint& c) {
      return (c.n_W - Vec3(side, 1, 0).normalized()).norm() < 1e-9;
    });
    EXPECT_EQ(count, 4);
  }
}

TEST(ContactSetOfTwoMeshes, OfACornerOnAnEdgeOrACornerIsOnePointBetweenTheFaces) {
  const Mesh cube = make_box(Vec3::Constant(0.5));
  const Mat3 on_corner = frame_with_z(Vec3(1, 1, 1).normalized()).transpose();
  const double high = 0.5 * std::sqrt(3.0);
  // Corner above corner, and corner on the middle of an edge turned upwards.
  const Mat3 on_edge = rotation_matrix(rotation_exp(Vec3(std::numbers::pi / 4, 0, 0)));
  for (const bool is_edge : {false, true}) {
    const Pose X_WA{is_edge ? on_edge : on_corner, Vec3::Zero()};
    const double top = is_edge ? 0.5 * std::sqrt(2.0) : high;
    const Pose X_WB{on_corner, Vec3(0.1 * is_edge, 0, top + high)};
    const std::vector<ContactPoint> contacts = contact_set(cube, X_WA, cube, X_WB, kTolerance);
    ASSERT_EQ(contacts.size(), 1u) << is_edge;
    // One of the directions that part them as well: none of the two reaches past the corner along it.
    EXPECT_GE(test::separation_along(contacts[0].n_W, Box{Vec3::Constant(0.5)}, X_WA,
                                     Box{Vec3::Constant(0.5)}, X_WB),
              -1e-12);
    EXPECT_NEAR(contacts[0].gap, 0, 1e-12);
    EXPECT_TRUE(contacts[0].degenerate);
  }
}

TEST(DistanceOfTwoMeshes, OfTwoBoxesIsThatOfTheBoxesAndExchangesBitForBit) {
  const Vec3 half_a(0.5, 0.4, 0.3), half_b(0.3, 0.2, 0.4);
  const Mesh a = make_box(half_a), b = make_box(half_b);
  std::mt19937 engine(29);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(engine), normal(engine), normal(engine)); };
  int count = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Pose X_WA = turned(vector(), vector());
    Pose X_WB = turned(vector(), X_WA.p + 2 * vector().normalized());
    const DistanceResult expected = signed_distance(Box{half_a}, X_WA, Box{half_b}, X_WB);
    const DistanceResult found = signed_distance(a, X_WA, b, X_WB);
    EXPECT_NEAR(found.distance, expected.distance, kRounding);
    EXPECT_LE(found.lower, expected.distance + kRounding);
    EXPECT_GE(found.upper, expected.distance - kRounding);
    EXPECT_NEAR((found.p_WB - found.p_WA - found.distance * found.n_W).norm(), 0, kRounding);
    const DistanceResult exchanged = signed_distance(b, X_WB, a, X_WA);
    EXPECT_EQ(exchanged.distance, found.distance);
    EXPECT_EQ(exchanged.n_W, -found.n_W);
    // A shallow overlap has the depth of the boxes, or less where a corner meets an edge.
    X_WB.p -= (expected.distance + 1e-6) * expected.n_W;
    const double depth = signed_distance(Box{half_a}, X_WA, Box{half_b}, X_WB).distance;
    const double found_depth = signed_distance(a, X_WA, b, X_WB).distance;
    EXPECT_LT(found_depth, 0.5 * depth) << trial;
    EXPECT_GE(found_depth, depth - 1e-12) << trial;
    count += std::abs(found_depth - depth) < 1e-12;
  }
  EXPECT_GE(count, 90);
}

TEST(DistanceOfTwoMeshes, HasItsWitnessesWhereEdgesCrossInAShallowOverlap) {
  // An upright edge of one box, turned by 45°, against a level edge of the other: they cross at the origin.
  const Mesh box = make_box(Vec3(0.5, 0.5, 0.5));
  const double high = 0.5 * std::sqrt(2.0) - 5e-9;
  const Pose X_WA = turned(Vec3(std::numbers::pi / 4, 0, 0), Vec3(0.2, 0, -high));
  const Pose X_WB = turned(Vec3(0, std::numbers::pi / 4, 0), Vec3(0, 0.1, high));
  const DistanceResult found = signed_distance(box, X_WA, box, X_WB);
  EXPECT_NEAR(found.distance, -1e-8, kRounding);
  EXPECT_NEAR((found.n_W - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR(found.p_WA.norm(), 0, 1e-7);
  EXPECT_NEAR(found.p_WB.norm(), 0, 1e-7);
}

TEST(DistanceOfTwoMeshes, IsNegativeWhereOneLiesInTheOther) {
  const Mesh outer = make_box(Vec3::Constant(1)), inner = make_box(Vec3::Constant(0.1));
  const Pose X_WB{Mat3::Identity(), Vec3(0.7, 0, 0)};
  // Out through the face x = 1, of which the inner box is 0.2 away: by that and its own width.
  const DistanceResult found = signed_distance(outer, Pose{}, inner, X_WB);
  EXPECT_NEAR(found.distance, -0.4, kRounding);
  EXPECT_NEAR((found.n_W - Vec3::UnitX()).norm(), 0, kRounding);
  EXPECT_LE(found.lower, found.distance);
  EXPECT_GE(found.upper, found.distance);
  EXPECT_GT(signed_distance(outer, Pose{}, inner, {Mat3::Identity(), Vec3(1.7, 0, 0)}).distance, 0.59);
}

}  // namespace
}  // namespace rigor::mesh_pair_contacts_test
