#include "rigor/bulk/narrow_phase/narrow_phase.hpp"

#include "bulk/face_preference.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rigor::narrow_phase_test {
namespace {

using test::Draw;
using test::face_preference;

/// Two bodies of one shape each, the first fixed, and what the narrow phase says of them.
struct TwoBodies {
  std::shared_ptr<const Model> model;
  BulkBodies bodies;

  TwoBodies(const Shape& a, const Shape& b) {
    ModelBuilder builder;
    for (const Shape* shape : {&a, &b}) {
      BodyDescription body;
      body.name = shape == &a ? "a" : "b";
      body.motion = shape == &a ? MotionType::fixed : MotionType::kinematic;
      body.shapes.push_back({*shape});
      builder.add_body(body);
    }
    model = builder.build();
    bodies.x.resize(2);
    bodies.q.resize(2);
    bodies.motion.resize(2);
    bodies.inertia.resize(2);
  }
  void place(const Pose& X_WA, const Pose& X_WB) {
    bodies.x = {X_WA.p, X_WB.p};
    bodies.q = {Quat(X_WA.R), Quat(X_WB.R)};
  }
  Pose pose(std::size_t i) const { return {bodies.q[i].toRotationMatrix(), bodies.x[i]}; }
  const Shape& shape(int i) const { return model->body(i).shapes[0].shape; }

