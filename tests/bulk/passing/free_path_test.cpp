// Ways of convex shapes near each other and near meshes. The truth: their distances along these ways.

#include "rigor/bulk/passing/free_path.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/thickness.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace rigor::free_path_test {
namespace {

using test::Draw;

constexpr double kDeepShare = 0.15;

/// Hills of cells of 0.5 m, as a solid or as a sheet.
Shape hills(double steepness, bool is_sheet) {
  HeightField field{{}, Vec2(8, 8), 1};
  for (int row = 0; row <= 16; ++row) {
    field.rows.emplace_back();
    for (int column = 0; column <= 16; ++column)
      field.rows.back().push_back(steepness * std::sin(1.7 * (0.5 * column - 4)) *
                                  std::cos(1.3 * (0.5 * row - 4)));
  }
  TriangleMesh mesh = make_height_field_mesh(field);
  // Of the sheet what does not look up is left out.
  if (is_sheet)
    std::erase_if(mesh.triangles, [&](const std::array<int, 3>& t) {
      const auto vertex = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
      return (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).z() <= 1e-12;
    });
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}

BodyShape shape_of(const Shape& shape) {
  BodyShape own{.shape = shape, .X_BS = Pose{}, .color = ""};
  own.radius = radius_about(shape, Vec3::Zero());
  return own;
}
ShapePath path_of(const BodyShape& shape, const Pose& X_WB, const Vec3& dp, const Vec3& dr) {
  return {
      &shape, X_WB, dp, dr, turning_radius(shape.shape, shape.X_BS, shape.radius), thickness_of(shape.shape)};
}
DistanceResult distance_at(const ShapePath& A, const ShapePath& B, double t) {
  const auto pose = [&](const ShapePath& path) {
    return TwistMotion(path.X_WB, path.dp_W, path.dr_W).sample(t).X_WB * path.shape->X_BS;
  };
  return signed_distance(A.shape->shape, pose(A), B.shape->shape, pose(B));
}

/// Whether the shapes are nowhere on the free part of their ways deeper than they may be. Of a mesh each
/// triangle counts alone: what lies in a hollow is deeper in the solid.
void expect_free(const ShapePath& A, const ShapePath& B, double part) {
  const double thickness[] = {A.thickness, B.thickness};
  const double thinner = std::min(thickness[0], thickness[1]) > 0 ? std::min(thickness[0], thickness[1])
                                                                  : std::max(thickness[0], thickness[1]);
  const double begin = distance_at(A, B, 0).distance;
  const double level = std::min(-kDeepShare * thinner, begin - 0.01 * thinner);
  const bool has_mesh =
      std::holds_alternative<Mesh>(A.shape->shape) || std::holds_alternative<Mesh>(B.shape->shape);
  const double least = (has_mesh ? 2 : 1) * level - 0.01 * thinner;
  for (int k = 0; k <= 40; ++k) EXPECT_GE(distance_at(A, B, part * k / 40).distance, least) << "at " << k;
}

TEST(FreePath, ConvexShapesAreNotDeeperThanTheyMayBe) {
  Draw draw(41), others(43);
  int whole = 0;
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(k);
    const BodyShape a = shape_of(draw.shape(k % 6)), b = shape_of(draw.shape(k / 6 % 6));
    const Pose X_WA{draw.rotation(), Vec3::Zero()};
    Pose X_WB{draw.rotation(), 2 * draw.direction()};
    const DistanceResult now = signed_distance(a.shape, X_WA, b.shape, X_WB);
    X_WB.p -= (now.distance - draw.uniform(-0.01, 0.05)) * now.n_W;
    const ShapePath A = path_of(a, X_WA, 0.1 * draw.direction(), draw.uniform(0, 1) * draw.direction()),
                    B = path_of(b, X_WB, draw.uniform(0, 0.5) * draw.direction(),
                                draw.uniform(0, 1) * draw.direction());
    const double part = free_path(A, B, kDeepShare).part;
    whole += part == 1 ? 1 : 0;
    expect_free(A, B, part);
    // Whatever direction is tried first, good or bad, saves time only.
    for (const Vec3& likely : {now.n_W, others.direction()}) {
      const double other = free_path(A, B, kDeepShare, likely).part;
      if (other == part) continue;
      EXPECT_EQ(other, 1);
      expect_free(A, B, other);
    }
    // Farther apart most never meet.
    ShapePath far = B;
    far.X_WB.p += others.uniform(0, 0.6) * now.n_W;
    expect_free(A, far, free_path(A, far, kDeepShare).part);
  }
  EXPECT_GT(whole, 300);
  EXPECT_LT(whole, 1000);
}

