#include "rigor/geometry/mass/point_sampling.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

namespace rigor::point_sampling_test {
namespace {

/// A box 1 x 2 x 3 turned about no axis in particular, as an implicit solid, with its tight axis-aligned box.
struct TurnedBox {
  Vec3 half{0.5, 1, 1.5};
  Pose X{rotation_matrix(rotation_exp({0.4, -0.6, 1.1})), {0.2, -0.3, 0.1}};

  std::function<bool(const Vec3&)> inside() const {
    return [X_inverse = X.inverse(), half = half](const Vec3& p) {
      return ((X_inverse * p).cwiseAbs().array() <= half.array()).all();
    };
  }
  Aabb box() const {
    const Vec3 extent = X.R.cwiseAbs() * half;
    return {X.p - extent, X.p + extent};
  }
  MassProperties exact() const { return transformed(mass_properties(Shape(Box{half}), 1), X); }
};

const Aabb kUnitBox{-Vec3::Ones(), Vec3::Ones()};
bool is_in_ball(const Vec3& p) {
  return p.squaredNorm() <= 1;
}

double inertia_error(const SampledMassProperties& s, const MassProperties& exact) {
  return (s.properties.inertia - exact.inertia).norm() / exact.inertia.norm();
}

TEST(PointSampling, With64CellsIsGoodToAThousandth) {
  const TurnedBox turned;
  SamplingOptions options;
  const SampledMassProperties box = sampled_mass_properties(turned.inside(), turned.box(), 1, options);
  EXPECT_NEAR(box.volume, 6, 6e-3);
  EXPECT_LT(inertia_error(box, turned.exact()), 2e-3);
  EXPECT_LT((box.properties.center - turned.X.p).norm(), 1e-3);

  const MassProperties ball = mass_properties(Shape(Sphere{1}), 1);
  const SampledMassProperties sphere = sampled_mass_properties(is_in_ball, kUnitBox, 1, options);
  EXPECT_NEAR(sphere.volume, ball.mass, 1e-3 * ball.mass);
  EXPECT_LT(inertia_error(sphere, ball), 2e-3);
}

/// Root mean square of the relative errors of volume and inertia over seeds.
struct RmsErrors {
  double volume = 0, inertia = 0;
};

template <class Inside>
RmsErrors rms_errors(const Inside& inside, const Aabb& box, const MassProperties& exact, int cells) {
  const int seeds = 100;
  RmsErrors rms;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SampledMassProperties s =
        sampled_mass_properties(inside, box, 1, {cells, 2, static_cast<std::uint64_t>(seed)});
    rms.volume += std::pow(s.volume / exact.mass - 1, 2) / seeds;
    rms.inertia += std::pow(inertia_error(s, exact), 2) / seeds;
  }
  return {std::sqrt(rms.volume), std::sqrt(rms.inertia)};
}

TEST(PointSampling, ErrorFallsWithTheSquareOfTheCellsAlongAnEdge) {
  // Doubling divides the root mean square by 4; 100 seeds measure a ratio to about a tenth of itself.
  const MassProperties ball = mass_properties(Shape(Sphere{1}), 1);
  const RmsErrors coarse = rms_errors(is_in_ball, kUnitBox, ball, 6);
  const RmsErrors fine = rms_errors(is_in_ball, kUnitBox, ball, 12);
  EXPECT_GT(coarse.volume / fine.volume, 3);
  EXPECT_LT(coarse.volume / fine.volume, 5.5);
  EXPECT_GT(coarse.inertia / fine.inertia, 3);

  const TurnedBox turned;
  const RmsErrors coarse_box = rms_errors(turned.inside(), turned.box(), turned.exact(), 6);
  const RmsErrors fine_box = rms_errors(turned.inside(), turned.box(), turned.exact(), 12);
  EXPECT_GT(coarse_box.volume / fine_box.volume, 3);
  EXPECT_GT(coarse_box.inertia / fine_box.inertia, 3);
}

/// How many of the seeds have volume, centre and inertia (xx and xy) within the given number of deviations of
/// the truth.
std::array<int, 4> hits(const std::function<bool(const Vec3&)>& inside, const Aabb& box,
                        const MassProperties& exact, int seeds, double deviations) {
  std::array<int, 4> count{};
  for (int seed = 1; seed <= seeds; ++seed) {
    const SampledMassProperties s =
        sampled_mass_properties(inside, box, 1, {8, 2, static_cast<std::uint64_t>(seed)});
    count[0] += std::abs(s.volume - exact.mass) <= deviations * s.volume_deviation;
    count[1] += std::abs(s.properties.center.x() - exact.center.x()) <= deviations * s.center_deviation.x();
    count[2] +=
        std::abs(s.properties.inertia(0, 0) - exact.inertia(0, 0)) <= deviations * s.inertia_deviation(0, 0);
    count[3] +=
        std::abs(s.properties.inertia(0, 1) - exact.inertia(0, 1)) <= deviations * s.inertia_deviation(0, 1);
  }
  return count;
}

TEST(PointSampling, TruthLiesWithinThreeDeviationsForNinetyNineOfAHundredSeeds) {
  const TurnedBox turned;
  const MassProperties ball = mass_properties(Shape(Sphere{1}), 1);
  for (const int count : hits(is_in_ball, kUnitBox, ball, 1000, 3)) EXPECT_GE(count, 990);
  for (const int count : hits(turned.inside(), turned.box(), turned.exact(), 1000, 3)) EXPECT_GE(count, 990);
}

TEST(PointSampling, DeviationsAreNotTooLargeEither) {
  // Of a normal distribution 68.3 % lie within one deviation: of 400 seeds 273 ± 9.3.
  const TurnedBox turned;
  for (const int count : hits(turned.inside(), turned.box(), turned.exact(), 400, 1))
    EXPECT_NEAR(count, 273, 37);
}

TEST(PointSampling, SameSeedGivesTheSameBitsAndAnotherSeedDoesNot) {
  const SampledMassProperties a = sampled_mass_properties(is_in_ball, kUnitBox, 1, {8, 2, 7});
  const SampledMassProperties b = sampled_mass_properties(is_in_ball, kUnitBox, 1, {8, 2, 7});
  const SampledMassProperties c = sampled_mass_properties(is_in_ball, kUnitBox, 1, {8, 2, 8});
  EXPECT_EQ(a.properties.inertia, b.properties.inertia);
  EXPECT_EQ(a.volume_deviation, b.volume_deviation);
  EXPECT_NE(a.properties.inertia, c.properties.inertia);
}

TEST(PointSampling, OfNothingHasNoMass) {
  const SampledMassProperties nothing =
      sampled_mass_properties([](const Vec3&) { return false; }, kUnitBox, 1, {4, 2, 1});
  EXPECT_EQ(nothing.volume, 0);
  EXPECT_EQ(nothing.properties.mass, 0);
}

TEST(PointSampling, AgreesWithTheExactPropertiesOfEveryShape) {
  const auto hull = std::make_shared<const ConvexHull>(
      std::get<ConvexHull>(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.8, 0.9, 1}})));
  const auto mesh = std::make_shared<const TriangleMesh>(
      triangulated(make_prism({{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}, 1)));
  const std::vector<Shape> shapes = {
      Sphere{0.9},    Box{{0.5, 0.6, 0.7}},       Capsule{0.4, 0.6}, Cylinder{0.7, 0.9},
      Cone{0.9, 0.8}, Ellipsoid{{0.5, 0.7, 0.9}}, Convex{hull},      Mesh{mesh}};
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape_type_name(shape));
    const MassProperties exact = mass_properties(shape, 2);
    const SampledMassProperties s = sampled_mass_properties(
        make_inside_test(shape), {Vec3::Constant(-1.01), Vec3::Constant(1.01)}, 2, {24, 2, 1});
    // Five deviations of each of ten quantities: one run in a hundred thousand would miss.
    EXPECT_LE(std::abs(s.properties.mass - exact.mass), 10 * s.volume_deviation);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(std::abs(s.properties.center[i] - exact.center[i]), 5 * s.center_deviation[i]);
      for (int j = 0; j < 3; ++j) {
        EXPECT_LE(std::abs(s.properties.inertia(i, j) - exact.inertia(i, j)), 5 * s.inertia_deviation(i, j));
      }
    }
  }
}

