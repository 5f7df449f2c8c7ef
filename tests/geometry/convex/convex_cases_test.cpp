// Cases that collision libraries are known to get wrong, by their issue numbers, and properties of all pairs.

#include "fuzz/convex_pair.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <gtest/gtest.h>

namespace rigor::convex_cases_test {
namespace {

using test::Draw;

Pose moved(double x, double y, double z) {
  return {.p = Vec3(x, y, z)};
}

Mat3 turned(double x, double y, double z) {
  return rotation_matrix(rotation_exp(Vec3(x, y, z)));
}

void expect_answer(const DistanceResult& r, double distance, const Vec3& n) {
  EXPECT_NEAR(r.distance, distance, 1e-15);
  EXPECT_LT((r.n_W - n).norm(), 1e-14);
  EXPECT_LE(r.lower, distance);
  EXPECT_GE(r.upper, distance);
}

TEST(ConvexCases, CubesThatOverlapByATenthPartAlongTheirFace) {
  // libccd#25: two cubes of side 2 at z = 1.9; an expanding polytope may end along the diagonal.
  const Box cube{Vec3::Constant(1)};
  expect_answer(signed_distance(cube, {}, cube, moved(0, 0, 1.9)), 1.9 - 2, Vec3::UnitZ());
}

TEST(ConvexCases, ACubeInTheCornerOfACubeLeavesAlongAnAxis) {
  // fcl#545, libccd#71: MPR reports the diagonal, -0.3 √3.
  const DistanceResult r =
      signed_distance(Box{Vec3::Constant(0.5)}, {}, Box{Vec3::Constant(0.2)}, moved(0.4, 0.4, 0.4));
  EXPECT_NEAR(r.distance, -0.3, 1e-15);
  EXPECT_EQ(r.n_W.cwiseAbs().maxCoeff(), 1);
}

TEST(ConvexCases, CylindersSideBySideAlongASweep) {
  // coal#779: r = 0.25, length 0.1; apart along x or, deep inside, along the axis.
  const Cylinder cylinder{0.25, 0.05};
  for (int i = -99; i <= 99; ++i) {
    const double x = 0.01 * i;
    const double expected = std::abs(x) < 0.5 ? -std::min(0.1, 0.5 - std::abs(x)) : std::abs(x) - 0.5;
    EXPECT_NEAR(signed_distance(cylinder, {}, cylinder, moved(x, 0, 0)).distance, expected, 1e-15) << x;
  }
}

TEST(ConvexCases, CubesThatOverlapByATenThousandth) {
  // coal#144, pinocchio#1372, libccd#36.
  const Box cube{Vec3::Constant(1)};
  expect_answer(signed_distance(cube, {}, cube, moved(1.9999, 0, 0)), 1.9999 - 2, Vec3::UnitX());
}

TEST(ConvexCases, AThinPlateBesideACylinder) {
  // fcl#319: a box 0.05 x 0.39 x 1.47 and a cylinder with r = 0.18, length 0.18, 0.025 apart.
  const Box plate{Vec3(0.025, 0.195, 0.735)};
  const Cylinder cylinder{0.18, 0.09};
  expect_answer(signed_distance(plate, {}, cylinder, moved(0.025 + 0.18 + 0.025, 0.01, 0.2)), 0.025,
                Vec3::UnitX());
  // fcl#390: almost touching.
  const double gap = 2.0465736e-8;
  EXPECT_NEAR(signed_distance(plate, {}, cylinder, moved(0.205 + gap, 0, 0)).distance, gap, 1e-16);
}

TEST(ConvexCases, BoxesLessThanARoundingApartHaveTheFaceNormal) {
  // fcl#493, fcl#495, fcl#445: turned boxes, face on face to the last digit.
  const Box large{Vec3::Constant(0.25)};
  const Box small{Vec3::Constant(0.125)};
  Draw draw(1);
  for (int i = 0; i < 50; ++i) {
    const Mat3 R = draw.rotation();
    const Vec3 p = draw.pose(1).p;
    const Vec3 offset(draw.uniform(-0.2, 0.2), draw.uniform(-0.2, 0.2), 0.375);
    const DistanceResult r = signed_distance(large, {R, p}, small, {R, p + R * offset});
    EXPECT_LT(std::abs(r.distance), 1e-15);
    EXPECT_LT((r.n_W - R.col(2)).norm(), 1e-14);
  }
}

TEST(ConvexCases, SpheresAndBoxesAtOnePlaceAreAsDeepAsTheyAreWide) {
  // fcl#578: a loop without end.
  EXPECT_EQ(signed_distance(Sphere{0.5}, {}, Sphere{0.5}, {}).distance, -1);
  EXPECT_EQ(signed_distance(Box{Vec3::Constant(0.5)}, {}, Box{Vec3::Constant(0.5)}, {}).distance, -1);
}

TEST(ConvexCases, APebbleInTheFloorLeavesUpwards) {
  // mujoco_warp#1430: a box of 200 m and one of 0.2 m, 1e-4 deep.
  const Box floor{Vec3(100, 100, 100)};
  const Box pebble{Vec3::Constant(0.1)};
  const DistanceResult r = signed_distance(floor, moved(0, 0, -100), pebble, moved(37, -11, 0.1 - 1e-4));
  EXPECT_NEAR(r.distance, -1e-4, 3e-14);  // Two roundings of 100.
  EXPECT_LT((r.n_W - Vec3::UnitZ()).norm(), 1e-14);
}

TEST(ConvexCases, TheNormalDoesNotFlipOnTheWayIntoContact) {
  // bullet3#889: a hundred steps from 0.01 to 0.
  const Box box{Vec3(0.5, 0.4, 0.3)};
  const Shape turned_box = Box{Vec3(0.2, 0.3, 0.25)};
  const Mat3 R = turned(0.4, -0.3, 0.2);
  const double height = 2 - signed_distance(box, {}, turned_box, {R, Vec3(0.1, 0.05, 2)}).distance;
  for (int i = 100; i >= -100; --i) {
    const DistanceResult r = signed_distance(box, {}, turned_box, {R, Vec3(0.1, 0.05, height + 1e-4 * i)});
    expect_answer(r, (height + 1e-4 * i) - height, Vec3::UnitZ());
  }
}

TEST(ConvexCases, ParallelEdgesAreApartAsTheirLines) {
  // Boxes turned by 45 degrees about y, edge over edge at any shift along them.
  const Box box{Vec3::Constant(0.5)};
  const Mat3 R = turned(0, std::numbers::pi / 4, 0);
  for (const double gap : {1e-12, 1e-6, 0.3}) {
    for (const double shift : {0.0, 0.25, 0.999}) {
      const DistanceResult r = signed_distance(box, {.R = R}, box, {R, Vec3(0, shift, std::sqrt(2) + gap)});
      EXPECT_NEAR(r.distance, gap, 1e-15);
    }
  }
}

TEST(ConvexProperties, NeedlesOfAspectTenThousandKeepTheirPromises) {
  Draw draw(2);
  for (int i = 0; i < 120; ++i) {
    const auto needle = [&]() -> Shape {
      const double thin = 1e-4 * draw.size();
      switch (i % 4) {
        case 0:
          return Box{Vec3(draw.size(), thin, thin)};
        case 1:
          return Cylinder{thin, draw.size()};
        case 2:
          return Ellipsoid{Vec3(thin, draw.size(), thin)};
        default: {
          std::vector<Vec3> points;
          for (int k = 0; k < 12; ++k) points.push_back(Vec3(1, 1e-4, 1e-4).cwiseProduct(draw.direction()));
          return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
        }
      }
    };
    const Shape a = needle();
    const Shape b = needle();
    const double reach = i % 3 == 0 ? 1e-5 : 0.5;
    EXPECT_EQ(test::fault_of_distance(a, draw.pose(reach), b, draw.pose(reach)), "") << i;
  }
}

TEST(ConvexProperties, ARigidMotionChangesNothingButRounding) {
  Draw draw(3);
  for (int i = 0; i < 81; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const double reach = i % 3 == 0 ? 0.2 : 0.8;
    const Pose X_WA = draw.pose(reach);
    const Pose X_WB = draw.pose(reach);
    const Pose X = draw.pose(1);
    const DistanceResult here = signed_distance(a, X_WA, b, X_WB);
    const DistanceResult there = signed_distance(a, X * X_WA, b, X * X_WB);
    EXPECT_NEAR(there.distance, here.distance, 1e-14);
  }
}

TEST(ConvexProperties, TheNormalIsTheGradientOfTheDistance) {
  // The signed distance is a convex function of the translation q of B, n a gradient of it:
  // n(0)·q ≤ d(q) - d(0) ≤ n(q)·q, overlapping or apart.
  Draw draw(4);
  for (int i = 0; i < 81; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const Pose X_WA = draw.pose(0.5);
    const Pose X_WB = draw.pose(0.5);
    const DistanceResult r = signed_distance(a, X_WA, b, X_WB);
    for (const double step : {1e-8, 1e-4, 0.1}) {
      const Vec3 q = step * draw.direction();
      const DistanceResult s = signed_distance(a, X_WA, b, {X_WB.R, X_WB.p + q});
      EXPECT_GE(s.distance - r.distance, r.n_W.dot(q) - 1e-14);
      EXPECT_LE(s.distance - r.distance, s.n_W.dot(q) + 1e-14);
    }
  }
}

TEST(ConvexProperties, ALargerShapeIsNoFarther) {
  Draw draw(5);
  const auto grown = [](const Shape& shape, double s) -> Shape {
    if (const Box* const box = std::get_if<Box>(&shape)) return Box{s * box->half_extents};
    if (const Ellipsoid* const egg = std::get_if<Ellipsoid>(&shape)) return Ellipsoid{s * egg->radii};
    if (const Cylinder* const c = std::get_if<Cylinder>(&shape))
      return Cylinder{s * c->radius, s * c->half_length};
    if (const Cone* const c = std::get_if<Cone>(&shape)) return Cone{s * c->radius, s * c->half_length};
    if (const Capsule* const c = std::get_if<Capsule>(&shape))
      return Capsule{s * c->radius, s * c->half_length};
    return Sphere{s * std::get<Sphere>(shape).radius};
  };
  for (int i = 0; i < 6 * 9 * 3; ++i) {
    const Shape a = draw.shape(i % 6);
    const Shape b = draw.shape(i / 6 % Draw::kKinds);
    const Pose X_WA = draw.pose(0.6);
    const Pose X_WB = draw.pose(0.6);
    double before = signed_distance(a, X_WA, b, X_WB).distance;
    for (const double s : {1 + 1e-9, 1.01, 1.5}) {
      const double distance = signed_distance(grown(a, s), X_WA, b, X_WB).distance;
      EXPECT_LE(distance, before + 1e-14);
      before = distance;
    }
  }
}

}  // namespace
}  // namespace rigor::convex_cases_test