TEST(FreePath, BodiesOnHillsAreNotDeeperThanTheyMayBe) {
  Draw draw(42);
  int whole = 0;
  const BodyShape grounds[] = {shape_of(hills(0.1, false)), shape_of(hills(0.5, false)),
                               shape_of(hills(0.3, true))};
  for (int k = 0; k < 600; ++k) {
    SCOPED_TRACE(k);
    const BodyShape& ground = grounds[k % 3];
    const BodyShape b = shape_of(draw.shape(k / 3 % 6));
    Pose X_WB = draw.pose(2);
    X_WB.p.z() += 2.5;
    const double gap = draw.uniform(-0.005, 0.02);
    for (int step = 0; step < 15; ++step)
      X_WB.p.z() += gap - signed_distance(ground.shape, Pose{}, b.shape, X_WB).distance;
    const Vec3 dp = draw.uniform(0, 0.4) * Vec3(draw.direction().cwiseProduct(Vec3(1, 1, 0.3)));
    const ShapePath A = path_of(ground, Pose{},
                                k % 4 == 0 ? Vec3(0.05 * draw.direction()) : Vec3(Vec3::Zero()),
                                Vec3::Zero()),
                    B = path_of(b, X_WB, dp, draw.uniform(0, 0.5) * draw.direction());
    // The mesh may be either of them.
    const double part = k % 2 == 0 ? free_path(A, B, kDeepShare).part : free_path(B, A, kDeepShare).part;
    whole += part == 1 ? 1 : 0;
    expect_free(A, B, part);
  }
  EXPECT_GT(whole, 200);
  EXPECT_LT(whole, 600);
}

/// What slides over a flat sheet that it touches to rounding is not stopped.
TEST(FreePath, ASheetStopsNothingThatSlidesOverIt) {
  const BodyShape sheet = shape_of(make_mesh(std::make_shared<const TriangleMesh>(TriangleMesh{
      {Vec3(-4, -4, 0), Vec3(4, -4, 0), Vec3(4, 4, 0), Vec3(-4, 4, 0)}, {{0, 1, 2}, {0, 2, 3}}})));
  for (const Shape& shape :
       {Shape(Box{Vec3(0.3, 0.2, 0.1)}), Shape(Cylinder{0.2, 0.1}), Shape(Sphere{0.1})}) {
    const BodyShape own = shape_of(shape);
    const ShapePath A = path_of(sheet, Pose{}, Vec3::Zero(), Vec3::Zero()),
                    B = path_of(own, {Mat3::Identity(), Vec3(0.1, 0.2, 0.1 - 1e-9)}, Vec3(0.5, 0.2, -1e-5),
                                Vec3::Zero());
    EXPECT_EQ(free_path(A, B, kDeepShare).part, 1) << shape_type_name(shape);
    // Downwards it goes as far as it may.
    const ShapePath down = path_of(own, B.X_WB, Vec3(0, 0, -1), Vec3::Zero());
    EXPECT_NEAR(free_path(A, down, kDeepShare).part, kDeepShare * B.thickness, 2e-3)
        << shape_type_name(shape);
  }
}

}  // namespace
}  // namespace rigor::free_path_test