TEST(Containment, OfEveryShapeHasItsBorderWhereTheFormulaSays) {
  EXPECT_TRUE(contains(Sphere{2}, {2, 0, 0}));
  EXPECT_FALSE(contains(Sphere{2}, {2, 1e-7, 0}));
  EXPECT_TRUE(contains(Cone{1, 1}, {0.5, 0, 0}));  // half the radius at half height
  EXPECT_FALSE(contains(Cone{1, 1}, {0.5, 0, 1e-15}));
  EXPECT_FALSE(contains(Cone{1, 1}, {0, 0, -1.1}));
  EXPECT_TRUE(contains(Capsule{1, 2}, {0, 0, 3}));
  EXPECT_FALSE(contains(Capsule{1, 2}, {0.1, 0, 3}));
  EXPECT_TRUE(contains(HalfSpace{Vec3::UnitZ(), 1}, {5, 5, 1}));
  EXPECT_FALSE(contains(HalfSpace{Vec3::UnitZ(), 1}, {5, 5, 1.5}));
}

TEST(WindingNumber, IsAnIntegerForRaysThroughVerticesAndEdges) {
  // Points of a coarse grid below and inside a mesh whose vertices lie on the same grid.
  const PolygonMesh outer = make_box_mesh(Vec3::Zero(), Vec3::Constant(4));
  const PolygonMesh hole = inside_out(make_box_mesh(Vec3::Ones(), Vec3::Constant(3)));
  const TriangleMesh mesh = triangulated(joined(outer, hole));
  const WindingNumber winding(mesh);
  for (const double z : {-1.0, 0.5, 1.5, 3.5, 5.0}) {
    for (double x = 0.5; x < 4; x += 0.5) {
      for (double y = 0.5; y < 4; y += 0.5) {
        const bool is_in_column = x > 1 && x < 3 && y > 1 && y < 3;
        const bool on_wall_of_hole = !is_in_column && x >= 1 && x <= 3 && y >= 1 && y <= 3;
        if (on_wall_of_hole && z > 1 && z < 3) continue;
        const int expected = z > 0 && z < 4 && !(is_in_column && z > 1 && z < 3) ? 1 : 0;
        EXPECT_EQ(winding({x, y, z}), expected) << x << " " << y << " " << z;
        EXPECT_EQ(winding_number(mesh, {x, y, z}), expected);
      }
    }
  }
}

TEST(WindingNumber, CountsOverlapsTwiceAndInsideOutSolidsNegative) {
  const PolygonMesh cube = make_box_mesh(Vec3::Zero(), Vec3::Ones());
  EXPECT_EQ(winding_number(triangulated(joined(cube, cube)), {0.5, 0.25, 0.125}), 2);
  EXPECT_EQ(winding_number(triangulated(inside_out(cube)), {0.5, 0.25, 0.125}), -1);
}

}  // namespace
}  // namespace rigor::point_sampling_test