  std::vector<PairManifold> manifolds(float margin) const {
    NarrowPhase narrow_phase(*model);
    ManifoldList found;
    narrow_phase.find_manifolds(bodies, {{0, 1, 0, 0, margin}}, Executor(1), found);
    return found.copies();
  }
};

double least_gap(const std::vector<PairManifold>& manifolds) {
  double least = INFINITY;
  for (const PairManifold& manifold : manifolds)
    for (int k = 0; k < manifold.manifold.point_count; ++k)
      least = std::min(least, static_cast<double>(manifold.manifold.points[static_cast<std::size_t>(k)].gap));
  return least;
}

Vec3 vec(const float* p) {
  return Vec3(p[0], p[1], p[2]);
}

/// Shapes that the narrow phase treats itself: sphere, box, capsule, hulls of 8 and 32 points.
Shape bulk_shape_of_kind(Draw& draw, int kind) {
  constexpr int kinds[] = {0, 1, 2, 6, 7};
  return draw.shape(kinds[kind]);
}
constexpr int kBulkKinds = 5;

/// Moves B along the line of centres until the signed distance is `gap`, by the secant of its distance.
Pose placed_at_gap(const Shape& a, const Pose& X_WA, const Shape& b, Pose X_WB, double gap) {
  for (int k = 0; k < 20; ++k) {
    const DistanceResult distance = signed_distance(a, X_WA, b, X_WB);
    if (std::abs(distance.distance - gap) < 1e-4) break;
    X_WB.p += (gap - distance.distance) * distance.n_W;
  }
  return X_WB;
}

/// Rounding of a float narrow phase at lengths of about 2 m: some 2e-7 of them for each of a few operations.
constexpr double kRounding = 4e-6;

/// Points of a manifold: in order, within the margin, and midway between points on or in the shapes.
void expect_points(const TwoBodies& pair, const Manifold& manifold, float margin, const std::string& where) {
  const Vec3 n = vec(manifold.normal);
  EXPECT_NEAR(n.norm(), 1, 1e-6) << where;
  for (int k = 0; k < manifold.point_count; ++k) {
    const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
    EXPECT_LE(point.gap, margin) << where;
    if (k > 0) {
      EXPECT_GT(point.feature, manifold.points[static_cast<std::size_t>(k - 1)].feature) << where;
    }
    const Vec3 p_W = pair.pose(0).p + vec(point.p);
    const double half = 0.5 * static_cast<double>(point.gap);
    const Shape speck = Sphere{1e-9};
    EXPECT_LE(
        signed_distance(pair.shape(0), pair.pose(0), speck, {Mat3::Identity(), p_W - half * n}).distance,
        3 * kRounding)
        << where << " point " << k;
    EXPECT_LE(
        signed_distance(pair.shape(1), pair.pose(1), speck, {Mat3::Identity(), p_W + half * n}).distance,
        3 * kRounding)
        << where << " point " << k;
  }
}

/// What a manifold has to be, from its definition and the signed distance in double precision.
void expect_right(const TwoBodies& pair, float margin, const std::string& where) {
  const Shape &a = pair.shape(0), &b = pair.shape(1);
  const Pose X_WA = pair.pose(0), X_WB = pair.pose(1);
  const DistanceResult distance = signed_distance(a, X_WA, b, X_WB);
  const std::vector<PairManifold> found = pair.manifolds(margin);
  if (distance.distance > margin + kRounding) {
    EXPECT_TRUE(found.empty()) << where;
    return;
  }
  const double preference = face_preference(a, b, distance.distance);
  if (distance.distance > margin - kRounding - preference) return;
  // Two polytopes may have a region over a face beside the point of their edges.
  ASSERT_FALSE(found.empty()) << where << " distance " << distance.distance;
  ASSERT_LE(found.size(), preference > 0 ? 2u : 1u) << where;
  EXPECT_NEAR(least_gap({found[0]}), distance.distance, kRounding + preference) << where;
  const Vec3 n = vec(found[0].manifold.normal);
  // The normal parts the shapes as well as any: of deep pairs another one may do that equally well. Where it
  // joins two points, their rounding turns it by that over the distance, with levers of up to 1 m.
  constexpr double point_rounding = 2.4e-7;
  const double turn = distance.distance > 0 ? point_rounding / distance.distance : 0;
  EXPECT_NEAR(test::separation_along(n.normalized(), a, X_WA, b, X_WB), distance.distance,
              kRounding + turn + preference)
      << where;
  for (const PairManifold& manifold : found) expect_points(pair, manifold.manifold, margin, where);
}

TEST(NarrowPhase, GapsNormalsAndPointsAreThoseOfTheExactDistanceOfAllKinds) {
  Draw draw(1);
  for (int kind_A = 0; kind_A < kBulkKinds; ++kind_A) {
    for (int kind_B = 0; kind_B < kBulkKinds; ++kind_B) {
      for (int k = 0; k < 8; ++k) {
        TwoBodies pair(bulk_shape_of_kind(draw, kind_A), bulk_shape_of_kind(draw, kind_B));
        for (int pose = 0; pose < 12; ++pose) {
          const Pose X_WA = draw.pose(1);
          const double gap = draw.uniform(-0.1, 0.06);
          pair.place(X_WA, placed_at_gap(pair.shape(0), X_WA, pair.shape(1), draw.pose(2), gap));
          expect_right(pair, 0.05f,
                       std::to_string(kind_A) + "-" + std::to_string(kind_B) + " no " + std::to_string(k) +
                           " pose " + std::to_string(pose));
        }
      }
    }
  }
}

TEST(NarrowPhase, AHalfSpaceTouchesTheVerticesBelowTheMargin) {
  Draw draw(2);
  for (int kind = 0; kind < kBulkKinds; ++kind) {
    for (int k = 0; k < 20; ++k) {
      TwoBodies pair(HalfSpace{draw.direction(), draw.uniform(-1, 1)}, bulk_shape_of_kind(draw, kind));
      const Pose X_WA = draw.pose(1);
      pair.place(X_WA,
                 placed_at_gap(pair.shape(0), X_WA, pair.shape(1), draw.pose(1), draw.uniform(-0.1, 0.05)));
      const DistanceResult distance = signed_distance(pair.shape(0), X_WA, pair.shape(1), pair.pose(1));
      const std::vector<PairManifold> found = pair.manifolds(0.06f);
      ASSERT_EQ(found.size(), 1u);
      // Of vertices that are nearly as deep as the deepest, four are chosen for the area that they span.
      const double equal_depth = static_cast<double>(kEqualDepthOfSize) * test::half_thickness(pair.shape(1));
      EXPECT_NEAR(least_gap(found), distance.distance, kRounding + equal_depth);
      EXPECT_LE((vec(found[0].manifold.normal) - distance.n_W).norm(), 1e-6);
    }
  }
}

/// Ellipsoids go through double precision.
TEST(NarrowPhase, EllipsoidsHaveTheGapsOfContactSet) {
  Draw draw(3);
  for (int other = 0; other < Draw::kKinds; ++other) {
    for (int k = 0; k < 3; ++k) {
      TwoBodies pair(draw.shape(5), draw.shape(other));
      const Pose X_WA = draw.pose(1);
      pair.place(X_WA,
                 placed_at_gap(pair.shape(0), X_WA, pair.shape(1), draw.pose(2), draw.uniform(-0.02, 0.04)));
      const std::vector<ContactPoint> contacts =
          contact_set(pair.shape(0), X_WA, pair.shape(1), pair.pose(1), 0.05);
      double least = INFINITY;
      for (const ContactPoint& contact : contacts) least = std::min(least, contact.gap);
      EXPECT_NEAR(least_gap(pair.manifolds(0.05f)), least, kRounding);
    }
  }
}

TEST(NarrowPhase, ABoxOnABoxStandsOnTheCornersOfTheCommonRectangle) {
  // Half over the edge, turned by a right angle: the common rectangle is [0, 1] x [-0.5, 0.5].
  TwoBodies pair(Box{Vec3(1, 0.5, 0.25)}, Box{Vec3(0.5, 1, 0.25)});
  pair.place({Mat3::Identity(), Vec3::Zero()}, {Mat3::Identity(), Vec3(0.5, 0, 0.499)});
  const std::vector<PairManifold> found = pair.manifolds(0.01f);
  ASSERT_EQ(found.size(), 1u);
  const Manifold& manifold = found[0].manifold;
  ASSERT_EQ(manifold.point_count, 4);
  double sum_x = 0, area = 0;
  for (const ManifoldPoint& point : manifold.points) {
    EXPECT_NEAR(point.gap, -0.001, 1e-7);
    EXPECT_NEAR(point.p[2], 0.2495, 1e-6);
    EXPECT_NEAR(std::abs(point.p[1]), 0.5, 1e-6);
    sum_x += point.p[0];
    area += std::abs(static_cast<double>((point.p[0] - 0.5f) * point.p[1]));
  }
  EXPECT_NEAR(sum_x, 2, 1e-6);
  EXPECT_NEAR(area, 1, 1e-6);
}

TEST(NarrowPhase, FarFromTheOriginNothingChanges) {
  // 2^20 m: sums of coordinates below 2 m in steps of 2^-20 m are exact there.
  Draw draw(4);
  const auto rounded = [](const Vec3& p) { return Vec3((p * 0x1p20).array().round() * 0x1p-20); };
  for (int kind_A = 0; kind_A < kBulkKinds; ++kind_A) {
    for (int kind_B = 0; kind_B < kBulkKinds; ++kind_B) {
      TwoBodies pair(bulk_shape_of_kind(draw, kind_A), bulk_shape_of_kind(draw, kind_B));
      Pose X_WA = draw.pose(1);
      Pose X_WB = placed_at_gap(pair.shape(0), X_WA, pair.shape(1), draw.pose(2), -0.01);
      X_WA.p = rounded(X_WA.p);
      X_WB.p = rounded(X_WB.p);
      pair.place(X_WA, X_WB);
      const std::vector<PairManifold> here = pair.manifolds(0.02f);
      for (Vec3& x : pair.bodies.x) x += Vec3::Constant(0x1p20);
      const std::vector<PairManifold> there = pair.manifolds(0.02f);
      ASSERT_FALSE(here.empty());
      ASSERT_EQ(here.size(), there.size());
      for (std::size_t k = 0; k < here.size(); ++k) {
        EXPECT_EQ(std::memcmp(&here[k].manifold, &there[k].manifold, sizeof(Manifold)), 0)
            << kind_A << "-" << kind_B;
      }
    }
  }
}

}  // namespace
}  // namespace rigor::narrow_phase_test
